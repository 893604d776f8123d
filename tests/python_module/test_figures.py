"""The figures of docs/python.md, on a machine that does nothing else: label soak."""

import json
import subprocess
import sys
import unittest

from chain import PROGRAM, ROOT

MIN_SHARE = 0.9  # of the C++ rate, for batches of 256 and up
MAX_MORE_US = 2.0  # of one query, beside C++
MAX_IMPORT_S = 0.2
MAX_RATIO = 1.15  # wall time of two threads that plan, over one
MAX_LATE_S = 0.010  # a third thread's tick
MAX_INTERRUPT_S = 0.2


class Figures(unittest.TestCase):
    def test_they_are_reached(self):
        found = json.loads(subprocess.run(
            [sys.executable, str(ROOT / "benchmarks" / "python_figures.py"), PROGRAM, "--json"],
            capture_output=True, encoding="utf-8", check=True).stdout)
        print(json.dumps(found, indent=2))
        self.assertEqual(list(found["batches"]), ["256", "1024", "4096"])
        for size, rates in found["batches"].items():
            self.assertGreaterEqual(rates["share"], MIN_SHARE, size)
        self.assertLessEqual(found["one_query"]["more_us"], MAX_MORE_US)
        self.assertLessEqual(found["import_s"], MAX_IMPORT_S)
        self.assertLessEqual(found["threads"]["ratio"], MAX_RATIO)
        self.assertLessEqual(found["threads"]["ticker_late_s"], MAX_LATE_S)
        self.assertLessEqual(found["interrupt_s"], MAX_INTERRUPT_S)


if __name__ == "__main__":
    unittest.main()
