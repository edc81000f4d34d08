#!/usr/bin/python3
"""Tokoi's experiments: tk_experiments.py build/release/bin/tk_driver docs writes docs/tk-experiments.md and its curves.

With further words, only those figures (3.14, ..., forms) are measured and the page's other sections stay.
"""
import dataclasses
import pathlib
import re
import sys
import typing

import bars
import curves
import form_table
import tk_scenes as scenes
from tk_measure import COHERENCES, Case, counted, timed

LINES = (128, 256, 512, 1024, 2048, 4096)
SIDES = tuple(range(10, 101, 10))
SEGMENTS = {f"{n} segments": n for n in (0, 4, 8)}
THESIS = "span+behind"  # all that the thesis' chapter 4 has


@dataclasses.dataclass(frozen=True)
class Figure:
    shows: str
    claim: str
    x_label: str
    xs: tuple
    curves: dict  # name -> case of x
    write: typing.Callable  # (figure, driver, path of a picture) -> its table's lines


def cases(figure):
    return [case(x) for case in figure.curves.values() for x in figure.xs]


def by_curve(figure, values):
    """name -> one value per x."""
    n = len(figure.xs)
    return {name: values[i * n:(i + 1) * n] for i, name in enumerate(figure.curves)}


def table(figure, found, columns):
    """Rows of x, of each curve the columns: label -> text of what was found."""
    rows = [f"| {figure.x_label} | " + " | ".join(f"{name}, {' | '.join(columns)}" for name in found) + " |",
            "|---" * (1 + len(columns) * len(found)) + "|"]
    for i, x in enumerate(figure.xs):
        cells = [text(column[i]) for column in found.values() for text in columns.values()]
        rows.append(f"| {x} | " + " | ".join(cells) + " |")
    return rows


def draw(figure, found, picture, y_label, value):
    lines = {name: [(x, value(one)) for x, one in zip(figure.xs, column)] for name, column in found.items()}
    picture.write_text(curves.svg(figure.x_label, y_label, lines), encoding="utf-8")


def growth(figure, found, value):
    if figure.x_label != "lines":
        return []
    most = figure.xs[-1] / figure.xs[0]
    grown = (f"{name} {value(column[-1]) / value(column[0]) / most:.2f}" for name, column in found.items())
    return ["", f"Growth over that of the lines, {figure.xs[-1]} against {figure.xs[0]}: {', '.join(grown)}."]


def times(figure, driver, picture):
    found = by_curve(figure, timed(driver, cases(figure)))
    draw(figure, found, picture, "ms", lambda one: one["ms"])
    return table(figure, found, {"ms": lambda one: f"{one['ms']:.2f}", "runs": lambda one: f"{one['runs']:.0f}"}) + growth(
        figure, found, lambda one: one["ms"])


def sets_alone(figure, driver, picture):
    found = by_curve(figure, counted(driver, cases(figure)))

    def millions(one):
        return one["parts"]["set operations"] / 1e6

    draw(figure, found, picture, "millions", millions)
    shares = [one["parts"]["set operations"] / one["total"] for column in found.values() for one in column]
    columns = {"M": lambda one: f"{millions(one):.2f}", "times": lambda one: f"{one['decisions']:.0f}"}
    return [*table(figure, found, columns), *growth(figure, found, millions), "",
            f"That is {100 * min(shares):.1f} to {100 * max(shares):.1f} % of all instructions of a picture."]


def each_set(figure, driver, picture):
    found = by_curve(figure, counted(driver, cases(figure)))

    def instructions(one):
        return one["parts"]["set operations"] / one["decisions"]

    draw(figure, found, picture, "instructions", instructions)
    return table(figure, found, {
        "instructions": lambda one: f"{instructions(one):.0f}",
        "operands passed": lambda one: f"{one['flips'] / one['decisions']:.2f}",
        "counters updated": lambda one: f"{one['updates'] / one['decisions']:.2f}"})


def parts(figure, driver, picture):
    found = [{**count, "ms": time["ms"]} for count, time in zip(counted(driver, cases(figure)), timed(driver, cases(figure)))]
    found = by_curve(figure, found)
    names = list(next(iter(found.values()))[0]["parts"])
    counts = ("decisions", "updates", "crossings", "spans")
    rows = [f"| {figure.x_label} | | ms | M | " + " | ".join(f"{name}, M" for name in names) + " | " + " | ".join(counts) + " |",
            "|---" * (4 + len(names) + len(counts)) + "|"]
    groups = {}
    for i, x in enumerate(figure.xs):
        for name, column in found.items():
            one = column[i]
            groups.setdefault(f"{figure.x_label} {x}", {})[name] = {p: v / 1e6 for p, v in one["parts"].items()}
            cells = [f"{one['ms']:.2f}", f"{one['total'] / 1e6:.1f}", *(f"{one['parts'][p] / 1e6:.2f}" for p in names),
                     *(f"{one[c]:.0f}" for c in counts)]
            rows.append(f"| {x} | {name} | " + " | ".join(cells) + " |")
    picture.write_text(bars.svg("millions", groups), encoding="utf-8")
    return rows


def prisms_by_sides(coherence):
    return {name: lambda n, m=m: Case(scenes.nine_prisms(n, m), 512, coherence) for name, m in SEGMENTS.items()}


