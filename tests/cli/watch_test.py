"""overstrike watch: draws anew when a file is saved, in whatever way; says what is wrong; ends well."""

import os
import signal
import termios
import unittest

from harness import SCENE, CommandTest
from watching import Watching, picture

ONE = "bodies: [{box: 1}]\n"
TWO = "bodies: [{box: [1, 1, 3]}, {sphere: 1, at: [2, 0, 1]}]\n"
CUBE = """OFF
8 6 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 {h}
1 0 {h}
1 1 {h}
0 1 {h}
4 3 2 1 0
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
"""


class Watch(CommandTest):
    def setUp(self):
        super().setUp()
        self.scene = self.folder / "scene.yaml"
        self.scene.write_text(ONE)

    def watching(self, *words, **window):
        watching = Watching(self.scene, *words, **window)
        self.addCleanup(watching.close)
        return watching

    def save_by_renaming(self, text):
        (self.folder / "new").write_text(text)
        os.rename(self.folder / "new", self.scene)

    def expected(self, text, columns=40, lines=12, *words):
        file = self.folder / "expected.yaml"
        file.write_text(text)
        return picture(file, columns, lines, *words)

    def assert_seen(self, watching, *wanted):
        seen = watching.read_until(*wanted)
        for one in wanted:
            self.assertTrue(one in seen, f"{one[:200]} is not in what ends {seen[-300:]}")

    def test_draws_what_is_saved_in_place_and_by_renaming(self):
        one, two = self.expected(ONE), self.expected(TWO)
        self.assertNotEqual(one, two)
        watching = self.watching()
        self.assert_seen(watching, one, b": drawn, ")
        self.scene.write_text(TWO)
        self.assert_seen(watching, two)
        self.save_by_renaming(ONE)
        self.assert_seen(watching, one)
        self.save_by_renaming(TWO)
        self.assert_seen(watching, two)

    def test_says_what_is_wrong_and_keeps_the_picture(self):
        one, two = self.expected(ONE), self.expected(TWO)
        watching = self.watching(columns=100)
        one, two = self.expected(ONE, 100), self.expected(TWO, 100)
        self.assert_seen(watching, one)
        self.scene.write_text("bodies: [{bux: 1}]\n")
        self.assert_seen(watching, one, b"scene.yaml:1:11: error: unknown key 'bux'", b": not drawn, ")
        self.scene.write_text(TWO)
        self.assert_seen(watching, two, b": drawn, ")

    def test_waits_for_a_file_that_is_wrong_from_the_start(self):
        self.scene.write_text("bodies: [")
        watching = self.watching()
        self.assert_seen(watching, b"error: ", b": not drawn, ")
        self.save_by_renaming(TWO)
        self.assert_seen(watching, self.expected(TWO))

    def test_follows_the_window(self):
        watching = self.watching()
        self.assert_seen(watching, self.expected(ONE))
        watching.resize(60, 20)
        self.assert_seen(watching, self.expected(ONE, 60, 20))

    def test_takes_the_views_and_settings_of_render(self):
        words = ["--azimuth", "20", "--light", "0,45", "--set", "color=true"]
        self.assert_seen(self.watching(*words), self.expected(ONE, 40, 12, *words))

    def test_meshes_are_watched_where_they_are(self):
        parts = self.folder / "parts"
        parts.mkdir()
        mesh = parts / "cube.off"
        self.scene.write_text("bodies: [{mesh: parts/cube.off}]\n")
        mesh.write_text(CUBE.format(h=1))
        low = picture(self.scene, 100, 12)
        watching = self.watching(columns=100)
        self.assert_seen(watching, low)
        mesh.write_text("OFF\nnothing\n")
        self.assert_seen(watching, low, b"error: ")
        mesh.write_text(CUBE.format(h=3))
        high = picture(self.scene, 100, 12)
        self.assertNotEqual(high, low)
        self.assert_seen(watching, high)

    def test_ends_and_leaves_the_terminal_as_it_was(self):
        for ending, status in [(b"q", 130), (b"\x03", 130), (signal.SIGINT, 130), (signal.SIGTERM, 143)]:
            watching = self.watching()
            self.assert_seen(watching, self.expected(ONE))
            if isinstance(ending, bytes):
                watching.press(ending)
            else:
                os.kill(watching.process.pid, ending)
            code, said = watching.ended()
            self.assertEqual(code, status)
            self.assertTrue(said.endswith(b"\033[?25h\033[?1049l"), said)
            self.assertEqual(termios.tcgetattr(watching.window), watching.modes)

    def test_refuses_what_cannot_be_watched(self):
        self.assert_refused("watch", says="SCENE is missing")
        self.assert_refused("watch", "-", says="standard input cannot be saved anew")
        self.assert_refused("watch", SCENE, says="standard output must be a terminal")
        self.assert_refused("watch", SCENE, "-o", "a.txt", says="unknown option '-o'")
        watching = Watching(self.folder / "none.yaml")
        self.addCleanup(watching.close)
        code, said = watching.ended()
        self.assertEqual(code, 2)
        self.assertIn(b"none.yaml", said)
        self.assertNotIn(b"\033[?1049h", said)


if __name__ == "__main__":
    unittest.main()
