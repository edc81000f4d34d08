"""The same bits from every compiler, at every level of optimisation, with and without wide vectors: builds core and the
digest of the hard and the random scenes anew for each, and compares what they print."""

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

SOURCE = Path(__file__).parents[2]
BUILDS = Path(os.environ.get("OVERSTRIKE_BINARY_DIR", SOURCE / "build" / "release")) / "digests"

# Name, compiler, flags. The x86-64 levels: v1 has SSE2 only, v3 has AVX2 and FMA, v4 has AVX-512.
VARIANTS = [
    ("g++-O0", "g++", "-O0"),
    ("g++-O3", "g++", "-O3"),
    ("clang++-O2", "clang++-14", "-O2"),
    ("g++-O3-v3", "g++", "-O3 -march=x86-64-v3"),
    ("clang++-O3-v3", "clang++-14", "-O3 -march=x86-64-v3"),
    ("g++-O3-v4", "g++", "-O3 -march=x86-64-v4"),
]
NEEDED = {"v3": {"avx2", "fma", "bmi2"}, "v4": {"avx512f", "avx512bw", "avx512dq", "avx512vl"}}


def processor_flags():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("flags"):
            return set(line.split(":")[1].split())
    return set()


def runs_here(flags):
    return all(needed <= processor_flags() for level, needed in NEEDED.items() if flags.endswith(level))


def digest(name, compiler, flags):
    folder = BUILDS / name
    configure = ["cmake", "-S", SOURCE, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_COMPILER={compiler}",
                 f"-DCMAKE_CXX_FLAGS={flags}", "-DOVERSTRIKE_BENCHMARKS=OFF"]
    for command in (configure, ["cmake", "--build", folder, "--target", "digest"]):
        subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return subprocess.run([folder / "bin" / "digest"], check=True, capture_output=True, text=True).stdout.splitlines()


class Digests(unittest.TestCase):
    def test_every_build_draws_the_same_bits(self):
        expected = None
        for name, compiler, flags in VARIANTS:
            if not runs_here(flags):
                print(f"{name}: not on this processor", file=sys.stderr)
                continue
            self.assertTrue(shutil.which(compiler), f"{compiler} is missing: ./dev install-packages")
            found = digest(name, compiler, flags)
            self.assertGreater(len(found), 300)
            expected = expected or found
            self.assertEqual(expected, found, f"{name} is not {VARIANTS[0][0]}")


if __name__ == "__main__":
    unittest.main()