def prisms_by_lines(coherence):
    return {name: lambda n, m=m: Case(scenes.nine_prisms(32, m), n, coherence) for name, m in SEGMENTS.items()}


ALONE = "Time of the set operations alone: instructions of following the expression along depth, and how often that is done."
FIGURES = {
    "3.14": Figure(
        "Two prisms of n sides: the difference, and the union of the same bodies; 512 x 512.",
        "O(n), and the difference is no dearer than the union; from some n on it is cheaper, as there is less to see.",
        "sides", (3, 10, 20, 40, 60, 80, 100),
        {"difference": lambda n: Case(scenes.two_prisms(n, True)), "union": lambda n: Case(scenes.two_prisms(n, False))}, times),
    "3.15": Figure(
        "Tetrahedron A, sphere B and cube C, 770 faces (the thesis has 772): A + B + C, A + (B - C), (A - C) + (B - C), on 128 to 4096 lines.",
        "In proportion to the lines, not to the pixels; data-2 is faster than data-1, data-3 slower than that.",
        "lines", LINES,
        {f"data-{i + 1}": lambda n, i=i: Case(scenes.three_bodies(i), n) for i in range(3)}, times),
    "4.8": Figure(
        "Nine prisms of n sides, the middle one taken from none, four and eight of the others; 512 x 512.",
        "O(n); what more segments cost does not depend on n.",
        "sides", SIDES, prisms_by_sides("all"), times),
    "4.9": Figure(
        f"{ALONE} As the thesis has it (`--coherence {THESIS}`).",
        "It depends on the segments, and not on the sides.",
        "sides", SIDES, prisms_by_sides(THESIS), sets_alone),
    "4.9 from line to line": Figure(
        "The same with all that is kept (`--coherence all`).", "None: he keeps nothing from line to line in chapter 4.",
        "sides", SIDES, prisms_by_sides("all"), sets_alone),
    "4.10": Figure("The prisms of 4.8 with 32 sides, on 128 to 4096 lines.", "In proportion to the lines.",
                   "lines", LINES, prisms_by_lines("all"), times),
    "4.11": Figure(f"{ALONE} As the thesis has it (`--coherence {THESIS}`).", "In proportion to the lines.",
                   "lines", LINES, prisms_by_lines(THESIS), sets_alone),
    "4.11 from line to line": Figure(
        "The same with all that is kept (`--coherence all`).", "None: he keeps nothing from line to line in chapter 4.",
        "lines", LINES, prisms_by_lines("all"), sets_alone),
    "4.12": Figure(
        f"One set operation of the nine prisms of 32 sides at 512 x 512, by segments (`--coherence {THESIS}`).",
        "In proportion to the segments; half as much where only what a face concerns is looked at.",
        "segments", tuple(range(9)), {"mean": lambda m: Case(scenes.nine_prisms(32, m), 512, THESIS)}, each_set),
    "4.13": Figure(
        "The method's parts with its coherence switched off: nine prisms of 32 sides, 512 x 512. (a) none, (b) span, (c) span+behind, and all.",
        "(b) is a large gain; (c) halves the set operations, but to look whether a crossing lies behind costs more than that.",
        "segments", (0, 4, 8),
        {name: lambda m, name=name: Case(scenes.nine_prisms(32, m), 512, name) for name in COHERENCES}, parts),
    "4.15": Figure(
        "A box and prisms intersected with an ellipsoid; from case 1 to 4 the prisms grow, and cross where nothing is seen; 512 x 512. "
        "As trees, and once as the sum of five products that the thesis has.",
        "Times grow with the crossings; here (c) is faster than (b).",
        "case", (1, 2, 3, 4),
        {**{name: lambda n, name=name: Case(scenes.clipped_by_ellipsoid(n), 512, name, "tree") for name in COHERENCES},
         f"{THESIS}, sop": lambda n: Case(scenes.clipped_by_ellipsoid(n), 512, THESIS, "sop")}, parts),
}


def section(name, driver, pictures):
    if name == "forms":
        return form_table.section(driver)
    figure = FIGURES[name]
    picture = pictures / f"{name.replace(' ', '-')}.svg"
    lines = figure.write(figure, driver, picture)
    return "\n".join([f"## {name}", "", figure.shows, "", f"TK: {figure.claim}", "",
                      f"![{name}](tk-experiments/{picture.name})", "", *lines]) + "\n"


def sections_of(page):
    """heading -> text, of what stands; the page's head under ""."""
    found = re.split(r"^(?=## )", page.read_text(encoding="utf-8") if page.exists() else "", flags=re.MULTILINE)
    return {"": found[0], **{text.splitlines()[0].removeprefix("## "): text for text in found[1:]}}


def main(driver, docs, *only):
    page, pictures = docs / "tk-experiments.md", docs / "tk-experiments"
    pictures.mkdir(exist_ok=True)
    stands = sections_of(page)
    stands["forms"] = stands.get(form_table.HEAD.splitlines()[0].removeprefix("## "), "")
    sections = [stands[""]]
    for name in [*FIGURES, "forms"]:
        print(name, file=sys.stderr, flush=True)
        sections.append(section(name, driver, pictures) if not only or name in only else stands.get(name, ""))
    page.write_text("\n\n".join(text.strip("\n") for text in sections if text) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]), *sys.argv[3:])
