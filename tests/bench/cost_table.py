#!/usr/bin/python3
"""The table of docs/cost.md from a run: cost_bench --benchmark_out=cost.json, cost_table.py cost.json"""
import json
import sys

# Group of lines: (what it is, what to reach, what to aim at); in milliseconds.
CONTESTS = {
    "scene_c/1600/512": ("scene C, 1600 triangles, 512 x 512", "-", "-"),
    "scene_c/1600/4096": ("scene C, 1600 triangles, 4096 x 4096", "5", "3"),
    "scene_c/102400/512": ("scene C, 102 400 triangles, 512 x 512", "9", "5"),
    "scene_c/102400/4096": ("scene C, 102 400 triangles, 4096 x 4096", "35", "15"),
    "boxes/apart/512": ("100 000 boxes apart, 512 x 512", "120", "60"),
    "boxes/anywhere/512": ("100 000 boxes anywhere, 512 x 512", "120", "60"),
}
NN74 = ("a-solids", "b-prisms", "c-boxes", "d-patterns", "e-hospital", "f-hospital")
LIGHTS = ("1600/512", "1600/4096", "102400/512", "102400/4096")


def read(path):
    with open(path, encoding="utf-8") as file:
        lines = json.load(file)["benchmarks"]
    return {line["name"].removesuffix("/iterations:1/manual_time"): line for line in lines}


def number(value):
    return f"{value:.3g}" if value < 1000 else f"{value:.0f}"


def print_row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def print_head(*cells):
    print()
    print_row(*cells)
    print("|" + "---|" * len(cells))


def print_contests(lines):
    print_head("work, from canonical input to rows", "ms", "to reach", "aim", "from the scene, ms", "wrong, ppm",
               "run ends off by, columns", "Embree, ms: times faster", "Z-buffer, ms: times faster",
               "wrong, ppm: Embree, Z-buffer")
    for group, (work, reach, aim) in CONTESTS.items():
        embree, z_buffer, ours = (lines[f"{group}/{m}"] for m in ("embree", "z_buffer", "overstrike"))
        print_row(work, number(ours["cpu_ms"]), reach, aim, number(ours["from_scene_ms"]), number(ours["wrong_ppm"]),
                  f"{ours['run_end']:.0e}", f"{number(embree['cpu_ms'])}: {number(ours['x_embree'])}",
                  f"{number(z_buffer['cpu_ms'])}: {number(ours['x_zbuffer'])}",
                  f"{number(embree['wrong_ppm'])}, {number(z_buffer['wrong_ppm'])}")


def print_nn74(lines):
    print_head("NN74, Table 1, I + II + III", "ms", "to reach", "aim", "from the scene, ms", "wrong, ppm",
               "times faster than in 1974")
    for scene in NN74:
        line = lines[f"nn74-{scene}/overstrike"]
        print_row(scene, number(line["cpu_ms"]), 1, 0.3, number(line["from_scene_ms"]), number(line["wrong_ppm"]),
                  number(line["x_1974"]))


def print_ratios(lines):
    print_head("ratio", "measured", "to reach", "aim", "the Z-buffer's")
    for name in LIGHTS:
        print_row(f"scene C with light and ground, {name.replace('/', ' at ')}, to without",
                  number(lines[f"light/{name}/lit"]["x_plain"]), 3, 2, "-")
    for sides in (4, 32):
        ours, theirs = (lines[f"scene_b/{sides}/{m}/4096"]["x_first"] for m in ("overstrike", "z_buffer"))
        print_row(f"scene B, k = {sides}, 4096 rows to 512", number(ours), 4, 2, number(theirs))
    ours, theirs = (lines[f"threads/102400/4096/{m}/2"]["x_one"] for m in ("overstrike", "z_buffer"))
    print_row("scene C, 102400 at 4096, two threads: times faster", number(ours), 1.7, 1.9, number(theirs))
    for where in ("apart", "anywhere"):
        line = lines[f"boxes/{where}/512/overstrike"]
        print_row(f"100 000 boxes {where}: largest memory, MB (of them while drawing)",
                  f"{number(line['peak_mb'])} ({number(line['drawing_peak_mb'])})", 200, "-", "-")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    measured = read(sys.argv[1])
    for part in (print_contests, print_nn74, print_ratios):
        part(measured)
