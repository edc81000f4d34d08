"""The solids of TK's experiments as scene files. The thesis shows pictures of them only: what it does not say is chosen here."""
import math

OPERATIONS = {"union": "union", "less": "difference", "and": "intersection"}


def prism(sides, radius, height, at, turn=0.0, lying=False):
    place = f"at: [{at[0]:.17g}, {at[1]:.17g}, {at[2]:.17g}]"
    rotate = "rotate: [0, 90, 0]" if lying else f"rotate: {turn:.17g}"
    return f"{{prism: {{sides: {sides}, radius: {radius}, height: {height}}}, {rotate}, {place}}}"


def node(operation, *members):
    return f"{{{OPERATIONS[operation]}: [{', '.join(members)}]}}"


def scene(camera, *solids):
    return f"camera: {camera}\nbodies:\n" + "".join(f"  - {solid}\n" for solid in solids)


CLOSE = "{azimuth: -50, elevation: 30, look-at: [0, 0, 0], projection: parallel, window: 5}"
# Scene B of docs/solids.md: along (-0.6, 1, -0.8).
ABOVE_RING = "{eye: [6, -10, 8], target: [0, 0, 0], projection: parallel, window: 4.4}"


def two_prisms(sides, cut):
    """3.13: one prism stands, the other lies across it."""
    standing, lying = prism(sides, 1, 2.4, (0, 0, -1.2)), prism(sides, 0.6, 3.2, (-1.6, 0, 0), lying=True)
    return scene(CLOSE, node("less" if cut else "union", standing, lying))


def three_bodies(segments):
    """3.16: tetrahedron A, sphere B of 760 faces, cube C."""
    a = "{tetrahedron: [[-1.6, -1.2, -1], [1.2, -1.4, -1], [-0.2, 1.4, -1], [-0.4, -0.4, 1.6]]}"
    b = "{sphere: {radius: 1, sides: 38, rings: 20}, at: [0.7, 0.2, 0], shading: flat}"
    c = "{box: 1.3, at: [0.6, -0.5, -0.2]}"
    trees = [node("union", a, b, c), node("union", a, node("less", b, c)),
             node("union", node("less", a, c), node("less", b, c))]
    return scene(CLOSE, trees[segments])


def nine_prisms(sides, segments):
    """4.7: eight prisms in a ring; from so many of them a ninth in the middle is taken."""
    middle = prism(sides, 1, 2, (0, 0, -1))
    members = []
    for i in range(8):
        angle = math.pi * i / 4
        one = prism(sides, 0.45, 2.4, (math.cos(angle), math.sin(angle), -1.2), turn=math.degrees(0.1 * i))
        members.append(node("less", one, middle) if i < segments else one)
    if segments == 0:
        members.append(middle)
    return scene(ABOVE_RING, node("union", *members))


def clipped_by_ellipsoid(step):
    """4.14: a box and four prisms, longer from step 1 to 4, intersected with an ellipsoid. Longer prisms cross one another
    inside of the box, where nothing is seen."""
    length = 0.6 + 0.7 * step
    box = "{box: [3, 2, 1.2], at: [0, 0, -0.6]}"
    standing = [prism(32, 0.3, length, (x, y, 0.9 - length)) for x, y in ((-0.8, -0.3), (-0.3, 0.3))]
    lying = [prism(32, 0.35, length, (-1.9, y, 0), lying=True) for y in (-0.4, 0.4)]
    ellipsoid = "{ellipsoid: {radii: [1.7, 1.2, 0.9], sides: 32, rings: 16}, shading: flat}"
    return scene(CLOSE, node("and", node("union", box, *standing, *lying), ellipsoid))
