"""A picture of a thousand million cells streams: memory does not grow with it."""

import json
import unittest
from pathlib import Path

from harness import CommandTest, overstrike

HOSPITAL = Path(__file__).parents[2] / "scenes" / "nn74-e-hospital.yaml"


class Large(CommandTest):
    def test_32768_rows_of_32768_cells_peak_under_300_mb(self):
        code, _, error = overstrike("render", HOSPITAL, "-o", "big.png", "--size", "32768x32768",
                                    "--timings=json", folder=self.folder)
        self.assertEqual(code, 0, error)
        self.assertLess(json.loads(error.splitlines()[-1])["peak_bytes"], 300e6)


if __name__ == "__main__":
    unittest.main()
