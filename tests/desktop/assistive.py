"""The desktop program as assistive technology meets it on Linux: through AT-SPI, by role and name.

Usage: python3 assistive.py PROGRAM
Needs Xvfb, dbus-run-session, at-spi2-core and the GObject bindings of Atspi. Everything is started anew and ends with this script.
Nothing is read from or written into the folders and settings of whoever runs it, and no window opens on their screen: the script
runs itself again inside a D-Bus session whose services know only a folder and a screen of their own.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, Gio, GLib  # noqa: E402

# Only a program that hangs takes so long, however much else the machine does.
PATIENCE_S = 120
ATTEMPTS = 2
ENTRY = {"entry", "text", "spin button"}
BUTTON = {"push button", "button", "link"}


class Screen:
    """An X server without glass, started anew once if it ends at once."""

    def __init__(self):
        for attempt in range(ATTEMPTS):
            read, write = os.pipe()
            # Without -noreset it starts anew whenever its last client leaves, and refuses who comes just then.
            command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x1000x24", "-nolisten", "tcp", "-noreset"]
            self.process = subprocess.Popen(command, pass_fds=[write])
            os.close(write)
            with os.fdopen(read) as number:
                self.display = number.readline().strip()
            if self.display:
                return
            print(f"Xvfb ended at once with exit code {self.process.wait()} (attempt {attempt + 1} of {ATTEMPTS}).", file=sys.stderr)
        raise SystemExit("Xvfb does not start.")


def own_environment(home, display):
    """The environment without the desktop and the folders of whoever runs this."""
    other = ("WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DBUS_SESSION_BUS_ADDRESS", "AT_SPI_BUS_ADDRESS")
    environment = {name: value for name, value in os.environ.items() if name not in other}
    for name in ("CONFIG", "DATA", "CACHE", "STATE"):
        environment[f"XDG_{name}_HOME"] = str(Path(home, name.lower()))
    # Settings of the desktop, such as that there is a screen reader, are not stored at all.
    return environment | {
        "HOME": home,
        "DISPLAY": f":{display}",
        "GSETTINGS_BACKEND": "memory",
        "XDG_SESSION_TYPE": "x11",
        "LIBGL_ALWAYS_SOFTWARE": "1",
    }


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


def everything(process):
    """(object, role, name) of all that this process tells."""
    found = []
    try:
        desktop = Atspi.get_desktop(0)
        programs = [desktop.get_child_at_index(index) for index in range(desktop.get_child_count())]
        for program in programs:
            if program is not None and program.get_process_id() == process:
                found += [(one, one.get_role_name(), one.get_name() or "") for one in walk(program)]
    except GLib.Error:
        # Something went away while it was looked at.
        pass
    return found


class Program:
    """The program under test. Whatever is waited for, it must be running."""

    def __init__(self, path, errors, home):
        self.errors = errors
        # It finds no other program: where zenity is installed, a failure would wait in a box that nobody closes.
        nowhere = str(Path(home, "nowhere"))
        self.process = subprocess.Popen([path], stderr=errors, env=os.environ | {"PATH": nowhere})

    def check(self):
        code = self.process.poll()
        if code is not None:
            self.errors.seek(0)
            raise SystemExit(f"The program ended with exit code {code}. It said:\n{self.errors.read()}")

    def everything(self):
        return everything(self.process.pid)

    def until(self, what, look):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            self.check()
            seen = look()
            if seen:
                return seen
            time.sleep(0.2)
        told = "\n".join(f"  {role}: {name}" for _, role, name in self.everything())
        raise SystemExit(f"Waited {PATIENCE_S} s in vain: {what}. What is told:\n{told}")

    def find(self, name, roles):
        return self.until(f"{name} ({', '.join(sorted(roles))})", lambda: next((one for one, role, said in self.everything() if said == name and role in roles), None))

    def says(self, words):
        return self.until(f'"{words}" said', lambda: any(words in name for _, _, name in self.everything()))

    def press(self, name, roles=frozenset(BUTTON)):
        if not self.find(name, roles).do_action(0):
            raise SystemExit(f"{name} cannot be pressed.")

    def value(self, name):
        return Atspi.Text.get_text(self.find(name, ENTRY), 0, -1)

    def write(self, name, text):
        field = self.find(name, ENTRY)
        if not Atspi.EditableText.set_text_contents(field, text):
            raise SystemExit(f"{name} cannot be written into.")
        self.until(f"{text} in {name}", lambda: self.value(name) == text)


def use(program, home):
    program.says("Depth Calculator")
    program.find("Depth Calculator", {"heading"})
    for name, text in [("Focal length (fx)", "700"), ("Camera baseline (b)", "100"), ("Disparity (d)", "50")]:
        program.write(name, text)
    program.says("1.400 m")
    program.write("Disparity (d)", "100")
    program.says("0.7000 m")
    program.write("Disparity (d)", "none")
    program.says("is not a number")
    program.press("Doorway (monocular)")
    program.says("4.275 m")
    program.find("Stereo against monocular", {"image"})
    program.press("Learn", {"page tab"})
    program.find("What this computes", {"heading"})
    stored(program, home, "state-v1.json", "950")


def stored(program, home, name, number):
    """Waits until the file of a window has this number."""
    file = Path(home, "config", "depth-calculator", name)
    program.until(f"{number} in {file}", lambda: file.is_file() and f'"{number}"' in file.read_text(encoding="utf-8"))


def use_second_window(second, home):
    """It starts with what the first has stored, and keeps what is written to itself."""
    second.press("Calculator", {"page tab"})
    second.says("4.275 m")
    second.write("Focal length (fx)", "1900")
    stored(second, home, "state-v1-2.json", "1900")
    stored(second, home, "state-v1.json", "950")


def use_first_window_again(first, home):
    """Only now: a window that another covers is not drawn."""
    first.press("Calculator", {"page tab"})
    if first.value("Focal length (fx)") != "950":
        raise SystemExit("The second window has changed the first.")
    first.write("Focal length (fx)", "475")
    stored(first, home, "state-v1.json", "475")
    stored(first, home, "state-v1-2.json", "1900")


def end(process):
    """Ends a process, whatever it is doing."""
    process.terminate()
    try:
        process.wait(PATIENCE_S)
    except subprocess.TimeoutExpired:
        process.kill()


def inside_session(path, home):
    """The test, in a D-Bus session of its own."""
    with tempfile.TemporaryFile("w+", encoding="utf-8") as errors:
        announce_screen_reader()
        program = Program(path, errors, home)
        try:
            Atspi.init()
            use(program, home)
            second = Program(path, errors, home)
            try:
                use_second_window(second, home)
            finally:
                end(second.process)
            use_first_window_again(program, home)
            program.check()
        finally:
            end(program.process)
    print("Assistive technology finds, fills in, presses and reads the desktop program.")


def main():
    path, *home = sys.argv[1:]
    if home:
        inside_session(path, home[0])
        return
    with tempfile.TemporaryDirectory() as folder:
        screen = Screen()
        try:
            session = ["dbus-run-session", "--", sys.executable, "-W", "ignore", __file__, path, folder]
            code = subprocess.run(session, env=own_environment(folder, screen.display), check=False).returncode
        finally:
            end(screen.process)
    sys.exit(code)


main()
