"""The same bytes from Debug and Release, from any compiler and any number of threads: digests of what every scene becomes
on the machines that get text. After a change that is meant to show: OVERSTRIKE_UPDATE_GOLDEN=1 and look at the pictures."""

import hashlib
import os
import unittest
from pathlib import Path

from harness import HERE, CommandTest

SCENES = Path(__file__).parents[2] / "scenes"
GOLDEN = HERE / "golden" / "digests.txt"


class Digests(CommandTest):
    def digest(self, scene, device, *words):
        out = self.assert_done("render", scene, "-d", device, "-o", "-", *words)
        return hashlib.sha256(out).hexdigest()[:16]

    def test_every_scene_has_its_bytes(self):
        lines = []
        for scene in sorted(SCENES.glob("*.yaml")):
            page = self.digest(scene, "line-printer", "--size", "90x60")
            lines.append(f"{scene.stem} page {page}")
        found = "\n".join(lines) + "\n"
        if os.environ.get("OVERSTRIKE_UPDATE_GOLDEN"):
            GOLDEN.write_text(found)
        self.assertEqual(GOLDEN.read_text(), found)

    def test_plotted_sheets_have_their_bytes(self):
        golden = HERE / "golden" / "sheets.txt"
        names = ("nn74-c-boxes", "nn74-d-patterns", "nn74-e-hospital", "cyclic")
        found = "".join(f"{n} sheet {self.digest(SCENES / (n + '.yaml'), 'plotter')}\n" for n in names)
        if os.environ.get("OVERSTRIKE_UPDATE_GOLDEN"):
            golden.write_text(found)
        self.assertEqual(golden.read_text(), found)


if __name__ == "__main__":
    unittest.main()
