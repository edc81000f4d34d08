"""Two pictures of one solid: where do their silhouettes differ?"""
import re

import png


def of_openscad(path):
    """Rows of booleans: what is not background. The picture's corner is background."""
    width, _, channels, rows = png.read(path)
    paper = bytes(rows[0][:channels])
    return [[bytes(row[x * channels:(x + 1) * channels]) != paper for x in range(width)]
            for row in rows]


# OpenSCAD shows what lies at a pixel's middle, we draw areas: the middle one of so many cells each way stands for it.
FINER = 3

# A cell that a body of density 1 covers by half has the linear reflectance 0.5: 188 in sRGB.
_HALF_COVERED = 188


def _read_pgm(path):
    """(width, height, pixels)."""
    with open(path, "rb") as file:
        kind, width, height, most, pixels = re.match(rb"(P5)\s+(\d+)\s+(\d+)\s+(\d+)\s(.*)", file.read(), re.DOTALL).groups()
    assert kind == b"P5" and most == b"255", path
    return int(width), int(height), pixels


def of_ours(path):
    """Rows of booleans from a PGM, FINER times as large and drawn with --density 0,1."""
    width, height, pixels = _read_pgm(path)
    middle = FINER // 2
    return [[v <= _HALF_COVERED for v in pixels[y * width + middle:(y + 1) * width:FINER]]
            for y in range(middle, height, FINER)]


def is_blank(path):
    """Nothing is drawn in a PGM."""
    _, _, pixels = _read_pgm(path)
    return pixels.count(255) == len(pixels)


def near_edge(mask, x, y):
    """Both kinds of pixels are within one pixel."""
    around = {mask[v][u] for v in range(max(y - 1, 0), min(y + 2, len(mask)))
              for u in range(max(x - 1, 0), min(x + 2, len(mask[0])))}
    return len(around) == 2


def difference(theirs, ours):
    """(pixels of the solid, differing ones, those of them farther than a pixel from an edge)."""
    solid = sum(sum(row) for row in theirs)
    wrong = [(x, y) for y, row in enumerate(theirs) for x, inside in enumerate(row)
             if inside != ours[y][x]]
    return solid, len(wrong), sum(not near_edge(theirs, x, y) for x, y in wrong)
