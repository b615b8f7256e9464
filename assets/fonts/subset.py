#!/usr/bin/env python3
"""Make the three fonts of the program from their published sources.

    Inter-Regular.ttf    Inter 400, body text
    Inter-SemiBold.ttf   Inter 600, headings and results
    Symbols.ttf          the few signs that Inter lacks, from DejaVu Sans

Inter-Regular followed by Symbols covers every character in `REQUIRED`, and
Inter-SemiBold those in `STRONG`, behind which the program puts the other two;
the script fails when they would not, and when figures would not align.

Inputs, both from the npm registry:

    npm pack inter-ui@4.1.1 && tar xzf inter-ui-4.1.1.tgz
    npm pack dejavu-fonts-ttf@2.37.3 && tar xzf dejavu-fonts-ttf-2.37.3.tgz

(each unpacks to a folder `package`: unpack them into two folders of one input
folder). Tools, from PyPI: fonttools==4.68.0, brotli, uharfbuzz. Then

    python3 subset.py INPUT_FOLDER [OUTPUT_FOLDER]

Inputs are found by file name anywhere below INPUT_FOLDER; OUTPUT_FOLDER is
this file's folder unless given. The same inputs give the same bytes.

What is changed, and why:

* Figures are Inter's tabular ones, so columns of numbers align, and no kerning
  touches a figure or a mark that stands inside a number.
* Operators (+ − ± × ÷ = ≠ ≈ < > ≤ ≥ ~) are Inter's figure-height, figure-width
  ones. Elsewhere Inter switches to them in context; here they nearly always
  stand beside a figure or a capital, and a fixed choice needs no substitution.
* Of the layout features only kerning stays; hinting, glyph names and all but
  the identifying and legal name records go.
* Symbols takes Inter's line metrics, so a line does not grow when it falls back.

Whoever ships the fonts ships OFL.txt (Inter) and DejaVu-LICENSE.txt (Symbols),
both copied unchanged from the packages above.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import brotli
import uharfbuzz as hb
from fontTools import subset
from fontTools.misc.timeTools import timestampFromString
from fontTools.pens.cu2quPen import Cu2QuPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont

# Printable ASCII, printable Latin-1 (with the no-break space), and the signs
# that the texts, the results, the plots and the shortcuts use.
REQUIRED = {chr(c) for c in (*range(0x20, 0x7F), *range(0xA0, 0x100))} | set(
    "–—−…·•±×÷°′″"
    "²³¹⁰⁴⁵⁶⁷⁸⁹⁻₀₁₂₃"
    "√∛≈≠≤≥∞∝∂"
    "µμαβγδΔεθλπρσΣτφψωΩ"
    "→←↑↓↔⟶"
    "✓✗⚠ⓘ▾▸▴◂●○◐☰"
    "“”‘’„‹›«»€№†‡§¶"
    "⌘⇧⌥⌃⏎⎋⌫"
    "⏴⏵⏶⏷"  # egui: arrow keys in shortcuts, the arrow of a submenu
    "\u2007\u2009\u202f"  # figure space, thin space, narrow no-break space
    "\ufffd"  # shown for what cannot be decoded
)

# What headings, names of fields and results are written in. Anything else, such
# as an accent that somebody types, falls back to Inter-Regular.
STRONG = {chr(c) for c in range(0x20, 0x7F)} | set(
    "–—−…·±×÷°′″²³√≈≠≤≥→←↑↓“”‘’µμαδθσφΔ\u00a0\u2007\u2009\u202f"
)

# Shapes that must match each other in size come from one font even where Inter
# has some of them.
ONE_FAMILY = set("▾▸▴◂●○◐")

# Neither font has these; the second is the nearest shape in DejaVu Sans.
ALIASES = {"⏴": "◀", "⏵": "▶", "⏶": "▲", "⏷": "▼"}

# Neither font has it; drawn by `info_sign`.
DRAWN = {"ⓘ"}

FIGURES = "0123456789"
OPERATORS = "+−±×÷=≠≈<>≤≥~"
# No kerning with these: a number's width must depend on its length alone.
NUMBER_MARKS = ".,:-\u00a0\u2007\u2009\u202f "

KEPT_NAMES = [0, 1, 2, 3, 4, 5, 6, 7, 13, 14]
EPOCH = timestampFromString("Wed Jan  1 00:00:00 2025")


def options() -> subset.Options:
    chosen = subset.Options()
    chosen.layout_features = ["kern"]
    chosen.hinting = False
    chosen.glyph_names = False
    chosen.legacy_kern = False
    chosen.notdef_outline = True
    chosen.name_IDs = KEPT_NAMES
    chosen.name_languages = [0x0409]
    chosen.drop_tables += ["MATH", "FFTM", "GSUB", "gasp", "DSIG", "meta"]
    chosen.recalc_timestamp = False
    return chosen


def cut(font: TTFont, characters: set[str]) -> None:
    """Keep only the glyphs of `characters`, and kerning among them."""
    subsetter = subset.Subsetter(options())
    subsetter.populate(unicodes=[ord(c) for c in characters])
    subsetter.subset(font)


def save(font: TTFont, path: Path) -> None:
    font.flavor = None
    font.recalcTimestamp = False
    font["head"].modified = EPOCH
    font.save(path)


def freeze_number_forms(font: TTFont) -> None:
    """Point figures at their tabular glyphs, operators at the tall tabular ones."""
    glyphs = font.getReverseGlyphMap()
    names = font.getBestCmap()
    for character in FIGURES + OPERATORS:
        suffix = ".tf" if character in FIGURES else ".case.tf"
        new = names[ord(character)] + suffix
        if new not in glyphs:
            raise SystemExit(f"Inter has no glyph {new}")
        for table in font["cmap"].tables:
            if ord(character) in table.cmap:
                table.cmap[ord(character)] = new


def drop_kerning_in_numbers(font: TTFont) -> None:
    """Zero every kerning pair whose two sides can both stand in a number."""
    names = font.getBestCmap()
    inside = {names[ord(c)] for c in FIGURES + OPERATORS + NUMBER_MARKS if ord(c) in names}
    for lookup in font["GPOS"].table.LookupList.Lookup:
        for sub in lookup.SubTable:
            sub = getattr(sub, "ExtSubTable", sub)
            if sub.LookupType != 2:
                continue
            if sub.Format == 1:
                for first, pairs in zip(sub.Coverage.glyphs, sub.PairSet, strict=True):
                    if first in inside:
                        pairs.PairValueRecord = [
                            r for r in pairs.PairValueRecord if r.SecondGlyph not in inside
                        ]
                        pairs.PairValueCount = len(pairs.PairValueRecord)
            else:
                # A glyph left out of a class table of second glyphs is in class
                # 0, one left out of the coverage is not looked at: figures thus
                # lose class kerning as first glyphs altogether.
                gone = inside & set(sub.Coverage.glyphs)
                sub.Coverage.glyphs = [g for g in sub.Coverage.glyphs if g not in gone]
                for glyph in gone:
                    sub.ClassDef1.classDefs.pop(glyph, None)


def tidy_names(font: TTFont, family: str, style: str) -> None:
    """Name the face for what it is."""
    table = font["name"]
    table.names = [n for n in table.names if n.platformID == 3]
    for name_id, text in {
        1: family if style == "Regular" else f"{family} {style}",
        2: "Regular",
        4: f"{family} {style}",
        6: f"{family}-{style}".replace(" ", ""),
    }.items():
        table.setName(text, name_id, 3, 1, 0x0409)


def info_sign(font: TTFont) -> None:
    """Add ⓘ: a ring around an i, in the stroke weight of Inter's text."""
    upem = font["head"].unitsPerEm
    advance, radius, stroke = 0.88 * upem, 0.39 * upem, 0.066 * upem
    cx, cy = advance / 2, 0.364 * upem  # the middle of the capitals
    target = TTGlyphPen(None)
    pen = Cu2QuPen(target, max_err=1.0, reverse_direction=False)

    def circle(x: float, y: float, r: float, clockwise: bool) -> None:
        k = 4 / 3 * (math.sqrt(2) - 1) * r
        turn = -1 if clockwise else 1
        pen.moveTo((x + r, y))
        pen.curveTo((x + r, y + turn * k), (x + k, y + turn * r), (x, y + turn * r))
        pen.curveTo((x - k, y + turn * r), (x - r, y + turn * k), (x - r, y))
        pen.curveTo((x - r, y - turn * k), (x - k, y - turn * r), (x, y - turn * r))
        pen.curveTo((x + k, y - turn * r), (x + r, y - turn * k), (x + r, y))
        pen.closePath()

    circle(cx, cy, radius, clockwise=True)
    circle(cx, cy, radius - stroke, clockwise=False)
    circle(cx, cy + 0.165 * upem, 0.058 * upem, clockwise=True)
    half, bottom, top = 0.046 * upem, cy - 0.2 * upem, cy + 0.07 * upem
    pen.moveTo((cx - half, bottom))
    pen.lineTo((cx - half, top))
    pen.lineTo((cx + half, top))
    pen.lineTo((cx + half, bottom))
    pen.closePath()

    name = "uni24D8"
    glyph = target.glyph()
    font.setGlyphOrder([*font.getGlyphOrder(), name])
    font["glyf"][name] = glyph
    glyph.recalcBounds(font["glyf"])
    font["hmtx"][name] = (round(advance), glyph.xMin)
    for table in font["cmap"].tables:
        if table.isUnicode() and table.format in (4, 12):
            table.cmap[ord("ⓘ")] = name


