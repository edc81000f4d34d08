#!/usr/bin/env python3
"""How long `overstrike watch` takes from the saving of a file (its rename) to the last byte on the terminal.

usage: OVERSTRIKE=build/release/bin/overstrike tests/bench/watch_latency.py [SIDES]

Nine prisms in a square, the middle one taken from the eight others, in a window of 120 x 40."""

import os
import statistics
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "cli"))
from watching import Watching  # noqa: E402

SAVINGS = 60


def scene(sides, height):
    prism = f"prism: {{sides: {sides}, radius: 1, height: {height}}}"
    around = [(x, y) for x in (-1.2, 0, 1.2) for y in (-1.2, 0, 1.2) if (x, y) != (0, 0)]
    lines = [f"      - {{{prism}, at: [{x}, {y}, 0]}}" for x, y in around]
    tool = f"      - {{{prism}, at: [0, 0, 0.5], density: 0.6}}"
    return "\n".join(["bodies:", "  - difference:", "      - group:", *("    " + line for line in lines), tool, ""])


def processor_ms(pid):
    """What all its threads have used so far."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(") ", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) * 1000 / os.sysconf("SC_CLK_TCK")


def main():
    sides = int(sys.argv[1]) if len(sys.argv) > 1 else 32
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "prisms.yaml"
        file.write_text(scene(sides, 2))
        watching = Watching(file, columns=120, lines=40)
        watching.read_until(b": drawn, ")
        taken, before = [], processor_ms(watching.process.pid)
        for i in range(SAVINGS):
            fresh = Path(folder) / "new"
            fresh.write_text(scene(sides, 2 + i % 7 / 10))
            start = time.perf_counter()
            os.rename(fresh, file)
            watching.read_until(b": drawn, ")
            taken.append((time.perf_counter() - start) * 1000)
        used = (processor_ms(watching.process.pid) - before) / SAVINGS
        watching.press(b"q")
        watching.ended()
        watching.close()
    print(f"nine prisms of {sides} sides, 120 x 40: from rename to last byte, of {SAVINGS} savings "
          f"median {statistics.median(taken):.1f} ms, worst {max(taken):.1f} ms; {used:.1f} ms of processors each")


main()
