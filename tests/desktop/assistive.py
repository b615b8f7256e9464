"""The desktop program as assistive technology meets it on Linux: through AT-SPI, by role and name.

Usage: dbus-run-session -- python3 assistive.py PROGRAM
Needs Xvfb, at-spi2-core and the GObject bindings of Atspi. Everything is started anew and ends with this script.
"""

import os
import subprocess
import sys
import tempfile
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, Gio, GLib  # noqa: E402

PATIENCE_S = 30
ENTRY = {"entry", "text", "spin button"}
BUTTON = {"push button", "button", "link"}


def start_screen():
    """An X server without a screen, for this process and those that it starts."""
    read, write = os.pipe()
    screen = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x1000x24", "-nolisten", "tcp"], pass_fds=[write])
    os.close(write)
    with os.fdopen(read) as number:
        os.environ["DISPLAY"] = ":" + number.readline().strip()
    return screen


def announce_screen_reader():
    """Tells the desktop that there is a screen reader: programs say nothing to nobody."""
    bus = Gio.bus_get_sync(Gio.BusType.SESSION)
    for name in ("IsEnabled", "ScreenReaderEnabled"):
        value = GLib.Variant("(ssv)", ("org.a11y.Status", name, GLib.Variant("b", True)))
        bus.call_sync("org.a11y.Bus", "/org/a11y/bus", "org.freedesktop.DBus.Properties", "Set", value, None, Gio.DBusCallFlags.NONE, 10_000, None)


def walk(one):
    """`one` and everything below it, in reading order."""
    yield one
    for index in range(one.get_child_count()):
        child = one.get_child_at_index(index)
        if child is not None:
            yield from walk(child)


def everything():
    """(object, role, name) of all that the programs of this desktop tell."""
    found = []
    try:
        for one in walk(Atspi.get_desktop(0)):
            found.append((one, one.get_role_name(), one.get_name() or ""))
    except GLib.Error:
        # Something went away while it was looked at.
        pass
    return found


def until(what, look):
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        seen = look()
        if seen:
            return seen
        time.sleep(0.2)
    told = "\n".join(f"  {role}: {name}" for _, role, name in everything())
    raise SystemExit(f"Waited {PATIENCE_S} s in vain: {what}. What is told:\n{told}")


def find(name, roles):
    return until(f"{name} ({', '.join(sorted(roles))})", lambda: next((one for one, role, said in everything() if said == name and role in roles), None))


def says(words):
    return until(f'"{words}" said', lambda: any(words in name for _, _, name in everything()))


def press(name, roles=frozenset(BUTTON)):
    if not find(name, roles).do_action(0):
        raise SystemExit(f"{name} cannot be pressed.")


def write(name, text):
    field = find(name, ENTRY)
    if not Atspi.EditableText.set_text_contents(field, text):
        raise SystemExit(f"{name} cannot be written into.")
    until(f"{text} in {name}", lambda: Atspi.Text.get_text(find(name, ENTRY), 0, -1) == text)


def use():
    says("Depth Calculator")
    find("Depth Calculator", {"heading"})
    for name, text in [("Focal length (fx)", "700"), ("Camera baseline (b)", "100"), ("Disparity (d)", "50")]:
        write(name, text)
    says("1.400 m")
    write("Disparity (d)", "100")
    says("0.7000 m")
    write("Disparity (d)", "none")
    says("⚠")
    press("Doorway (monocular)")
    says("4.275 m")
    find("Stereo against monocular", {"image"})
    press("Learn", {"page tab"})
    find("What this computes", {"heading"})


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as home:
        os.environ.update({"HOME": home, "XDG_DATA_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1"})
        started = [start_screen()]
        try:
            announce_screen_reader()
            started.append(subprocess.Popen([program]))
            Atspi.init()
            use()
            if started[-1].poll() is not None:
                raise SystemExit("The program has ended.")
        finally:
            for process in reversed(started):
                process.terminate()
                process.wait(10)
    print("Assistive technology finds, fills in, presses and reads the desktop program.")


main()