def find(folder: Path, name: str) -> Path:
    # Packages may hold the same name for other weights of use; the shallowest
    # path, then the first by name, is the plain one.
    found = sorted(folder.rglob(name), key=lambda p: (len(p.parts), p.as_posix()))
    if not found:
        raise SystemExit(f"{name} is nowhere below {folder}")
    return found[0]


def make_inter(source: Path, target: Path, style: str, characters: set[str]) -> None:
    font = TTFont(source, recalcTimestamp=False)
    freeze_number_forms(font)
    cut(font, characters)
    drop_kerning_in_numbers(font)
    tidy_names(font, "Inter", style)
    save(font, target)


def make_symbols(source: Path, inter: TTFont, target: Path, characters: set[str]) -> None:
    font = TTFont(source, recalcTimestamp=False)
    if font["head"].unitsPerEm != inter["head"].unitsPerEm:
        raise SystemExit("the line metrics can be copied only at the same scale")
    names = font.getBestCmap()
    for table in font["cmap"].tables:
        if table.isUnicode() and table.format in (4, 12):
            for missing, like in ALIASES.items():
                table.cmap[ord(missing)] = names[ord(like)]
    cut(font, characters - DRAWN)
    if "GPOS" in font:
        del font["GPOS"]
    if "GDEF" in font:
        del font["GDEF"]
    info_sign(font)
    for field in ("ascent", "descent", "lineGap"):
        setattr(font["hhea"], field, getattr(inter["hhea"], field))
    for field in ("sTypoAscender", "sTypoDescender", "sTypoLineGap", "usWinAscent", "usWinDescent"):
        setattr(font["OS/2"], field, getattr(inter["OS/2"], field))
    tidy_names(font, "Depth Calculator Symbols", "Regular")
    font["name"].setName("Depth Calculator Symbols", 3, 3, 1, 0x0409)
    # DejaVu carries its whole licence here, ten times the size of our outlines.
    font["name"].setName("See DejaVu-LICENSE.txt, shipped beside this font.", 13, 3, 1, 0x0409)
    save(font, target)


