"""`limber driver calibrate` on virtual arms that were put together wrongly, and what `--calibration` makes of them."""

import json
import math
import pathlib
import subprocess
import unittest

import h5py
import numpy
import yaml

from program import PROGRAM, InFolder

ARM = ("--arm", "two_segment")
POSITION_M = 0.001
HEADING_RAD = 0.01
TILT_RAD = 0.005  # of the plane of bodies in 3D
ARM_LAG_S = 0.12  # of the virtual arm at most, 40 to 95 ms; without a lag delays are found to 5 ms


def quoted(*words):
    return "exec:" + " ".join(f"'{word}'" for word in map(str, words))


def base_of(tracker):
    """The base's origin, in m, and its x and y axis, in the tracker's frame of two or three axes."""
    plane = tracker.get("plane", {"origin": [0, 0, 0], "x_axis": [1, 0, 0], "y_axis": [0, 1, 0]})
    origin, x, y = (numpy.array(plane[key]) for key in ("origin", "x_axis", "y_axis"))
    y = -y if tracker["mirrored"] else y
    base = tracker["base"]
    c, s = math.cos(base["theta_rad"]), math.sin(base["theta_rad"])
    return origin * tracker["metres_per_unit"] + base["x_m"] * x + base["y_m"] * y, c * x + s * y, c * y - s * x


def simulated(flags):
    """limber has to be told that a driver keeps no frames."""
    return ("--simulated",) if "--fast" in flags else ()


