"""Solids that as sums of products have fewer, as many and more elements than the tree has operands."""
import tk_scenes

ABOVE = "{azimuth: -50, elevation: 50, projection: parallel}"
SIDES = 8


def box(size, at):
    return f"{{box: [{size[0]:.17g}, {size[1]:.17g}, {size[2]:.17g}], at: [{at[0]:.17g}, {at[1]:.17g}, {at[2]:.17g}]}}"


def bars(count):
    """Along x, beside one another."""
    return [box((12, 0.8, 1), (0, i - count / 2 + 0.5, 0)) for i in range(count)]


def crossed(positives, negatives):
    """Bars less rods, each of which passes through all bars: all products are needed."""
    depth = positives + 1
    rods = [f"{{prism: {{sides: {SIDES}, radius: {4.5 / negatives:.17g}, height: {depth}}}, rotate: [-90, 0, 0], "
            f"at: [{12 * (i + 0.5) / negatives - 6:.17g}, {-depth / 2}, 1]}}" for i in range(negatives)]
    return tk_scenes.scene(ABOVE, tk_scenes.node("less", tk_scenes.node("union", *bars(positives)), *rods))


def drilled(count, holes):
    """Bars less holes, each of which lies in one bar."""
    drills = [tk_scenes.prism(SIDES, 0.3, 1.2, (12 * (h + 0.5) / holes - 6, i - count / 2 + 0.5, -0.1))
              for i in range(count) for h in range(holes)]
    return tk_scenes.scene(ABOVE, tk_scenes.node("less", tk_scenes.node("union", *bars(count)), *drills))


def within(count):
    """What of a lattice of prisms lies in a box: most lie apart from it."""
    half = count / 2 - 0.5
    prisms = [tk_scenes.prism(SIDES, 0.45, 1, (i - half, j - half, 0)) for i in range(count) for j in range(count)]
    return tk_scenes.scene(ABOVE, tk_scenes.node("and", tk_scenes.node("union", *prisms),
                                                 box((2.2, 2.2, 0.8), (0, 0, 0.3))))


def sums(count):
    """The product of so many sums of two, all through one another: 2 ^ count products."""
    pairs = []
    for i in range(count):
        one = f"{{prism: {{sides: 4, radius: {1 + 0.03 * i:.17g}, height: 4}}, rotate: {13 * i}, at: [0, 0, -2]}}"
        other = f"{{prism: {{sides: 4, radius: 1, height: 4}}, rotate: [90, {11 * i}, 0], at: [0, {2 + 0.01 * i:.17g}, 0]}}"
        pairs.append(tk_scenes.node("union", one, other))
    return tk_scenes.scene(ABOVE, tk_scenes.node("and", *pairs))


def nested(count):
    """A plate less differences of a slab and a block: 2 ^ count products."""
    tools = [tk_scenes.node("less", box((200, 200, 10), (0, 0, 0)), box((20, 20, 10), (i + 10, 10, 0))) for i in range(count)]
    return tk_scenes.scene("{eye: [75, -75, 60], target: [25, 25, 10], projection: parallel}",
                           tk_scenes.node("less", box((50, 50, 20), (0, 0, 0)), *tools))


def in_turns(count):
    """A bar, a hole in it taken, a bar added, a hole in that taken ...: twice as deep as there are bars."""
    solid = None
    for i, bar in enumerate(bars(count)):
        solid = bar if solid is None else tk_scenes.node("union", solid, bar)
        solid = tk_scenes.node("less", solid, tk_scenes.prism(SIDES, 0.3, 1.2, (0.3 * (i % 5), i - count / 2 + 0.5, -0.1)))
    return tk_scenes.scene(ABOVE, solid)


FAMILIES = {
    "bars less rods, each through all bars": (crossed, [(2, 1), (2, 8), (4, 4), (8, 8), (16, 1), (16, 16)]),
    "bars less holes, so many in each": (drilled, [(4, 1), (4, 4), (16, 4), (32, 8)]),
    "bars added and holes taken in turns": (in_turns, [(2,), (4,), (8,), (32,)]),
    "of n x n prisms, what lies in a box": (within, [(2,), (4,), (8,), (16,)]),
    "products of n sums of two": (sums, [(2,), (3,), (4,), (6,)]),
    "nested differences": (nested, [(1,), (2,), (4,), (10,), (50,), (200,)]),
}
