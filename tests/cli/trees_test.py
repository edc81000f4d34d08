"""Deep and large Boolean trees, from the text of a file to a page: by the work counted, not by the clock."""

import json
import unittest

from harness import CommandTest, overstrike

HEAD = "camera: {azimuth: -50, elevation: 50, projection: parallel}\nbodies:\n  - "


def box(low, size):
    x, y, z = (low[0] + size[0] / 2, low[1] + size[1] / 2, low[2])
    return f"{{box: [{size[0]}, {size[1]}, {size[2]}], at: [{x}, {y}, {z}]}}"


def left_deep(n):
    """((block - slot) - slot) - ..."""
    tree = box((0, 0, 0), (n, 10, 10))
    for i in range(1, n + 1):
        tree = f"{{difference: [{tree}, {box((i - 0.75, 0, 5), (0.5, 10, 5))}]}}"
    return HEAD + tree + "\n"


def right_deep(n):
    """box - (box - (box - ...)), flush with one another's tops."""
    tree = None
    for i in range(n, -1, -1):
        width, depth = 2.0 * (n + 1 - i), 0.5 * (n + 1 - i)
        one = box((-width / 2, -width / 2, -depth), (width, width, depth))
        tree = one if tree is None else f"{{difference: [{one}, {tree}]}}"
    return HEAD + tree + "\n"


def cups(leaves):
    """A balanced tree: a lattice of cups, each a box less a smaller one, united two by two."""
    count = leaves // 2
    columns = next(n for n in range(1, count + 1) if n * n >= count)

    def tree(first, end):
        if end - first > 1:
            middle = (first + end) // 2
            return f"{{union: [{tree(first, middle)}, {tree(middle, end)}]}}"
        x, y = first % columns, first // columns
        return f"{{difference: [{{box: 0.8, at: [{x}, {y}, 0]}}, {{box: 0.5, at: [{x}, {y}, 0.3]}}]}}"

    return HEAD + tree(0, count) + "\n"


class Trees(CommandTest):
    def drawn(self, text, coherence="span+behind"):
        """The page, and what it took. What lines keep of one another hangs on how long it lasts, and
        not on the tree alone: laws of trees are held on lines by themselves."""
        (self.folder / "tree.yaml").write_text(text, encoding="utf-8")
        code, page, error = overstrike("render", "tree.yaml", "-d", "line-printer", "-o", "-", "--size", "100x50",
                                       "--threads", "1", "--coherence", coherence, "--timings=json", folder=self.folder)
        self.assertEqual(code, 0, error)
        timings = json.loads(error.splitlines()[-1])
        return page, timings["solids"], timings["peak_bytes"]

    def test_what_a_chain_of_differences_costs_is_linear_in_its_length(self):
        for chain, pictures in ((left_deep, 1), (right_deep, 1)):
            _, half, _ = self.drawn(chain(100))
            page, whole, peak = self.drawn(chain(200))
            self.assertGreater(len(set(page)), 3)
            # Twice as many layers on a line, and twice as many spans.
            for what in ("flips", "updates"):
                self.assertLess(whole[what], 4.5 * half[what] * pictures, (chain.__name__, what))
            # A chain never tells all of itself of one operand, nor what it was told before.
            self.assertLess(whole["updates"], 2 * whole["flips"], chain.__name__)
            kept_page, kept, _ = self.drawn(chain(200), "all")
            self.assertEqual(kept_page, page)
            self.assertLess(kept["flips"], whole["flips"], chain.__name__)
            self.assertLess(peak, 50e6)
        # The tops of the boxes are passed together: of a hundred operands few are other ones than a span before.
        self.assertLess(whole["updates"], 0.1 * whole["flips"])

    def test_a_tree_of_100_000_leaves_costs_what_its_lines_meet(self):
        _, tenth, _ = self.drawn(cups(10_000))
        page, whole, peak = self.drawn(cups(100_000))
        self.assertGreater(len(set(page)), 3)
        # The square root of ten as many cups on a line, and in depth over a place.
        for what in ("flips", "updates"):
            self.assertLess(whole[what], 10 * tenth[what], what)
        self.assertLess(peak, 800e6)


if __name__ == "__main__":
    unittest.main()
