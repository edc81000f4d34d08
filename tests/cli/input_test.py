"""Bad files: status 2 with the file's name, never a crash, nothing left behind."""

import unittest

from harness import SCENE, CommandTest


class Input(CommandTest):
    def assert_bad_scene(self, name, says):
        for words in (["render", name, "-o", "page.txt"], ["check", name]):
            self.assert_refused(*words, says=says)
        self.assertNotIn("page.txt", self.names())

    def write(self, name, content):
        (self.folder / name).write_bytes(content)

    def test_nn74_names_two_bodies_that_interpenetrate(self):
        self.write("two.yaml", b"bodies:\n  - {name: left, box: [2, 2, 2]}\n"
                               b"  - {name: right, box: [2, 2, 2], at: [1, 0, 0]}\n")
        self.assert_refused("render", "two.yaml", "-o", "page.txt", "--method", "nn74",
                            says=["left", "right", "interpenetrate", "two.yaml:"])
        self.assertNotIn("page.txt", self.names())

    def test_missing_file(self):
        self.assert_bad_scene("none.yaml", ["none.yaml", "error:"])
        self.assert_bad_scene("none.stl", ["none.stl", "error:"])

    def test_directory(self):
        (self.folder / "folder.yaml").mkdir()
        self.assert_bad_scene("folder.yaml", "folder.yaml")

    def test_empty_files(self):
        for name in ("a.yaml", "a.stl", "a.obj", "a.off", "a.ply"):
            self.write(name, b"")
            self.assert_bad_scene(name, [name, "error:"])

    def test_binary_files(self):
        for name in ("a.yaml", "a.obj", "a.off", "a.ply", "a.stl"):
            self.write(name, bytes(range(256)) * 8)
            self.assert_bad_scene(name, [name, "error:"])

    def test_unknown_extension(self):
        self.write("scene.docx", b"bodies: []\n")
        self.assert_bad_scene("scene.docx", ["scene.docx", "yaml"])

    def test_errors_have_a_place_and_a_caret(self):
        self.write("a.yaml", b"bodies:\n  - box: {size: [1, 1, 1]}\n    shadin: flat\n")
        self.assert_bad_scene("a.yaml", ["a.yaml:3:5: error:", "did you mean 'shading'?", "^"])

    def test_all_errors_are_named(self):
        self.write("a.yaml", b"bodies:\n  - box: {size: [1, 1]}\n  - sphere: {radius: nan}\n")
        self.assert_bad_scene("a.yaml", ["a.yaml:2:", "a.yaml:3:"])

    def test_standard_input(self):
        self.assert_refused("check", "-", says="<stdin>")
        self.assert_refused("render", "-", "-d", "line-printer", stdin=b"bodies: 3\n",
                            says="<stdin>:1:9: error:")
        self.assert_refused("check", "-", "--format", "stl", stdin=b"solid\nfacet\n",
                            says="<stdin>")

    def test_emulators_read_what_is_there(self):
        self.assert_refused("emulate", "line-printer", "none.txt", "-o", "a.png", says="none.txt")
        self.assert_refused("emulate", "plotter", str(self.folder), "-o", "a.png",
                            says=str(self.folder))

    def test_check_says_what_is_in_a_scene(self):
        out = self.assert_done("check", SCENE).decode()
        self.assertIn("1 body (1 closed), 8 vertices, 12 edges, 6 faces", out)


if __name__ == "__main__":
    unittest.main()