def advances(path: Path, text: str) -> list[int]:
    face = hb.Font(hb.Face(hb.Blob.from_file_path(str(path))))
    buffer = hb.Buffer()
    buffer.add_str(text)
    buffer.guess_segment_properties()
    hb.shape(face, buffer)
    return [p.x_advance for p in buffer.glyph_positions]


def check(folder: Path) -> None:
    """Fail unless both chains cover `REQUIRED` and numbers of one form align."""
    symbols = set(TTFont(folder / "Symbols.ttf").getBestCmap())
    for style in ("Regular", "SemiBold"):
        path = folder / f"Inter-{style}.ttf"
        wanted = REQUIRED if style == "Regular" else STRONG
        missing = {ord(c) for c in wanted} - set(TTFont(path).getBestCmap()) - symbols
        if missing:
            raise SystemExit(f"{path.name}: missing {' '.join(f'U+{c:04X}' for c in missing)}")
        width = advances(path, "0")[0]
        for operator in OPERATORS:
            if advances(path, operator) != [width]:
                raise SystemExit(f"{path.name}: {operator} is not as wide as a figure")
        for mark in NUMBER_MARKS:
            form = advances(path, f"0{mark}0")
            for a in FIGURES:
                for b in FIGURES:
                    if advances(path, f"{a}{mark}{b}") != form:
                        raise SystemExit(f"{path.name}: {a}{mark}{b} is not as wide as 0{mark}0")
        for a in FIGURES + OPERATORS:
            for b in FIGURES + OPERATORS:
                if advances(path, a + b) != [width, width]:
                    raise SystemExit(f"{path.name}: {a}{b} is kerned")
        if sum(advances(path, "AV")) >= sum(advances(path, "A") + advances(path, "V")):
            raise SystemExit(f"{path.name}: text is not kerned")


def main() -> None:
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    inputs = Path(sys.argv[1])
    outputs = Path(sys.argv[2]) if len(sys.argv) == 3 else Path(__file__).parent
    faces = {style: find(inputs, f"Inter-{style}.woff2") for style in ("Regular", "SemiBold")}

    covered = set(map(chr, set.intersection(*(set(TTFont(p).getBestCmap()) for p in faces.values()))))
    inter_part = (REQUIRED & covered) - ONE_FAMILY
    for style, source in faces.items():
        part = inter_part if style == "Regular" else inter_part & STRONG
        make_inter(source, outputs / f"Inter-{style}.ttf", style, part)
    make_symbols(
        find(inputs, "DejaVuSans.ttf"),
        TTFont(outputs / "Inter-Regular.ttf"),
        outputs / "Symbols.ttf",
        REQUIRED - inter_part,
    )
    check(outputs)

    for name in ("Inter-Regular.ttf", "Inter-SemiBold.ttf", "Symbols.ttf"):
        data = (outputs / name).read_bytes()
        count = len(TTFont(outputs / name).getBestCmap())
        print(f"{name}: {count} characters, {len(data)} bytes, {len(brotli.compress(data))} brotli")


if __name__ == "__main__":
    main()
