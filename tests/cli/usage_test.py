"""What is said wrong on the command line: status 2, the option named, and what was expected."""

import unittest

from harness import SCENE, CommandTest


class Usage(CommandTest):
    def test_subcommands(self):
        self.assert_refused(says=["a subcommand is missing", "try 'overstrike --help'"])
        self.assert_refused("rendr", says=["did you mean 'render'?", "try 'overstrike --help'"])
        self.assert_refused("--verzion", says="did you mean '--version'?")

    def test_options(self):
        self.assert_refused("render", SCENE, "--ligth", "-20,45",
                            says=["unknown option '--ligth'", "did you mean '--light'?",
                                  "try 'overstrike render --help'"])
        self.assert_refused("render", says="SCENE is missing")
        self.assert_refused("render", SCENE, "--size=", says="--size: a value is missing")
        self.assert_refused("render", SCENE, "again.yaml", says="unexpected word 'again.yaml'")

    def test_numbers(self):
        wrong = {
            "--light": ["nan,45", "0", "0,45,1", "0,inf", "a,b", "0,91", "--no-light"],
            "--eye": ["1,2", "1,2,x", "1,2,nan"],
            "--up": ["0,0,0"],
            "--distance": ["0", "-1", "inf"],
            "--parallel": ["0", "-3", "wide"],
            "--fov": ["0", "180", "1e"],
            "--elevation": ["91"],
            "--ground": ["nan", "low"],
            "--density": ["0.8", "2,1", "-1,1"],
            "--tolerance": ["0", "-1", "nan"],
            "--threads": ["-1", "1.5", "many", "99999999999"],
        }
        for option, values in wrong.items():
            for value in values:
                self.assert_refused("render", SCENE, "-d", "line-printer", option, value,
                                    says=[f"{option}: expected ", f"found '{value}'"])

    def test_device_settings(self):
        wrong = {"--size": ["135", "0x10", "135x", "x", "-1x5", "nanx1", "1e9x1e9"],
                 "--lpi": ["0", "25", "nan", "-6", "six"], "--levels": ["0", "1", "1.5", "x"],
                 "--strikes": ["0", "100"], "--stream": ["crlf"]}
        for option, values in wrong.items():
            for value in values:
                self.assert_refused("render", SCENE, "-d", "line-printer", "-o", "a.txt", option, value,
                                    says=[f"overstrike: error: {option} must be ", f"'{value}'",
                                          "try 'overstrike render --help'"])
        self.assert_refused("render", SCENE, "-d", "line-printer", "-o", "a.txt", "--lpi", "8",
                            "--set", "lpi=99", says=["error: --set lpi must be ", "'99'"])
        self.assertEqual(self.names(), [])

    def test_settings_of_another_device(self):
        self.assert_refused("render", SCENE, "-d", "plotter", "--strikes", "3",
                            says="the plotter has no setting 'strikes'")
        self.assert_refused("render", SCENE, "-d", "line-printer", "--set", "lip=8",
                            says=["no setting 'lip'", "did you mean 'lpi'?"])
        self.assert_refused("render", SCENE, "--set", "lpi", says="--set: expected NAME=VALUE")

    def test_what_excludes_each_other(self):
        self.assert_refused("render", SCENE, "--fov", "30", "--fit", says="--fov excludes --fit")
        self.assert_refused("render", SCENE, "--eye", "1,2,3", "--azimuth", "3",
                            says="--eye excludes --azimuth")

    def test_choice_of_the_device(self):
        self.assert_refused("render", SCENE, says=["-d", "line-printer", "terminal"])
        self.assert_refused("render", SCENE, "-o", "-", says="-o - needs -d")
        self.assert_refused("render", SCENE, "-d", "line-printr", says="did you mean 'line-printer'?")
        self.assert_refused("render", SCENE, "-o", "page.xyz", says=[".xyz", ".txt", ".hpgl", ".png"])
        self.assert_refused("render", SCENE, "-o", "page", says="without extension")
        self.assert_refused("devices", "ploter", says="did you mean 'plotter'?")

    def test_methods(self):
        self.assert_refused("render", SCENE, "-d", "line-printer", "--method", "nn47",
                            says=["expected auto, line or nn74", "did you mean 'nn74'?"])

    def test_formats(self):
        self.assert_refused("render", SCENE, "-d", "line-printer", "--format", "yaml",
                            says="--format is for standard input")
        self.assert_refused("render", "-", "-d", "line-printer", "--format", "ymal",
                            says=["--format: expected one of", "did you mean 'yaml'?"])

    def test_emulate(self):
        self.assert_refused("emulate", "typewriter", "a.txt", "-o", "a.png",
                            says=["typewriter", "line-printer", "plotter"])
        self.assert_refused("emulate", "plotter", "a.hpgl", says="-o FILE is missing")
        (self.folder / "a.txt").write_text("HELLO\n")
        self.assert_refused("emulate", "line-printer", "a.txt", "-o", "a.jpeg", says="a.jpeg")
        self.assert_refused("emulate", "line-printer", "a.txt", "-o", "a.png", "--lpi", "nan",
                            says="error: --lpi: expected a number from")
        self.assert_refused("emulate", "line-printer", "a.txt", "-o", "a.png", "--stream", "crlf",
                            says=["error: --stream must be one of", "try 'overstrike emulate --help'"])
        self.assert_refused("emulate", "line-printer", "a.txt", "-o", "a.png", "--set", "margin=9",
                            says="error: --set margin: expected inches from")
        self.assertEqual(self.names(), ["a.txt"])


if __name__ == "__main__":
    unittest.main()
