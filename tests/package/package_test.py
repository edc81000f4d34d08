"""The installed package works for somebody else: installs the build into a prefix of its own, builds
a small outside project against it, and looks at the page that the project prints.

usage: package_test.py BUILD_DIR SOURCE_DIR COMPILER CXX_FLAGS
"""

import subprocess
import sys
import tempfile
from pathlib import Path


def run(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
    return done.stdout


def check_page(page):
    """A box, seen: 20 lines, at most 40 columns, ink in the middle and none in the corners."""
    lines = page.split("\n")
    assert len(lines) == 21 and lines[-1] == "", f"{len(lines) - 1} lines\n{page}"
    assert all(len(line) <= 40 for line in lines), page
    assert lines[10].ljust(40)[18:22].strip(), f"nothing in the middle\n{page}"
    kinds = set(page) - set(" \n")
    assert len(kinds) >= 2, f"one tone only: {kinds}\n{page}"


def check_prefix(prefix, version_words):
    for name in ("bin/overstrike", "include/overstrike/core/drawing.h",
                 "include/overstrike/devices/device.h", "share/overstrike/scenes"):
        assert (prefix / name).exists(), f"{name} was not installed"
    assert run(prefix / "bin/overstrike", "--version").split() == version_words


def main(build, source, compiler, flags):
    with tempfile.TemporaryDirectory() as folder:
        prefix = Path(folder) / "prefix"
        run("cmake", "--install", build, "--prefix", prefix)
        check_prefix(prefix, ["overstrike", "0.1.0"])
        outside = Path(folder) / "outside"
        run("cmake", "-G", "Ninja", "-S", Path(source) / "tests/package/outside", "-B", outside,
            f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_CXX_COMPILER={compiler}",
            f"-DCMAKE_CXX_FLAGS={flags}", "-DCMAKE_BUILD_TYPE=Debug")
        run("cmake", "--build", outside)
        scene = Path(source) / "tests/package/outside/scene.yaml"
        check_page(run(outside / "outside", scene))


if __name__ == "__main__":
    main(*sys.argv[1:])
