"""The dependency check catches what it is there to catch: violations are planted in a small house."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).with_name("dependencies.py")


def check(files):
    """Runs the check over a house of these files: exit status and what it said."""
    with tempfile.TemporaryDirectory() as folder:
        for room in ("core", "scenes/readers", "devices", "emulators", "cli"):
            (Path(folder) / room).mkdir(parents=True)
        for name, text in files.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        done = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
    return done.returncode, done.stderr


class DependencyCheck(unittest.TestCase):
    def assert_caught(self, name, include, why):
        status, said = check({name: f"#pragma once\n{include}\n"})
        self.assertEqual(status, 1)
        self.assertIn(f"{name}:2: error:", said)
        self.assertIn(why, said)

    def test_a_right_house_passes(self):
        status, said = check({
            "core/a.h": "#include <vector>\n#include \"core/b.h\"\n",
            "devices/plotter/plotter.cpp": '#include "core/picture.h"\n#include "devices/device.h"\n',
            "scenes/readers/yaml.cpp": '#include "core/scene/scene.h"\n#include "scenes/readers/read.h"\n',
            "emulators/plotter/sheet.h": "#include <cairo/cairo.h>\n#include \"emulators/plotter/pen.h\"\n",
            "cli/render.cpp": '#include <iostream>\n#include "emulators/plotter/sheet.h"\n',
            "core/a_test.cpp": "#include <fstream>\n",
        })
        self.assertEqual((status, said), (0, ""))

    def test_core_knows_nobody(self):
        self.assert_caught("core/a.h", '#include "devices/device.h"', "core may not depend on devices/device.h")
        self.assert_caught("core/geometry/a.cpp", '#include "scenes/readers/read.h"', "core may not depend")
        self.assert_caught("core/a.h", "#include <cli/options.h>", "core may not depend on cli/options.h")

    def test_readers_and_devices_know_core_only(self):
        self.assert_caught("scenes/readers/a.cpp", '#include "devices/device.h"', "scenes/readers may not depend")
        self.assert_caught("devices/image/a.cpp", '#include "scenes/readers/read.h"', "devices may not depend")

    def test_a_device_never_includes_its_emulator(self):
        self.assert_caught("devices/plotter/plotter.h", '#  include "emulators/plotter/sheet.h"',
                           "devices may not depend on emulators/plotter/sheet.h")

    def test_emulators_know_nobody(self):
        self.assert_caught("emulators/plotter/a.h", '#include "core/error.h"', "emulators may not depend")
        self.assert_caught("emulators/plotter/a_test.cpp", '#include "devices/device.h"', "emulators may not depend")

    def test_libraries_do_not_print(self):
        self.assert_caught("core/a.cpp", "#include <cstdio>", "core may not use <cstdio>")
        self.assert_caught("devices/a.cpp", "#include <iostream>", "devices may not use <iostream>")

    def test_includes_are_by_path_from_the_root(self):
        self.assert_caught("core/geometry/a.cpp", '#include "a.h"', '"a.h" is not included by its path')

    def test_a_folder_that_is_no_house_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, CHECK, folder], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
