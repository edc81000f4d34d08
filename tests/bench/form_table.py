"""Solids followed as trees and as sums of products, and as what is chosen, in instructions."""
import form_scenes
from tk_measure import Case, counted

HEAD = """## Trees and sums of products

What `--boolean auto` chooses, measured: whole pictures of 512 x 512 in millions of instructions, to set up the sum of products included. The thesis'
coherence is span+behind, the default is all. Auto counts the counters from each leaf up to the root, of all operands that the sum of products has left, and
takes the form with fewer; more elements than leaves it does not look for.

"""
COHERENCES = ("span+behind", "all")
FORMS = ("tree", "sop", "auto")


def section(driver):
    drawn = [(family, make, args) for family, (make, all_args) in form_scenes.FAMILIES.items() for args in all_args]
    found = iter(counted(driver, [Case(make(*args), 512, coherence, form)
                                  for _, make, args in drawn for coherence in COHERENCES for form in FORMS]))
    rows = ["| solid | leaves | elements | " + " | ".join(f"{c}: tree, M | sop / tree | auto / tree" for c in COHERENCES) + " |",
            "|---" * (3 + 3 * len(COHERENCES)) + "|"]
    for family, _, args in drawn:
        cells = []
        for _ in COHERENCES:
            tree, sop, auto = (next(found) for _ in FORMS)
            cells += [f"{tree['total'] / 1e6:.1f}", *(f"{one['total'] / tree['total']:.2f}" for one in (sop, auto))]
        name = f"{family}: {', '.join(map(str, args))}"
        rows.append(f"| {name} | {tree['leaves']:.0f} | {sop['leaves']:.0f} | " + " | ".join(cells) + " |")
    return HEAD + "\n".join(rows) + "\n"
