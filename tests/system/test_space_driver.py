"""Arms in space behind a driver: what is recorded there is what the virtual arm in process records."""

import pathlib
import sys
import unittest

import h5py
import numpy as np

from program import PROGRAM, InFolder

ARM = ("--arm", "hanging_3x2")
QUICK = ("--schedule", "random", "--count", 3, "--hold-s", 0.5, "--hold-min-s", 0.3)

# A driver of another arm: what the served one says, changed before it is passed on.
CHANGED = """
import json, subprocess, sys
arm = subprocess.Popen(sys.argv[1:], stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8")
for request in sys.stdin:
    arm.stdin.write(request)
    arm.stdin.flush()
    answer = json.loads(arm.stdout.readline() or "{{}}")
    if answer.get("type") == "{kind}":
        {change}
    if answer:
        print(json.dumps(answer), flush=True)
"""


def quoted(words):
    return "exec:" + " ".join(f"'{word}'" for word in words)


def served(*flags):
    return [PROGRAM, "virtual-arm", "--serve", *ARM, "--fast", *map(str, flags)]


class SpaceDriver(InFolder):
    def collect(self, driver, code=0):
        return self.run_limber("collect", *ARM, *QUICK, "--simulated", "--driver", driver, "--out", "run.h5", code=code)

    def changed(self, kind, change):
        self.write("changed.py", CHANGED.format(kind=kind, change=change))
        return quoted([sys.executable, pathlib.Path(self.folder) / "changed.py", *served()])

    def test_records_what_the_virtual_arm_in_process_records(self):
        self.collect(quoted(served()))
        self.run_limber("collect", *ARM, *QUICK, "--out", "own.h5")
        with h5py.File(self.folder / "run.h5") as run, h5py.File(self.folder / "own.h5") as own:
            self.assertEqual(run["episodes/000000/backbone"].shape[1:], (9, 7))
            # The served arm was vented once before.
            for name, tolerance in (("backbone", 2e-3), ("pressure_kpa", 0.5), ("setpoint_kpa", 1e-4)):
                there, here = (file[f"episodes/000000/{name}"][()] for file in (run, own))
                np.testing.assert_allclose(there, here, rtol=0, atol=tolerance, err_msg=name)

    def test_what_is_no_arm_in_space_moves_nothing(self):
        for kind, change, told in (
                ("hello", "answer.pop('chambers')", "chambers"),
                ("hello", "answer['chambers'] = 9", "arm 'hanging_3x2' has 6 chambers"),
                ("state", "answer['bodies'] = answer.pop('backbone')", "as backbone"),
                ("state", "answer['backbone'] = [[0, 0, 0]] * 9", "x, y, z, qx, qy, qz and qw"),
                ("state", "answer['backbone'] = [[0, 0, 0, 0, 0, 0, 2]] * 9", "a quaternion of length 2")):
            with self.subTest(change):
                self.assertIn(told, self.collect(self.changed(kind, change), code=3).stderr)

    def test_a_healthy_driver_passes_the_check(self):
        check = self.run_json("driver", "check", *ARM, "--driver", quoted(served()), "--simulated", "--limit-scale", 0.3,
                              "--out", "check")
        self.assertEqual(check["status"], "ok")
        self.assertEqual([step["chamber"] for step in check["steps"]], list(range(6)))
        self.assertIn("chamber 2 of segment 1", (self.folder / "check" / "report.html").read_text(encoding="utf-8"))

    def test_disturbances_of_a_plane_are_refused(self):
        for flags, told in ((("--misassembled", 1), "--misassembled"),
                            (("--disturbance", "weak_actuator"), "weak_actuator")):
            said = self.run_limber("virtual-arm", "--serve", *ARM, *flags, code=2).stderr
            self.assertIn(told, said)


if __name__ == "__main__":
    unittest.main()
