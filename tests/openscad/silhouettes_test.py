"""The comparison itself: that it finds what it should."""
import os
import struct
import tempfile
import unittest
import zlib

import png
import silhouettes


def disc(radius, centre=(20, 20), size=40):
    return [[(x - centre[0]) ** 2 + (y - centre[1]) ** 2 < radius ** 2 for x in range(size)]
            for y in range(size)]


def filtered(kind, row, above, step):
    """The inverse of what png.py undoes, by its definition."""
    out = bytearray()
    for i, value in enumerate(row):
        left, up = (row[i - step] if i >= step else 0), above[i]
        corner = above[i - step] if i >= step else 0
        by = {p: abs(left + up - corner - p) for p in (corner, up, left)}
        nearest = min((left, up, corner), key=lambda p: by[p])
        out.append((value - (0, left, up, (left + up) // 2, nearest)[kind]) & 255)
    return out


class Silhouettes(unittest.TestCase):
    def test_equal_ones_do_not_differ(self):
        self.assertEqual(silhouettes.difference(disc(10), disc(10))[1:], (0, 0))

    def test_a_shift_by_a_pixel_is_near_the_edge(self):
        _, wrong, far = silhouettes.difference(disc(10), disc(10, (21, 20)))
        self.assertGreater(wrong, 20)
        self.assertEqual(far, 0)

    def test_a_hole_is_far_from_the_edge(self):
        ours = disc(10)
        ours[20][20] = False
        self.assertEqual(silhouettes.difference(disc(10), ours)[1:], (1, 1))

    def test_the_middle_of_our_cells_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.pgm")
            cells = bytearray(b"\xff" * 36)
            cells[1 * 6 + 4] = 188  # the middle of the second pixel of the first row
            cells[5 * 6 + 5] = 0    # a corner of the last
            with open(path, "wb") as file:
                file.write(b"P5\n6 6\n255\n" + cells)
            self.assertEqual(silhouettes.of_ours(path), [[False, True], [False, False]])

    def test_one_drawn_cell_is_not_blank(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.pgm")
            for cells, blank in ((b"\xff" * 6, True), (b"\xff" * 5 + b"\xfe", False)):
                with open(path, "wb") as file:
                    file.write(b"P5\n3 2\n255\n" + cells)
                self.assertEqual(silhouettes.is_blank(path), blank)

    def test_png_filters_are_undone(self):
        rows = [bytes((7 * x * y + 3 * x + y) % 256 for x in range(12)) for y in range(5)]
        above, packed = bytes(12), b""
        for kind, row in enumerate(rows):
            packed += bytes([kind]) + filtered(kind, row, above, 3)
            above = row
        chunks = [(b"IHDR", struct.pack(">IIBBBBB", 4, 5, 8, 2, 0, 0, 0)),
                  (b"IDAT", zlib.compress(packed)), (b"IEND", b"")]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.png")
            with open(path, "wb") as file:
                file.write(b"\x89PNG\r\n\x1a\n")
                for kind, body in chunks:
                    file.write(struct.pack(">I", len(body)) + kind + body +
                               struct.pack(">I", zlib.crc32(kind + body)))
            self.assertEqual([bytes(row) for row in png.read(path)[3]], rows)


if __name__ == "__main__":
    unittest.main()
