"""Import's check of columns and signs on drawn arms: one log in a hundred of tools/log_check_figures.py,
which measures it on 200."""

import json
import subprocess
import sys
import unittest

from program import PROGRAM, ROOT


class LogChecks(unittest.TestCase):
    def test_good_logs_are_accepted_and_others_refused(self):
        result = subprocess.run(
            [sys.executable, str(ROOT / "tools" / "log_check_figures.py"), "--limber", PROGRAM,
             "--logs", "2", "--seed", "7"],
            capture_output=True, encoding="utf-8", check=False,
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        counts = json.loads(result.stdout)
        self.assertEqual(counts["good"], {"logs": 2, "refused": 0})
        for case in ("mirrored", "one mirrored", "permuted"):
            found = counts[case]
            self.assertEqual(found["refused"] + found["undecidable"], found["logs"], case)


if __name__ == "__main__":
    unittest.main()
