"""Curves as SVG, nothing but lines and words."""
import math

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 480, 326, 56, 22, 96, 44
DASHES = ("", "6 3", "2 3", "8 3 2 3")


def ticks(most):
    """0 and up to six round numbers up to `most` or beyond."""
    step = 10 ** math.floor(math.log10(most / 3))
    step *= next(f for f in (1, 2, 5, 10) if most / (f * step) <= 6)
    return [i * step for i in range(math.ceil(most / step) + 1)]


def svg(x_label, y_label, curves):
    """`curves`: name -> [(x, y), ...]; both axes are linear, from 0."""
    points = [p for curve in curves.values() for p in curve]
    xs, ys = ticks(max(p[0] for p in points)), ticks(max(p[1] for p in points))

    def place(x, y):
        return (LEFT + x / xs[-1] * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - y / ys[-1] * (HEIGHT - TOP - BOTTOM))

    def line(x1, y1, x2, y2):
        (a, b), (c, d) = place(x1, y1), place(x2, y2)
        return f'<path d="M{a:.1f} {b:.1f}L{c:.1f} {d:.1f}" stroke="#bbb"/>'

    def words(x, y, anchor, text):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{text}</text>'

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="11" fill="none">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    labels = []
    for x in xs:
        out.append(line(x, 0, x, ys[-1]))
        labels.append(words(place(x, 0)[0], HEIGHT - BOTTOM + 14, "middle", f"{x:g}"))
    for y in ys:
        out.append(line(0, y, xs[-1], y))
        labels.append(words(LEFT - 6, place(0, y)[1] + 4, "end", f"{y:g}"))
    labels.append(words((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 8, "middle", x_label))
    labels.append(words(LEFT, TOP - 9, "start", y_label))
    taken = []
    for (name, curve), dash in zip(curves.items(), DASHES):
        path = "L".join(f"{place(*p)[0]:.1f} {place(*p)[1]:.1f}" for p in curve)
        out.append(f'<path d="M{path}" stroke="#000" stroke-width="1.5" stroke-dasharray="{dash}"/>')
        y = place(*curve[-1])[1] + 4
        while any(abs(y - other) < 12 for other in taken):
            y -= 12
        taken.append(y)
        labels.append(words(place(*curve[-1])[0] + 6, y, "start", name))
    return "\n".join([*out, '<g fill="#000">', *labels, "</g>", "</svg>"]) + "\n"
