"""OpenSCAD's 48 examples, drawn by us and by OpenSCAD from the same camera.

Each is exported by OpenSCAD and either drawn with its silhouette (under 0.2 % of the solid's pixels differ, all within
one pixel of an edge) or refused with a message that names the word. `--table FILE` writes the table of docs/openscad.md;
`--keep FOLDER` leaves all files there, and takes the solids that OpenSCAD computed from there; further words choose
examples by name. Needs openscad and xvfb-run.
"""
import argparse
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

import silhouettes

EXAMPLES = "/usr/share/openscad/examples"
# Of pictures. OpenSCAD's rasteriser sets corners on a lattice of 1/256 pixel, so that some pixels in a thousand along an
# edge are chance: where edges are much of the solid, it is drawn larger. Chance falls with size, what is wrong does not.
SIZES = (500, 1500, 4000)
LARGEST_PART = 0.002  # of the solid's pixels
SKIPPED = 77
SAYS_EMPTY = "Current top level object is empty"
# Of the size: less than 1/30 000 of a pixel in the largest picture. The slab is seen from the side, too: one of 1e-5 by 0.03
# of a pixel, a quarter of a per cent of a solid that is nearly all edge.
THINNEST = 1e-8
# From where OpenSCAD first looks, azimuth -65 and elevation 35, and what is right and up in the picture.
TOWARDS_EYE = (0.346189, -0.742404, 0.573576)
RIGHT, UP = (0.906308, 0.422618, 0.0), (-0.242404, 0.519837, 0.819152)
# The solid fills so much of the picture, which is 2 d tan(11.25 degrees) high.
FILL, HEIGHT = 0.8, 0.397825


def run(words, **more):
    return subprocess.run(words, capture_output=True, text=True, check=False, **more)


def corners(path):
    """The corners that an STL or a DXF holds."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if path.endswith(".stl"):
        return [tuple(map(float, p.split())) for p in re.findall(r"vertex (.*)", text)]
    return [(float(x), float(y), 0.0) for x, y in re.findall(r"\n *10\n(.*)\n *20\n(.*)", text)]


def camera(points):
    """(eye and target as --camera takes them, the size of the solid across the view)."""
    seen = [[sum(a * p for a, p in zip(axis, point)) for point in points]
            for axis in (RIGHT, UP, TOWARDS_EYE)]
    middle = [(min(values) + max(values)) / 2 for values in seen]
    size = max(max(values) - min(values) for values in seen[:2])
    distance = size / (FILL * HEIGHT)
    target = [sum(m * axis[i] for m, axis in zip(middle, (RIGHT, UP, TOWARDS_EYE))) for i in range(3)]
    eye = [t + distance * towards for t, towards in zip(target, TOWARDS_EYE)]
    return ",".join(f"{x:.9g}" for x in eye + target), size


class Example:
    def __init__(self, program, folder):
        self.name = os.path.splitext(os.path.basename(program))[0]
        self.program, self.folder = program, folder
        self.csg = os.path.splitext(program)[0] + ".csg"

    def path(self, ending):
        return os.path.join(self.folder, self.name + ending)

    def export(self):
        if os.path.exists(self.csg):
            return True
        done = run(["openscad", "-o", self.csg, self.program])
        return os.path.exists(self.csg) or done.stderr

    def refusal(self):
        """The message's first line when it is refused, else None."""
        done = run([os.environ["OVERSTRIKE"], "render", self.csg, "-o", self.path("-plain.png"),
                    "--size", f"{SIZES[0]}x{SIZES[0]}"])
        if done.returncode == 0:
            return None
        errors = [line for line in done.stderr.splitlines() if "error: " in line]
        return errors[0].split("error: ", 1)[1] if errors else f"status {done.returncode}: {done.stderr}"

    def compute(self):
        """OpenSCAD's result, as a mesh or flat (None when it is empty), and what it said where there is neither."""
        said = ""
        for ending in (".stl", ".dxf"):
            path = self.path(ending)
            if not os.path.exists(path):
                said += run(["openscad", "-o", path, self.csg]).stderr  # not the program: it may be random
            if os.path.exists(path) and re.search("vertex|LINE", open(path, encoding="utf-8").read()):
                return path, ""
        return None, "" if SAYS_EMPTY in said else said or "no result"

    def is_empty(self):
        """Nothing at all is drawn."""
        picture = self.path("-empty.pgm")
        done = run([os.environ["OVERSTRIKE"], "render", self.csg, "-o", picture, "--size", f"{SIZES[0]}x{SIZES[0]}",
                    "--translucent", "0"])
        assert done.returncode == 0, done.stderr
        return silhouettes.is_blank(picture)

    def compare(self, result, projection, size):
        """(pixels of the solid, differing, far from an edge)."""
        view, reach = camera(corners(result))
        with open(self.csg, encoding="utf-8") as file:
            plain = re.sub(r"color\([^)]*\)", "group()", file.read())
        program = os.path.splitext(self.csg)[0] + "-result.csg"
        with open(program, "w", encoding="utf-8") as file:
            if result.endswith(".stl"):
                file.write(f'import("{result}");\n')  # what OpenSCAD made is not made twice
            else:
                # It outlines flat shapes with a broad line, but not thin solids.
                file.write(f"linear_extrude({THINNEST * reach}) {{\n{plain}}}\n")
        theirs, ours = self.path(f"-{projection}-theirs.png"), self.path(f"-{projection}-ours.pgm")
        done = run(["xvfb-run", "-a", "openscad", "-o", theirs, "--render", f"--imgsize={size},{size}",
                    f"--projection={projection}", f"--camera={view}", program])
        assert os.path.exists(theirs), done.stderr
        shape = os.path.splitext(self.csg)[0] + "-plain.csg"
        with open(shape, "w", encoding="utf-8") as file:
            file.write(plain)
        finer = f"{silhouettes.FINER * size}x{silhouettes.FINER * size}"
        done = run([os.environ["OVERSTRIKE"], "render", shape, "-o", ours, "--size", finer,
                    "--camera", view, "--projection", projection, "--density", "0,1", "--no-light", "--translucent", "0"])
        assert done.returncode == 0, done.stderr
        return silhouettes.difference(silhouettes.of_openscad(theirs), silhouettes.of_ours(ours))

    def row(self):
        """(right, cells of the table)."""
        if self.export() is not True:
            return False, [self.name, "not exported", "", ""]
        refused = self.refusal()
        if refused is not None:
            return bool(re.match(r"'\w+' ", refused)), [self.name, "refused", refused, ""]
        result, fault = self.compute()
        if fault:
            return False, [self.name, "no result of OpenSCAD's", fault.strip().replace("\n", "; "), ""]
        if result is None:
            if not self.is_empty():
                return False, [self.name, "drawn, differs", "empty in OpenSCAD", ""]
            return True, [self.name, "drawn", "empty, in OpenSCAD too", ""]
        cells, right = [], True
        for projection in ("o", "p"):
            for size in SIZES:
                solid, wrong, far = self.compare(result, projection, size)
                same = wrong < LARGEST_PART * solid and far == 0
                if same:
                    break
            right = right and same
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
        if not os.path.exists(examples):
            shutil.copytree(EXAMPLES, examples)
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
