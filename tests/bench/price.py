#!/usr/bin/python3
"""What features cost that a scene does not have, in instructions: price.py SOURCES price_driver

Callgrind counts the instructions of every source line of a scene drawn without a feature. The
feature's lines are those of FEATURES below: whole files, functions whose name has one of its words,
and single lines that have one. Their own instructions, and those of what they call, may be at most
LIMIT of the whole. With the feature, the same lines must cost more, or the table has lost track of
the code. `--lines N` tells the N dearest lines of each feature. Exits 1 when something costs too
much, 2 when nothing could be measured.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

LIMIT = 0.01

# Feature: (files of core, words), both regular expressions. Only what is in core counts.
FEATURES = {
    "light": (r"shadow|light|caster|plane_gap", r"shadow|winding|light|covered"),
    "ground": (r"ground", r"ground"),
    "smooth": (r"smooth", r"smooth|bent"),
    "patterns": (r"pattern", r"pattern"),
    "segments": (r"segment", r"segment"),
    "strokes": (r"stroke|chains|edge_resolver|candidate_lines", r"stroke"),
    "interpenetration": (r"interpenetration|crossings|span_split", r"crossing|crosses|merge|meeting_(?!bodies)|surely_nearest"),
}

CONTROL = re.compile(r"\s*(if|for|while|else|return|switch|do|case|namespace|using|typedef|enum)\b")


def function_end(lines, first):
    """The last line of the function whose head begins at `first`, or None when it is not one."""
    indent = len(lines[first]) - len(lines[first].lstrip())
    if indent > 2 or CONTROL.match(lines[first]) or "(" not in lines[first]:
        return None
    for i in range(first, len(lines)):
        code = lines[i].split("//")[0].rstrip()
        if i == first and code.endswith("}"):
            return i
        if re.fullmatch(r" {%d}\}[;)]*" % indent, code):
            return i
        if code.endswith(";") and "{" not in "".join(lines[first : i + 1]):
            return None
    return None


def lines_of(text, whole_file, words):
    """Numbers of a source's lines that belong to a feature."""
    lines = text.splitlines()
    if whole_file:
        return set(range(1, len(lines) + 1))
    found = set()
    for i, line in enumerate(lines):
        if not words.search(line.split("//")[0]):
            continue
        # A function that only passes the feature on, as a parameter, is not the feature's.
        named = words.search(line.split("(")[0])
        last = function_end(lines, i) if named else None
        found.update(range(i + 1, (i if last is None else last) + 2))
    return found


def feature_lines(sources, feature):
    files, words = (re.compile(pattern, re.IGNORECASE) for pattern in FEATURES[feature])
    found = set()
    for path in sorted((sources / "core").rglob("*")):
        if path.suffix not in (".h", ".cpp") or path.stem.endswith("_test"):
            continue
        name = str(path.relative_to(sources))
        found.update((name, n) for n in lines_of(path.read_text(), files.search(path.stem), words))
    return found


class Profile:
    """Instructions by (file, line): its own, and of each call made there."""

    def __init__(self, text, sources):
        self.total = 0
        self.own = {}
        self.calls = []  # (caller's place, callee's place, instructions)
        self.sources = sources
        self.names = {}
        self.parse(text.splitlines())

    def name(self, path):
        if path not in self.names:
            full = pathlib.Path(path).resolve()
            inside = full.is_relative_to(self.sources)
            self.names[path] = str(full.relative_to(self.sources)) if inside else path
        return self.names[path]

    def parse(self, lines):
        file = callee_file = callee = summary = None
        for line in lines:
            key, _, value = line.partition("=")
            if line.startswith("summary:"):
                summary = int(line.split()[1])
            if key in ("fl", "fi", "fe"):
                file = self.name(value)
                if key == "fl":
                    callee_file = None
            elif key in ("cfi", "cfl"):
                callee_file = self.name(value)
            elif key == "calls":
                callee = (callee_file or file, int(value.split()[1]))
                callee_file = None
            elif line[:1].isdigit():
                number, cost = (int(word) for word in line.split()[:2])
                self.add((file, number), cost, callee)
                callee = None
        if self.total != summary:
            raise RuntimeError(f"the lines have {self.total} instructions, callgrind counted {summary}")

    def add(self, place, cost, callee):
        if callee is not None:
            self.calls.append((place, callee, cost))
        else:
            self.own[place] = self.own.get(place, 0) + cost
            self.total += cost

    def costs(self, places):
        """Place: its own instructions and those of the calls made there to other places."""
        costs = {place: self.own[place] for place in places if place in self.own}
        for caller, callee, cost in self.calls:
            if caller in places and callee not in places:
                costs[caller] = costs.get(caller, 0) + cost
        return costs


def profile(driver, sources, feature, what):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        subprocess.run(
            ["valgrind", "-q", "--tool=callgrind", f"--callgrind-out-file={out}", "--dump-line=yes",
             "--compress-pos=no", "--compress-strings=no", "--toggle-collect=price_region",
             driver, feature, what],
            check=True, stdout=subprocess.DEVNULL)
        return Profile(out.read_text(), sources)


def tell_lines(costs, count):
    for (file, line), cost in sorted(costs.items(), key=lambda item: -item[1])[:count]:
        print(f"    {cost:>10} {file}:{line}")


def measure(arguments, feature):
    """A row of the table, the costs line by line, and whether all is as it must be."""
    driver, sources = arguments.driver, arguments.sources
    places = feature_lines(sources, feature)
    without = profile(driver, sources, feature, "without")
    present = profile(driver, sources, feature, "with")
    if not any(name.startswith("core/") for name, _ in without.own):
        raise RuntimeError("no instruction has a source line: build with -g1")
    costs = without.costs(places)
    cost = sum(costs.values())
    time = subprocess.run([driver, feature, "time"], check=True, capture_output=True, text=True)
    part = cost / without.total
    found = sum(present.costs(places).values()) > cost
    row = (f"| {feature} | {without.total / 1e6:.2f} | {cost / 1e6:.3f} | {100 * part:.2f} % | "
           f"{present.total / without.total:.2f} | {float(time.stdout):.2f} |")
    if not found:
        row += "  <- its lines cost no more with it: mend FEATURES"
    elif part > LIMIT:
        row += f"  <- more than {100 * LIMIT:g} %"
    return row, costs, found and part <= LIMIT


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sources", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("driver")
    parser.add_argument("--lines", type=int, default=0)
    arguments = parser.parse_args()
    print("| feature | million instructions without | of them the feature's | part | "
          "with: times the instructions | with: times the time |")
    print("|---|---|---|---|---|---|")
    good = True
    for feature in FEATURES:
        row, costs, as_it_must_be = measure(arguments, feature)
        print(row, flush=True)
        tell_lines(costs, arguments.lines)
        good = good and as_it_must_be
    alone = profile(arguments.driver, arguments.sources, "light", "alone").total
    whole = profile(arguments.driver, arguments.sources, "light", "without").total
    print(f"\nthe scan alone {alone / 1e6:.2f}, through the whole program {whole / 1e6:.2f}: "
          f"{100 * (whole / alone - 1):+.2f} %")
    return 0 if good else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
        print(f"price.py: {error}", file=sys.stderr)
        sys.exit(2)
