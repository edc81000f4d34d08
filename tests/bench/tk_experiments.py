#!/usr/bin/python3
"""Tokoi's experiments: tk_experiments.py build/release/bin/tk_driver docs writes docs/tk-experiments.md and its curves."""
import pathlib
import subprocess
import sys
import tempfile

import curves
import tk_scenes as scenes

LINES = (128, 256, 512, 1024, 2048, 4096)
SEGMENTS = {f"{n} segments": n for n in (0, 4, 8)}

# Figure: what it shows, the thesis' finding, x axis, xs, curves: name -> scene of x, size of x.
FIGURES = {
    "3.14": ("Two prisms of n sides: the difference, and the union of the same bodies; 512 x 512.",
             "O(n), and the difference is no dearer than the union; from some n on it is cheaper, as there is less to see.",
             "sides", (3, 10, 20, 40, 60, 80, 100),
             {"difference": lambda n: scenes.two_prisms(n, True), "union": lambda n: scenes.two_prisms(n, False)},
             lambda n: 512),
    "3.15": ("Tetrahedron A, sphere B and cube C, 770 faces (the thesis has 772): A + B + C, A + (B - C), (A - C) + (B - C), on 128 to 4096 lines.",
             "In proportion to the lines, not to the pixels; data-2 is faster than data-1, data-3 slower than that.",
             "lines", LINES,
             {f"data-{i + 1}": lambda n, i=i: scenes.three_bodies(i) for i in range(3)}, lambda n: n),
    "4.8": ("Nine prisms of n sides, the middle one taken from none, four and eight of the others; 512 x 512.",
            "O(n); what more segments cost does not depend on n.",
            "sides", tuple(range(10, 101, 10)),
            {name: lambda n, m=m: scenes.nine_prisms(n, m) for name, m in SEGMENTS.items()}, lambda n: 512),
    "4.10": ("The same of 32 sides, on 128 to 4096 lines.",
             "In proportion to the lines.",
             "lines", LINES,
             {name: lambda n, m=m: scenes.nine_prisms(32, m) for name, m in SEGMENTS.items()}, lambda n: n),
    "4.15": ("A box and prisms intersected with an ellipsoid; from case 1 to 4 the prisms grow, and cross where nothing is seen; 512 x 512.",
             "Times grow with the crossings; with those behind the visible face ignored they grow less.",
             "case", (1, 2, 3, 4),
             {"all": lambda n: scenes.clipped_by_ellipsoid(n)}, lambda n: 512),
}


def measured(driver, folder, xs, makers, size_of):
    """name -> [(ms, runs) per x]; all of a figure in one run, in turns."""
    cases = []
    for c, (name, make) in enumerate(makers.items()):
        for x in xs:
            file = folder / f"{c}-{x}.yaml"
            file.write_text(make(x), encoding="utf-8")
            cases.append(f"{c} {file} {size_of(x)}")
    done = subprocess.run([driver], input="\n".join(cases) + "\n", capture_output=True, text=True, check=True)
    results = [line.split() for line in done.stdout.splitlines()]
    values = [(float(ms), int(runs)) for _, _, ms, runs in results]
    return {name: values[i * len(xs):(i + 1) * len(xs)] for i, name in enumerate(makers)}


def section(figure, found):
    shows, claim, x_label, xs, _, _ = FIGURES[figure]
    rows = [f"## {figure}", "", shows, "", f"TK: {claim}", "", f"![times](tk-experiments/{figure}.svg)", "",
            f"| {x_label} | " + " | ".join(f"{name}, ms | runs" for name in found) + " |", "|---" * (1 + 2 * len(found)) + "|"]
    for i, x in enumerate(xs):
        rows.append(f"| {x} | " + " | ".join(f"{column[i][0]:.2f} | {column[i][1]}" for column in found.values()) + " |")
    if x_label == "lines":
        grown = ", ".join(f"{name} {column[-1][0] / column[0][0] / (xs[-1] / xs[0]):.2f}" for name, column in found.items())
        rows += ["", f"Time over lines, {xs[-1]} against {xs[0]}: {grown}."]
    return "\n".join(rows) + "\n\n"


def main(driver, docs):
    page = docs / "tk-experiments.md"
    pictures = docs / "tk-experiments"
    pictures.mkdir(exist_ok=True)
    head = page.read_text(encoding="utf-8").split("\n## ")[0] + "\n" if page.exists() else ""
    body = ""
    with tempfile.TemporaryDirectory() as folder:
        for figure, (_, _, x_label, xs, makers, size_of) in FIGURES.items():
            found = measured(driver, pathlib.Path(folder), xs, makers, size_of)
            body += section(figure, found)
            lines = {name: [(x, ms) for x, (ms, _) in zip(xs, column)] for name, column in found.items()}
            (pictures / f"{figure}.svg").write_text(curves.svg(x_label, "ms", lines), encoding="utf-8")
    page.write_text(head + body.rstrip("\n") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]))
