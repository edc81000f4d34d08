#!/usr/bin/python3
"""Boolean solids beside other programs: solid_peers.py build/release/bin/overstrike docs/solid-peers.md

Whole processes draw the same tree from the same view at 512 x 512, one thread each, in turns; the page's table is written anew.
POV-Ray and OpenSCAD take part where they are installed (Debian's povray; openscad, xvfb and libgl1-mesa-dri).
"""
import os
import pathlib
import re
import resource
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "openscad"))

import peer_scenes  # noqa: E402
import silhouettes  # noqa: E402

SIZE, ROUNDS = 512, 5
LIMIT_S, WALL_LIMIT_S = 60, 300  # of CPU; of the wall's clock, for what only waits
LONG_S = 3  # is measured once
NOTHING = "nothing is drawn"
MARK = "<!-- what follows is written by tests/bench/solid_peers.py -->\n"


class Peer:
    """A way to draw `stem` with its files of all languages beside it, or why it cannot."""

    def __init__(self, name, needs, command, picture=None):
        self.name, self.command, self.picture = name, command, picture
        self.missing = [tool for tool in needs if not shutil.which(tool)]


def peers(overstrike):
    def ours(*more):
        return lambda stem, scene: [overstrike, "render", f"{stem}.yaml", "--threads", "1", *more]

    def povray(*more):
        return lambda stem, scene: ["povray", f"+I{stem}.pov", f"+W{SIZE}", f"+H{SIZE}", "+WT1", "-A", "-D", "-GA", *more]

    def preview(stem, scene):
        return ["openscad", "-o", f"{stem}-openscad.png", f"--imgsize={SIZE},{SIZE}", "--projection=o",
                f"--camera={peer_scenes.scad_camera(scene)}", f"{stem}.scad"]

    page = ["-d", "line-printer", "-o", os.devnull, "--size", f"{SIZE}x{SIZE}", "--cpi", "10", "--lpi", "10"]
    return [
        Peer("Overstrike, page, one line through each row", [], ours(*page, "--tolerance", "2")),
        Peer("Overstrike, page, areas within 0.05", [], ours(*page)),
        Peer("Overstrike, PNG, the same", [], lambda stem, scene: ours("-o", f"{stem}.png", "--size", f"{SIZE}x{SIZE}")(stem, scene)),
        Peer("POV-Ray", ["povray"], povray("-F"), lambda stem, scene: povray(f"+O{stem}-pov.png")(stem, scene)),
        Peer("OpenSCAD, preview", ["openscad", "Xvfb"], preview, preview),
        Peer("OpenSCAD, surface as STL", ["openscad"], lambda stem, scene: ["openscad", "-o", f"{stem}.stl", f"{stem}.scad"]),
    ]


def cost(command, environment):
    """(CPU seconds of the process and its children, seconds) or why there are none."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (LIMIT_S, LIMIT_S + 1))

    began = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment, preexec_fn=limit)
    while True:
        pid, status, used = os.wait4(process.pid, os.WNOHANG)
        if pid:
            break
        if time.monotonic() - began > WALL_LIMIT_S:
            process.kill()
        time.sleep(0.0005)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"over {LIMIT_S} s"
    if process.returncode != 0:
        return f"fails with {process.returncode}"
    return used.ru_utime + used.ru_stime, time.monotonic() - began


def measure(all_peers, stems, environment):
    """(scene, peer) -> list of costs, or why there are none; all take turns."""
    found = {}
    for turn in range(ROUNDS):
        for scene, stem in stems.items():
            for peer in all_peers:
                so_far = found.get((scene, peer.name), [])
                if peer.missing or isinstance(so_far, str) or (so_far and so_far[0][1] > LONG_S):
                    continue
                one = cost(peer.command(stem, peer_scenes.SCENES[scene]), environment)
                found[scene, peer.name] = one if isinstance(one, str) else so_far + [one]
            print(f"round {turn + 1} of {ROUNDS}: {scene}", file=sys.stderr, flush=True)
    return found


def text_of(found, first, picture):
    """Milliseconds of CPU, of the wall's clock, and how many times as long as ours."""
    if not found:
        return "missing"
    if isinstance(found, str):
        return found
    cpu, wall = (statistics.median(values) for values in zip(*found))
    text = f"{1000 * cpu:.0f} ({1000 * wall:.0f})"
    if picture == NOTHING:
        return f"{text}, {NOTHING}"
    times = cpu / statistics.median(c for c, _ in first)
    return text if found is first else f"{text}, {times:.0f} x" if times >= 100 else f"{text}, {times:.2g} x"


