"""OpenSCAD's 48 examples, drawn by us and by OpenSCAD from the same camera.

Each is exported by OpenSCAD and either drawn with its silhouette (under 0.2 % of the solid's pixels differ, all within
one pixel of an edge) or refused with a message that names the word. `--table FILE` writes the table of docs/openscad.md;
`--keep FOLDER` leaves the pictures; further words choose examples by name. Needs openscad and xvfb-run.
"""
import argparse
import glob
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import silhouettes

EXAMPLES = "/usr/share/openscad/examples"
SIZE = 500
LARGEST_PART = 0.002  # of the solid's pixels
SKIPPED = 77
# From where OpenSCAD first looks: azimuth -65, elevation 35.
TOWARDS_EYE = (0.3462, -0.7424, 0.5736)
# A sphere round the solid fills so much of the picture's height, 2 d tan(11.25 degrees).
FILL, HEIGHT = 0.9, 0.397825


def run(words, **more):
    return subprocess.run(words, capture_output=True, text=True, check=False, **more)


def bounds(path):
    """Low and high corner of what an STL, or the numbers of an SVG, hold."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    number = r"(-?[\d.]+(?:e[-+]?\d+)?)"
    if path.endswith(".stl"):
        points = [tuple(map(float, p))
                  for p in re.findall(rf"vertex {number} {number} {number}", text)]
    else:
        points = [(float(x), -float(y), 0.0)
                  for x, y in re.findall(rf"[ML] {number},{number}", text)]
    return [min(p[i] for p in points) for i in range(3)], [max(p[i] for p in points) for i in range(3)]


def camera(low, high):
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    distance = math.dist(low, high) / (FILL * HEIGHT)
    eye = [m + distance * t for m, t in zip(middle, TOWARDS_EYE)]
    return ",".join(f"{x:.6g}" for x in eye + middle)


class Example:
    def __init__(self, program, folder):
        self.name = os.path.splitext(os.path.basename(program))[0]
        self.program, self.folder = program, folder
        self.csg = os.path.splitext(program)[0] + ".csg"

    def path(self, ending):
        return os.path.join(self.folder, self.name + ending)

    def export(self):
        done = run(["openscad", "-o", self.csg, self.program])
        return os.path.exists(self.csg) or done.stderr

    def refusal(self):
        """The message's first line when it is refused, else None."""
        done = run([os.environ["OVERSTRIKE"], "render", self.csg, "-o", self.path("-plain.png"),
                    "--size", f"{SIZE}x{SIZE}"])
        if done.returncode == 0:
            return None
        errors = [line for line in done.stderr.splitlines() if "error: " in line]
        return errors[0].split("error: ", 1)[1] if errors else f"status {done.returncode}: {done.stderr}"

    def compute(self):
        """OpenSCAD's result: as a mesh, or flat; None when it is empty."""
        for ending in (".stl", ".svg"):
            run(["openscad", "-o", self.path(ending), self.program])
            path = self.path(ending)
            if os.path.exists(path) and re.search("vertex|M ", open(path, encoding="utf-8").read()):
                return path
        return None

    def compare(self, result, projection):
        """(pixels of the solid, differing, far from an edge)."""
        view = camera(*bounds(result))
        program = self.program
        if result.endswith(".stl"):  # what OpenSCAD made is not made twice
            program = self.path("-result.scad")
            with open(program, "w", encoding="utf-8") as file:
                file.write(f'import("{result}");\n')
        theirs, ours = self.path(f"-{projection}-theirs.png"), self.path(f"-{projection}-ours.png")
        done = run(["xvfb-run", "-a", "openscad", "-o", theirs, "--render", f"--imgsize={SIZE},{SIZE}",
                    f"--projection={projection}", f"--camera={view}", program])
        assert os.path.exists(theirs), done.stderr
        with open(self.csg, encoding="utf-8") as file:
            plain = re.sub(r"color\([^)]*\)", "group()", file.read())
        shape = os.path.splitext(self.csg)[0] + "-plain.csg"
        with open(shape, "w", encoding="utf-8") as file:
            file.write(plain)
        done = run([os.environ["OVERSTRIKE"], "render", shape, "-o", ours, "--size", f"{SIZE}x{SIZE}",
                    "--camera", view, "--projection", projection, "--density", "0,1"])
        assert done.returncode == 0, done.stderr
        return silhouettes.difference(silhouettes.of_openscad(theirs), silhouettes.of_ours(ours))

    def row(self):
        """(right, cells of the table)."""
        if self.export() is not True:
            return False, [self.name, "not exported", "", ""]
        refused = self.refusal()
        if refused is not None:
            return bool(re.match(r"'\w+' ", refused)), [self.name, "refused", refused, ""]
        result = self.compute()
        if result is None:
            return True, [self.name, "drawn", "empty, in OpenSCAD too", ""]
        cells, right = [], True
        for projection in ("o", "p"):
            solid, wrong, far = self.compare(result, projection)
            right = right and wrong < LARGEST_PART * solid and far == 0
            cells.append(f"{wrong} of {solid}" + (f", {far} far from an edge" if far else ""))
        return right, [self.name, "drawn" if right else "drawn, differs", *cells]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--table", help="write the table there")
    parser.add_argument("--keep", help="leave all files there")
    parser.add_argument("names", nargs="*", help="only these")
    options = parser.parse_args()
    for tool in ("openscad", "xvfb-run"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed (Debian's openscad and xvfb, with libgl1-mesa-dri)")
            return SKIPPED
    folder = options.keep or tempfile.mkdtemp()
    try:
        examples = os.path.join(folder, "examples")
        shutil.copytree(EXAMPLES, examples, dirs_exist_ok=True)
        programs = sorted(glob.glob(examples + "/*/*.scad"))
        chosen = [Example(p, folder) for p in programs]
        if options.names:
            chosen = [e for e in chosen if e.name in options.names]
        rows = []
        for example in chosen:
            rows.append(example.row())
            print(" | ".join(rows[-1][1]), "" if rows[-1][0] else "  <-- wrong", flush=True)
    finally:
        if not options.keep:
            shutil.rmtree(folder)
    if options.table:
        with open(options.table, "w", encoding="utf-8") as file:
            file.write("| example | | orthogonal | perspective |\n|---|---|---|---|\n")
            file.writelines("| " + " | ".join(cells) + " |\n" for _, cells in rows)
    wrong = [cells[0] for right, cells in rows if not right]
    print(f"{len(rows)} examples, wrong: {', '.join(wrong) or 'none'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
