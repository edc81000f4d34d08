"""Runs the command as a user would. The program's path comes in the environment, by ctest."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

OVERSTRIKE = os.environ["OVERSTRIKE"]
HERE = Path(__file__).parent
SCENE = str(HERE / "box.yaml")


def overstrike(*words, stdin=b"", folder=None, **more):
    """Status, standard output and standard error (bytes, text) of one run."""
    done = subprocess.run([OVERSTRIKE, *map(str, words)], input=stdin, capture_output=True,
                          cwd=folder, timeout=120, **more)
    return done.returncode, done.stdout, done.stderr.decode()


def devices():
    """The names of all devices, as `overstrike devices` lists them."""
    _, listing, _ = overstrike("devices")
    return [line.split()[0] for line in listing.decode().split("\n") if line[:1].strip()]


class CommandTest(unittest.TestCase):
    maxDiff = None

    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.folder = Path(held.name)

    def assert_refused(self, *words, says, stdin=b"", status=2):
        """Bad usage or input: the status, nothing on standard output, and what it must say."""
        code, out, error = overstrike(*words, stdin=stdin, folder=self.folder)
        self.assertEqual((code, out), (status, b""), error)
        for text in [says] if isinstance(says, str) else says:
            self.assertIn(text, error)
        return error

    def assert_done(self, *words, stdin=b""):
        code, out, error = overstrike(*words, stdin=stdin, folder=self.folder)
        self.assertEqual((code, error), (0, ""))
        return out

    def names(self):
        """Every file in the test's folder, hidden ones too."""
        return sorted(path.name for path in self.folder.iterdir())
