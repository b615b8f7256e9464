#!/usr/bin/env python3
"""Render the PNG and ICO icons of the program from the SVG files beside this script.

    python3 render.py

icon.svg is the mark, favicon.svg the same with fewer parts for 16 and 32 px,
og.svg the social card (1200 × 630). Needs, from Debian: librsvg2-bin for
rsvg-convert, zopfli for zopflipng and icoutils for icotool; and the fonts in
../fonts, which alone are offered to the card, so that it looks the same wherever it is made.

Two shapes of the mark are derived here:

* maskable: the tile fills the whole square, and the mark is scaled until all
  of it lies in the circle of 80 % of the width that every mask must leave;
* Apple's touch icon: the tile fills the square, which the system rounds itself
  and paints black wherever it is transparent.
"""

from __future__ import annotations

import os
import re
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
# The lenses reach 236 units (of 512) from the centre of icon.svg; 204.8 are allowed.
MASKABLE_SCALE = 0.86


def run(*command: str | Path, **settings: object) -> None:
    subprocess.run([str(part) for part in command], check=True, stdout=subprocess.DEVNULL, **settings)


def full_bleed(svg: str, scale: float) -> str:
    """`svg` with a square tile, and its mark scaled about the centre."""
    svg, tiles = re.subn(r'(<rect id="tile"[^>]*?) rx="\d+"', r"\1", svg)
    move = f"translate(256 256) scale({scale}) translate(-256 -256)"
    svg, marks = re.subn(r'<g id="mark"', f'<g id="mark" transform="{move}"', svg)
    if (tiles, marks) != (1, 1):
        raise SystemExit("icon.svg must hold one tile and one mark")
    return svg


def render(source: Path, target: str, width: int, fonts: Path, scratch: Path) -> None:
    raw = scratch / "raw.png"
    environment = {**os.environ, "FONTCONFIG_FILE": str(fonts)}
    run("rsvg-convert", "--width", str(width), "--output", raw, source, env=environment)
    run("zopflipng", "-y", "--lossy_transparent", raw, HERE / target)
    print(f"{target}: {(HERE / target).stat().st_size} bytes")


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        fonts = scratch / "fonts.conf"
        fonts.write_text(
            '<?xml version="1.0"?><!DOCTYPE fontconfig SYSTEM "fonts.dtd"><fontconfig>'
            f"<dir>{HERE.parent / 'fonts'}</dir><cachedir>{scratch / 'cache'}</cachedir></fontconfig>"
        )
        icon = (HERE / "icon.svg").read_text()
        maskable, apple = scratch / "maskable.svg", scratch / "apple.svg"
        maskable.write_text(full_bleed(icon, MASKABLE_SCALE))
        apple.write_text(full_bleed(icon, 1.0))

        for source, target, width in (
            (HERE / "favicon.svg", "favicon-32.png", 32),
            (HERE / "icon.svg", "icon-192.png", 192),
            (HERE / "icon.svg", "icon-256.png", 256),
            (HERE / "icon.svg", "icon-512.png", 512),
            (maskable, "maskable-192.png", 192),
            (maskable, "maskable-512.png", 512),
            (apple, "apple-touch-icon.png", 180),
            (HERE / "og.svg", "og.png", 1200),
        ):
            render(source, target, width, fonts, scratch)

        # For Windows: small where it lists files, large where it shows them.
        sizes = [(HERE / "favicon.svg", 16), (HERE / "favicon.svg", 32), (HERE / "icon.svg", 48)]
        pictures = []
        for source, width in sizes:
            pictures.append(scratch / f"{width}.png")
            run("rsvg-convert", "--width", str(width), "--output", pictures[-1], source)
        # The largest stays a PNG, as Windows has it since Vista.
        run("icotool", "--create", "--output", HERE / "icon.ico", *pictures, "--raw", HERE / "icon-256.png")
        print(f"icon.ico: {(HERE / 'icon.ico').stat().st_size} bytes")


if __name__ == "__main__":
    main()
