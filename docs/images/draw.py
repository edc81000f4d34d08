"""Draws the pictures of the README: one a device, of the hospital, with the command itself.

usage: draw.py OVERSTRIKE OUTPUT_FOLDER
"""

import re
import struct
import subprocess
import sys
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "scenes/nn74-e-hospital.yaml"
COLUMNS, LINES = 78, 24
DOT = 6  # pixels a half block is wide and high


def grey(code):
    """Of the 256 colours: 232 to 255 are greys from 8 in steps of 10, 231 is white, 16 black."""
    if code >= 232:
        return 8 + 10 * (code - 232)
    return 255 if code == 231 else 0


def half_blocks(text):
    """Rows of greys, two a line: each half block shows its foreground above its background."""
    for line in text.splitlines():
        upper, lower = [], []
        fore = back = 255
        for kind, code, character in re.findall(r"\x1b\[(?:(38|48);5;(\d+)|0)m|([^\x1b])", line):
            if kind == "38":
                fore = grey(int(code))
            elif kind == "48":
                back = grey(int(code))
            elif character:
                upper.append(fore if character == "▀" else back)
                lower.append(back)
        yield upper
        yield lower


def chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def grey_png(rows):
    """A PNG of 8-bit grey rows, each value a square of DOT pixels."""
    wide = [bytes(value for value in row for _ in range(DOT)) for row in rows]
    header = struct.pack(">IIBBBBB", len(wide[0]), len(wide) * DOT, 8, 0, 0, 0, 0)
    data = zlib.compress(b"".join((b"\0" + row) * DOT for row in wide), 9)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) +
            chunk(b"IEND", b""))


def main(overstrike, folder):
    def run(*words):
        return subprocess.run([overstrike, *map(str, words)], check=True, capture_output=True).stdout

    folder = Path(folder)
    page, sheet = folder / "page.txt", folder / "sheet.hpgl"
    run("render", SCENE, "-o", page, "--size", "130x64", "--lpi", 8)
    run("emulate", "line-printer", page, "-o", folder / "hospital.page.png", "--lpi", 8, "--dpi", 64)
    run("render", SCENE, "-o", sheet)
    run("emulate", "plotter", sheet, "-o", folder / "hospital.sheet.png", "--dpi", 80)
    run("render", SCENE, "-o", folder / "hospital.png", "--size", "800x520")
    shown = run("render", SCENE, "-d", "terminal", "--size", f"{COLUMNS}x{LINES}", "--set",
                "blocks=half", "--set", "color=256").decode()
    (folder / "hospital.terminal.png").write_bytes(grey_png(list(half_blocks(shown))))
    page.unlink()
    sheet.unlink()


if __name__ == "__main__":
    main(*sys.argv[1:])
