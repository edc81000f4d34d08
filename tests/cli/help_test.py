"""--help and --version word for word. OVERSTRIKE_UPDATE_GOLDEN=1 writes the golden texts anew."""

import os
import unittest

from harness import HERE, CommandTest, devices

GOLDEN = HERE / "golden"


class Help(CommandTest):
    def assert_golden(self, name, *words):
        text = self.assert_done(*words).decode()
        path = GOLDEN / name
        if os.environ.get("OVERSTRIKE_UPDATE_GOLDEN"):
            path.write_text(text)
        self.assertEqual(path.read_text(), text)

    def test_help_of_the_command(self):
        self.assert_golden("help.txt", "--help")

    def test_help_of_every_subcommand(self):
        for name in ("render", "watch", "emulate", "check", "devices"):
            self.assert_golden(f"help-{name}.txt", name, "--help")

    def test_short_help_is_the_same(self):
        self.assertEqual(self.assert_done("render", "-h"), self.assert_done("render", "--help"))

    def test_help_fits_a_wide_terminal(self):
        for path in GOLDEN.glob("*.txt"):
            longest = max(path.read_text().split("\n"), key=len)
            self.assertLessEqual(len(longest), 120, f"{path.name}: {longest}")

    def test_version(self):
        self.assertRegex(self.assert_done("--version").decode(), r"^overstrike \d+\.\d+\.\d+\n$")

    def test_devices(self):
        self.assertIn("line-printer", devices())
        for name in devices():
            settings = self.assert_done("devices", name).decode()
            self.assertTrue(settings.startswith(f"{name}: "))
            self.assertIn("default", settings)
        self.assertRegex(self.assert_done("devices", "line-printer").decode(), r"lpi +\d")


if __name__ == "__main__":
    unittest.main()