class Calibrating(InFolder):
    def served(self, seed, *flags):
        return quoted(PROGRAM, "virtual-arm", "--serve", *ARM, "--misassembled", seed, *flags)

    def truth(self, seed, *flags):
        self.run_limber("virtual-arm", "--serve", *ARM, "--misassembled", seed, *flags, "--truth", "truth.yaml", "--force")
        return yaml.safe_load((self.folder / "truth.yaml").read_text())

    def calibrate(self, seed, truth, *flags, code=0):
        side = "left" if truth["tracker"]["mirrored"] else "right"
        marker = truth["tracker"]["marker_offsets"][0]
        return self.run_limber(
            "driver", "calibrate", *ARM, "--driver", self.served(seed, *flags), "--yes", "--handedness", side,
            f"--base-marker={marker['x_m']},{marker['y_m']}", "--out", "calibration.yaml", "--force", "--json",
            *simulated(flags), code=code)

    def expect_truth(self, truth, found):
        self.assertEqual(found["valves"], truth["valves"])
        self.assertEqual(found["sensors"], truth["sensors"])
        for ours, theirs in zip(found["zero_kpa"], truth["zero_kpa"]):
            self.assertAlmostEqual(ours, theirs, delta=0.05)
        ours, theirs = found["tracker"], truth["tracker"]
        self.assertEqual(ours["metres_per_unit"], theirs["metres_per_unit"])
        self.assertEqual(ours["mirrored"], theirs["mirrored"])
        self.assertAlmostEqual(ours["radians_per_unit"], theirs["radians_per_unit"])
        (p, x_axis), (q, x, y) = base_of(ours)[:2], base_of(theirs)
        self.assertLess(math.hypot((p - q) @ x, (p - q) @ y), POSITION_M)
        self.assertLess(math.acos(min(1.0, x_axis @ x)), HEADING_RAD)
        late = found["clocks"]["shape_delay"]["value_s"] - truth["clocks"]["shape_delay"]["value_s"]
        self.assertLess(abs(late - ARM_LAG_S / 2), ARM_LAG_S / 2)

    def collect(self, out, driver, *flags, code=0):
        return self.run_limber(
            "collect", *ARM, "--schedule", "random", "--count", 3, "--hold-s", 0.5, "--hold-min-s", 0.3,
            "--approach", "straight", "--limit-scale", 0.5, "--driver", driver, "--simulated", *flags, "--out", out, code=code)

    def test_finds_what_was_put_together_wrongly(self):
        for seed in (1, 2, 3, 4):
            with self.subTest(seed=seed):
                truth = self.truth(seed)
                said = json.loads(self.calibrate(seed, truth, "--fast").stdout)
                self.assertEqual(said["status"], "ok")
                found = yaml.safe_load((self.folder / "calibration.yaml").read_text())
                self.expect_truth(truth, found)

    def test_in_real_time_clocks_are_found_too(self):
        truth = self.truth(5)
        for _ in range(3):
            if "machine too busy" not in self.calibrate(5, truth, code=None).stderr:
                break
        else:
            self.skipTest("the machine is too busy for an arm in real time")
        found = yaml.safe_load((self.folder / "calibration.yaml").read_text())
        self.expect_truth(truth, found)
        clock = found["clocks"]["driver"]
        self.assertLess(clock["high_s"] - clock["low_s"], 0.06)
        ahead = found["clocks"]["tracker"]["value_s"] - truth["clocks"]["tracker"]["value_s"]
        self.assertLess(abs(ahead), ARM_LAG_S)

    def test_with_it_the_arm_is_as_if_put_together_rightly(self):
        truth = self.truth(7)
        self.calibrate(7, truth, "--fast")
        self.collect("wrong.h5", self.served(7, "--fast"), "--calibration", "calibration.yaml")
        self.collect("right.h5", quoted(PROGRAM, "virtual-arm", "--serve", *ARM, "--fast"))
        with h5py.File(self.folder / "wrong.h5") as ours, h5py.File(self.folder / "right.h5") as theirs:
            a, b = (f["episodes"][sorted(f["episodes"])[0]] for f in (ours, theirs))
            self.assertLess(abs(a["setpoint_kpa"][()] - b["setpoint_kpa"][()]).max(), 1e-3)
            self.assertLess(abs(a["pressure_kpa"][()] - b["pressure_kpa"][()]).max(), 0.5)
            # The shapes come up to 0.15 s late, which limber leaves as it is; at the end of a hold they are there.
            self.assertLess(abs(a["backbone"][-1] - b["backbone"][-1]).max(), 0.02)
        log = (self.folder / "wrong.h5.driver.jsonl").read_text()
        self.assertIn("limber/driver_calibration/1", log)

    def test_the_plane_of_a_tracker_in_3d_is_found(self):
        for seed in (1, 2, 3, 4):
            with self.subTest(seed=seed):
                truth = self.truth(seed, "--bodies")
                said = json.loads(self.calibrate(seed, truth, "--fast", "--bodies", "--noise-m", 0.0001).stdout)
                self.assertEqual(said["status"], "ok")
                found = yaml.safe_load((self.folder / "calibration.yaml").read_text())
                self.expect_truth(truth, found)
                normals = [numpy.cross(c["tracker"]["plane"]["x_axis"], c["tracker"]["plane"]["y_axis"])
                           for c in (found, truth)]
                self.assertLess(math.acos(min(1.0, normals[0] @ normals[1])), TILT_RAD)
                self.assertLess(said["calibration"]["plane"]["out_of_plane_m"], POSITION_M)

    def test_with_it_a_tracker_in_3d_is_as_one_of_the_table(self):
        truth = self.truth(7, "--bodies")
        self.calibrate(7, truth, "--fast", "--bodies")
        served = self.served(7, "--fast", "--bodies")
        self.collect("bodies.h5", served, "--calibration", "calibration.yaml")
        self.collect("right.h5", quoted(PROGRAM, "virtual-arm", "--serve", *ARM, "--fast"))
        with h5py.File(self.folder / "bodies.h5") as ours, h5py.File(self.folder / "right.h5") as theirs:
            a, b = (f["episodes"][sorted(f["episodes"])[0]] for f in (ours, theirs))
            self.assertLess(abs(a["pressure_kpa"][()] - b["pressure_kpa"][()]).max(), 0.5)
            self.assertLess(abs(a["backbone"][-1] - b["backbone"][-1]).max(), 0.02)
        states = [line for line in (self.folder / "bodies.h5.driver.jsonl").read_text().splitlines() if "from_driver" in line]
        self.assertIn('"bodies":[[', states[-1])
        self.assertNotIn('"backbone"', states[-1])
        without = self.collect("without.h5", served, code=3)
        self.assertIn("make one with limber driver calibrate", without.stderr)

    def test_without_it_crossed_channels_are_a_fault(self):
        result = self.collect("wrong.h5", self.served(7, "--fast"), code=None)
        self.assertEqual(result.returncode, 3, result.stderr)

    def test_an_operator_confirms_each_step_and_says_which_way_it_bends(self):
        truth = self.truth(6)
        # The channel of the timing step is known from the first run's question; both answers are tried.
        mirrored = set()
        for side in "rl":
            process = subprocess.run(
                [PROGRAM, "driver", "calibrate", *ARM, "--driver", self.served(6, "--fast"), "--out", "c.yaml",
                 "--simulated", "--force"], cwd=self.folder, input="\n" * 6 + side + "\n", capture_output=True, encoding="utf-8")
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertIn("Lay the arm straight", process.stderr)
            self.assertIn("which way did it bend", process.stderr)
            mirrored.add(yaml.safe_load((self.folder / "c.yaml").read_text())["tracker"]["mirrored"])
        self.assertEqual(mirrored, {True, False})
        self.assertIn(truth["tracker"]["mirrored"], mirrored)

    def test_an_operator_who_leaves_ends_it_vented(self):
        for said, message in (("\nq\n", "stopped on request"), ("\n", "nobody confirmed")):
            process = subprocess.run(
                [PROGRAM, "driver", "calibrate", *ARM, "--driver", self.served(6, "--fast"), "--out", "c.yaml",
                 "--simulated", "--force"], cwd=self.folder, input=said, capture_output=True, encoding="utf-8")
            self.assertEqual(process.returncode, 1, process.stderr)
            self.assertIn(message, process.stderr)
            self.assertFalse((self.folder / "c.yaml").exists())
            log = self.folder / "c.yaml.driver.jsonl"
            last = [json.loads(line) for line in log.read_text().splitlines()]
            log.unlink()  # the next run's has the same name then
            types = [line["to_driver"]["type"] for line in last if "to_driver" in line]
            self.assertEqual(types[-2:], ["vent", "bye"])

    def test_pulses_keep_to_a_tenth_of_the_limits(self):
        self.calibrate(1, self.truth(1), "--fast", "--device-log", "device.jsonl")
        events = [json.loads(line) for line in (self.folder / "device.jsonl").read_text().splitlines()]
        sets = [event["pressure_kpa"] for event in events if event["event"] == "set"]
        self.assertTrue(sets)
        for setpoint in sets:
            self.assertLessEqual(max(map(abs, setpoint)), 10.001)
            self.assertLessEqual(sum(abs(p) > 0 for p in setpoint), 1)

    def test_flags_of_the_other_action_are_refused(self):
        for action, flags in (("check", ("--yes",)), ("check", ("--tolerance-m", 0.002)),
                              ("calibrate", ("--limit-scale", 0.5))):
            refused = self.run_limber("driver", action, *ARM, "--driver", self.served(1), "--out", "out", *flags, code=2)
            self.assertIn(f"{flags[0]}: ", refused.stderr)
            self.assertFalse((self.folder / "out").exists())

    def test_refusals(self):
        truth = self.truth(1)
        result = self.run_limber("driver", "calibrate", *ARM, "--driver", self.served(1), "--yes", "--out", "c.yaml",
                                 code=2)
        self.assertIn("needs --handedness", result.stderr)
        result = self.calibrate(1, truth, "--fast", "--noise-m", 0.003, code=1)
        self.assertIn("error: refused: ", result.stderr)
        self.assertFalse((self.folder / "calibration.yaml").exists())
        self.calibrate(1, truth, "--fast")
        other = self.run_limber(
            "collect", "--arm", "three_segment", "--schedule", "random", "--count", 1, "--out", "r.h5", "--driver",
            quoted(PROGRAM, "virtual-arm", "--serve", "--fast"), "--calibration", "calibration.yaml", code=2)
        self.assertIn("with 2 segments", other.stderr)
        virtual = self.run_limber("collect", *ARM, "--schedule", "random", "--count", 1, "--out", "r.h5",
                                  "--calibration", "calibration.yaml", code=2)
        self.assertIn("goes with --driver exec:COMMAND", virtual.stderr)
        self.write("bad.yaml", (self.folder / "calibration.yaml").read_text().replace("sign: 1", "sign: 2", 1)
                   .replace("sign: -1", "sign: 2", 1))
        bad = self.collect("r.h5", self.served(1, "--fast"), "--calibration", "bad.yaml", code=2)
        self.assertRegex(bad.stderr, r"bad\.yaml:\d+: ")


if __name__ == "__main__":
    unittest.main()