def times_table(all_peers, found, pictures):
    rows = ["| scene | " + " | ".join(peer.name for peer in all_peers) + " |", "|---" * (1 + len(all_peers)) + "|"]
    for scene in peer_scenes.SCENES:
        first = found[scene, all_peers[0].name]
        cells = [text_of(found.get((scene, peer.name)), first, pictures.get((scene, peer.name))) for peer in all_peers]
        rows.append(f"| {scene} | " + " | ".join(cells) + " |")
    return rows


def mask_of_ours(overstrike, stem):
    finer = silhouettes.FINER * SIZE
    subprocess.run([overstrike, "render", f"{stem}.yaml", "-o", f"{stem}.pgm", "--size", f"{finer}x{finer}", "--density", "0,1",
                    "--no-light"], check=True)
    return silhouettes.of_ours(f"{stem}.pgm")


def differing(peer, stem, scene, ours, found, environment):
    """Pixels of our silhouette that are otherwise in the peer's."""
    if not found or isinstance(found, str):
        return "-" if found else "missing"
    command = peer.picture(stem, scene)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
    picture = next(word.removeprefix("+O") for word in command if word.endswith(".png"))
    theirs = silhouettes.of_openscad(picture)
    if not any(map(any, theirs)):
        return NOTHING
    _, wrong, far = silhouettes.difference(theirs, ours)
    return f"{wrong}, {far}"


def compare_pictures(overstrike, all_peers, stems, found, environment):
    """scene -> pixels of our silhouette, and (scene, peer) -> those that differ."""
    pixels, differ = {}, {}
    for scene, stem in stems.items():
        ours = mask_of_ours(overstrike, stem)
        pixels[scene] = sum(map(sum, ours))
        for peer in all_peers:
            if peer.picture:
                differ[scene, peer.name] = differing(peer, stem, peer_scenes.SCENES[scene], ours, found.get((scene, peer.name)),
                                                     environment)
    return pixels, differ


def pictures_table(all_peers, pixels, differ):
    shown = [peer.name for peer in all_peers if peer.picture]
    rows = ["| scene | pixels | " + " | ".join(f"{name}: differ, farther than one from an edge" for name in shown) + " |",
            "|---" * (2 + len(shown)) + "|"]
    for scene, count in pixels.items():
        rows.append(f"| {scene} | {count} | " + " | ".join(differ[scene, name] for name in shown) + " |")
    return rows


def versions():
    """What took part."""
    found = []
    for tool in ("povray", "openscad"):
        if shutil.which(tool):
            done = subprocess.run([tool, "--version"], capture_output=True, text=True, check=False)
            number = re.search(r"\d+\.[\d.]*\d", re.sub(r"cannot open.*", "", done.stdout + done.stderr))
            found.append(f"{tool} {number[0] if number else '?'}")
        else:
            found.append(f"{tool} is not installed")
    return ", ".join(found)


def start_display(environment):
    """A screen for OpenSCAD's preview, which is no part of what is measured."""
    if not shutil.which("Xvfb"):
        return None
    ask, answer = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(answer), "-screen", "0", "800x600x24"], pass_fds=[answer],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(answer)
    with os.fdopen(ask) as number:
        environment["DISPLAY"] = f":{number.readline().strip()}"
    return server


def main(overstrike, page):
    # llvmpipe's threads.
    environment = {**os.environ, "LP_NUM_THREADS": "1"}
    server = start_display(environment)
    try:
        with tempfile.TemporaryDirectory() as folder:
            stems = {}
            for i, (name, scene) in enumerate(peer_scenes.SCENES.items()):
                stems[name] = pathlib.Path(folder) / str(i)
                for ending, text in (("yaml", peer_scenes.yaml), ("scad", peer_scenes.scad), ("pov", peer_scenes.pov)):
                    pathlib.Path(f"{stems[name]}.{ending}").write_text(text(scene), encoding="utf-8")
            all_peers = peers(overstrike)
            found = measure(all_peers, stems, environment)
            pixels, differ = compare_pictures(overstrike, all_peers, stems, found, environment)
            rows = [f"Measured: {versions()}.", "", *times_table(all_peers, found, differ), "",
                    *pictures_table(all_peers, pixels, differ)]
    finally:
        if server:
            server.terminate()
            server.wait()
    head = page.read_text(encoding="utf-8").split(MARK)[0]
    page.write_text(head + MARK + "\n" + "\n".join(rows) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]))
