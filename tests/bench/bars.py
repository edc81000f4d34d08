"""Stacked bars in groups as SVG, nothing but boxes and words."""
import curves

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 390, 56, 22, 110, 116
GREYS = ("#000", "#555", "#999", "#ccc", "#fff")
GAP = 0.8  # between groups, in bars


def svg(y_label, groups):
    """`groups`: label -> {label of a bar: {part: height, from below}}."""
    bars = [(group, name, parts) for group, members in groups.items() for name, parts in members.items()]
    names = list(bars[0][2])
    ys = curves.ticks(max(sum(parts.values()) for _, _, parts in bars))
    wide = (WIDTH - LEFT - RIGHT) / (len(bars) + GAP * len(groups))

    def place_y(value):
        return HEIGHT - BOTTOM - value / ys[-1] * (HEIGHT - TOP - BOTTOM)

    def box(x, y, width, height, grey):
        return (f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{GREYS[grey]}" '
                'stroke="#000" stroke-width="0.5"/>')

    def words(x, y, anchor, text, more=""):
        return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{more}>{text}</text>'

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="11">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>', words(LEFT, TOP - 9, "start", y_label)]
    for y in ys:
        out.append(f'<path d="M{LEFT} {place_y(y):.1f}H{WIDTH - RIGHT}" stroke="#bbb"/>')
        out.append(words(LEFT - 6, place_y(y) + 4, "end", f"{y:g}"))
    x = LEFT
    for group, members in groups.items():
        out.append(words(x + wide * (GAP + len(members)) / 2, HEIGHT - 8, "middle", group))
        x += wide * GAP / 2
        for name, parts in members.items():
            low = 0
            for grey, height in enumerate(parts.values()):
                out.append(box(x + 0.1 * wide, place_y(low + height), 0.8 * wide, place_y(low) - place_y(low + height), grey))
                low += height
            middle = x + wide / 2 + 4
            out.append(words(middle, HEIGHT - BOTTOM + 6, "end", name,
                             f' font-size="9" transform="rotate(-60 {middle:.1f} {HEIGHT - BOTTOM + 6})"'))
            x += wide
        x += wide * GAP / 2
    for grey, name in enumerate(names):
        y = TOP + 14 * (len(names) - grey)
        out += [box(WIDTH - RIGHT + 8, y - 9, 10, 10, grey), words(WIDTH - RIGHT + 22, y, "start", name)]
    return "\n".join([*out, "</svg>"]) + "\n"
