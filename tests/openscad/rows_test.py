"""The rows of examples_test.py where OpenSCAD has no result: which of them are right."""
import tempfile
import types
import unittest
from unittest import mock

import examples_test


class RowsWithoutResult(unittest.TestCase):
    def row(self, said, blank):
        """Of an example that we draw, when OpenSCAD writes no file and says that."""
        answer = types.SimpleNamespace(returncode=0, stdout="", stderr=said)
        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.dict("os.environ", OVERSTRIKE="overstrike"), \
                mock.patch.object(examples_test, "run", return_value=answer), \
                mock.patch.object(examples_test.silhouettes, "is_blank", return_value=blank), \
                mock.patch.object(examples_test.Example, "export", return_value=True):
            return examples_test.Example(folder + "/a.scad", folder).row()

    def test_empty_is_right_where_we_draw_nothing(self):
        self.assertTrue(self.row("Current top level object is empty.\n", True)[0])

    def test_empty_is_wrong_where_we_draw_something(self):
        self.assertFalse(self.row("Current top level object is empty.\n", False)[0])

    def test_no_result_for_another_reason_is_wrong(self):
        for said in ("", "ERROR: CGAL error\n"):
            right, cells = self.row(said, True)
            self.assertFalse(right)
            self.assertEqual(cells[1], "no result of OpenSCAD's")


if __name__ == "__main__":
    unittest.main()
