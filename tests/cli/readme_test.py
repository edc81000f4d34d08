"""The README shows what the command really prints. OVERSTRIKE_UPDATE_GOLDEN=1 writes it anew."""

import os
import re
import unittest

from harness import HERE, CommandTest

ROOT = HERE.parent.parent
README = ROOT / "README.md"
SCENE = ROOT / "scenes/ten-lines.yaml"


def block(name):
    """The fenced block after `<!-- name -->`."""
    return re.compile(rf"(<!-- {name} -->\n```\w*\n)(.*?)(```)", re.S)


class Readme(CommandTest):
    def assert_block(self, name, text):
        readme = README.read_text()
        if os.environ.get("OVERSTRIKE_UPDATE_GOLDEN"):
            readme = block(name).sub(lambda match: match[1] + text + match[3], readme)
            README.write_text(readme)
        self.assertEqual(block(name).search(readme)[2], text)

    def test_the_scene_is_the_file(self):
        self.assert_block("scene", SCENE.read_text())

    def test_the_page_is_the_real_output(self):
        words = re.search(r"`overstrike (render scenes/ten-lines.yaml .*?)`", README.read_text())[1]
        page = self.assert_done(*words.replace("scenes/ten-lines.yaml", str(SCENE)).split()).decode()
        lines = [line.rstrip() for line in page.split("\n")]
        self.assert_block("page", "\n".join(lines))

    def test_the_pictures_are_small_enough(self):
        pictures = set(re.findall(r"\((docs/images/.*?)\)", README.read_text()))
        self.assertTrue(pictures)
        self.assertLess(sum((ROOT / name).stat().st_size for name in pictures), 400_000)


if __name__ == "__main__":
    unittest.main()
