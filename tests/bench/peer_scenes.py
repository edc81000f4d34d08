"""Solids for several programs: the same tree, the same numbers and the same parallel view in each one's language.

A tree is ("union" | "less", tree, ...), ("box", low corner, size) or ("prism", sides, radius, height, middle of its base,
degrees it is turned by).
"""
import dataclasses
import math

import tk_scenes

# OpenSCAD's parallel view is so high, in distances of the eye (2 tan 11.25 degrees).
OPENSCAD_HEIGHT = 2 * math.tan(math.radians(11.25))


@dataclasses.dataclass(frozen=True)
class Scene:
    tree: tuple
    target: tuple
    towards_eye: tuple
    window: float


def box(low, size):
    return ("box", low, size)


def nine_prisms():
    """Scene B: eight prisms in a ring, from each the one in the middle taken."""
    middle = ("prism", 32, 1, 2, (0, 0, -1), 0)
    ring = [("prism", 32, 0.45, 2.4, (math.cos(math.pi * i / 4), math.sin(math.pi * i / 4), -1.2), math.degrees(0.1 * i))
            for i in range(8)]
    return Scene(("union", *(("less", one, middle) for one in ring)), (0, 0, 0), (6, -10, 8), 4.4)


def nested(count):
    """A plate less so many differences of a slab and a block."""
    tools = [("less", box((0, 0, 0), (200, 200, 10)), box((i, 0, 0), (20, 20, 10))) for i in range(count)]
    return Scene(("less", box((0, 0, 0), (50, 50, 20)), *tools), (25, 25, 10), (1, -1, 1), 76)


def holes(count):
    """Through a plate; they end flush with both of its faces."""
    columns = math.ceil(math.sqrt(count))
    drills = [("prism", 16, 0.35, 1, (i % columns + 0.5, i // columns + 0.5, 0), 0) for i in range(count)]
    return Scene(("less", box((0, 0, 0), (columns, columns, 1)), *drills), (columns / 2, columns / 2, 0.5), (0.5, -0.6, 1.8),
                 1.5 * columns)


def one_box():
    return Scene(("union", box((0, 0, 0), (2, 2, 2))), (1, 1, 1), (1, -2, 1), 5)


SCENES = {
    "one box: what a program takes to begin": one_box(),
    "nine prisms of 32 sides, one taken from eight": nine_prisms(),
    "10 nested differences": nested(10),
    "200 nested differences": nested(200),
    "1000 holes of 16 sides": holes(1000),
}


def numbers(values):
    return ", ".join(f"{v:.17g}" for v in values)


def scaled(scene, distance):
    """The eye so far from the target."""
    length = math.sqrt(sum(c * c for c in scene.towards_eye))
    return tuple(t + distance * c / length for t, c in zip(scene.target, scene.towards_eye))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(v, length=1.0):
    norm = math.sqrt(sum(c * c for c in v))
    return tuple(length * c / norm for c in v)


def yaml(scene):
    def write(tree):
        kind = tree[0]
        if kind == "box":
            _, low, size = tree
            base = (low[0] + size[0] / 2, low[1] + size[1] / 2, low[2])
            return f"{{box: [{numbers(size)}], at: [{numbers(base)}]}}"
        if kind == "prism":
            _, sides, radius, height, at, turn = tree
            return tk_scenes.prism(sides, radius, height, at, turn)
        return tk_scenes.node(kind, *map(write, tree[1:]))

    eye = numbers(scaled(scene, 4 * scene.window))
    return tk_scenes.scene(f"{{eye: [{eye}], target: [{numbers(scene.target)}], projection: parallel, window: {scene.window}}}",
                           write(scene.tree))


def scad(scene):
    def write(tree):
        kind = tree[0]
        if kind == "box":
            return f"translate([{numbers(tree[1])}]) cube([{numbers(tree[2])}]);"
        if kind == "prism":
            _, sides, radius, height, at, turn = tree
            return f"translate([{numbers(at)}]) rotate({turn:.17g}) cylinder(r={radius}, h={height}, $fn={sides});"
        name = {"union": "union", "less": "difference"}[kind]
        return f"{name}() {{\n" + "\n".join(map(write, tree[1:])) + "\n}"

    return write(scene.tree) + "\n"


def scad_camera(scene):
    return numbers(scaled(scene, scene.window / OPENSCAD_HEIGHT) + tuple(scene.target)).replace(" ", "")


def pov(scene):
    def corner(k, sides, radius, turn):
        angle = math.radians(turn) + 2 * math.pi * k / sides
        return f"<{numbers((radius * math.cos(angle), radius * math.sin(angle)))}>"

    def write(tree):
        kind = tree[0]
        if kind == "box":
            high = tuple(a + b for a, b in zip(tree[1], tree[2]))
            return f"box {{ <{numbers(tree[1])}>, <{numbers(high)}> }}"
        if kind == "prism":
            # Its prisms stand along y.
            _, sides, radius, height, at, turn = tree
            corners = ", ".join(corner(k % sides, sides, radius, turn) for k in range(sides + 1))
            return (f"prism {{ linear_spline 0, {height}, {sides + 1}, {corners} "
                    f"matrix <1,0,0, 0,0,1, 0,1,0, {numbers(at)}> }}")
        members = list(map(write, tree[1:]))
        if len(members) == 1:
            return members[0]
        name = {"union": "union", "less": "difference"}[kind]
        return f"{name} {{\n" + "\n".join(members) + "\n}"

    towards = unit(scene.towards_eye)
    right = unit(cross((0, 0, 1), towards), scene.window)
    up = unit(cross(towards, right), scene.window)
    return (f"#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\ncamera {{ orthographic location <{numbers(scaled(scene, 4 * scene.window))}> "
            f"direction <{numbers(tuple(-c for c in towards))}> right <{numbers(right)}> up <{numbers(up)}> }}\n"
            f"object {{ {write(scene.tree)} pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 1 }} }}\n")
