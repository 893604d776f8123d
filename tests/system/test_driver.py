"""`--driver exec:…`: limber moves an arm behind its driver protocol, here `limber virtual-arm --serve`; what fails is vented,
named and leaves valid files."""

import json
import os
import signal
import subprocess
import time
import unittest

import h5py

from program import PROGRAM, InFolder, limber

ARM = ("--arm", "two_segment")
GOAL = {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03}
QUICK = ("--schedule", "random", "--count", 3, "--hold-s", 0.5, "--hold-min-s", 0.3)


def served(*flags):
    """The value of --driver."""
    words = [PROGRAM, "virtual-arm", "--serve", *ARM, *map(str, flags)]
    return "exec:" + " ".join(f"'{word}'" for word in words)


class Driver(InFolder):
    def collect(self, driver, *arguments, code=0):
        return self.run_limber(
            "collect", *ARM, *QUICK, *arguments, "--driver", driver, "--out", "run.h5", code=code
        )

    def plan(self):
        self.write("e.yaml", json.dumps({
            "schema": "limber/environment/1", "name": "e", "obstacles": [], "start": "rest", "goal": GOAL,
        }))
        self.run_limber(
            "plan", *ARM, "--no-load", "--max-iterations", 300, "--environment", "e.yaml", "--out", "p.json"
        )

    def execute(self, *arguments, code=0):
        return self.run_limber(
            "execute", *ARM, "--plan", "p.json", "--environment", "e.yaml", *arguments, code=code
        )

    def device_events(self):
        return [json.loads(line) for line in (self.folder / "device.jsonl").read_text().splitlines()]


class Collecting(Driver):
    def test_records_what_the_virtual_arm_in_process_records(self):
        result = self.collect(served("--fast"), "--episodes", 2)
        self.assertEqual(result.stderr.count("vented: "), 2)
        self.run_limber("collect", *ARM, *QUICK, "--episodes", 1, "--out", "here.h5")
        with h5py.File(self.folder / "run.h5") as ours, h5py.File(self.folder / "here.h5") as theirs:
            a, b = (f["episodes"][sorted(f["episodes"])[0]] for f in (ours, theirs))
            # The first episodes: the same arm, the same set points, and a clock of its own. The served arm was
            # vented once before.
            self.assertEqual(a["setpoint_kpa"].shape, b["setpoint_kpa"].shape)
            self.assertLess(abs(a["pressure_kpa"][()] - b["pressure_kpa"][()]).max(), 0.5)
            self.assertLess(abs(a["backbone"][()] - b["backbone"][()]).max(), 2e-3)
            self.assertIn("started by", ours.attrs["source"])
        log = [json.loads(line) for line in (self.folder / "run.h5.driver.jsonl").read_text().splitlines()]
        self.assertEqual(log[0]["schema"], "limber/driver_log/1")
        self.assertIn("@", log[0]["started_by"])
        self.assertEqual(log[1]["to_driver"]["type"], "hello")
        self.run_limber("inspect", "run.h5", *ARM)

    def test_a_late_state_says_which_set_points_it_shows(self):
        self.collect(served("--fast", "--latency-s", 0.1))
        log = [json.loads(line) for line in (self.folder / "run.h5.driver.jsonl").read_text().splitlines()]
        asked = {m["seq"]: m["pressure_kpa"] for m in (line.get("to_driver", {}) for line in log)
                 if m.get("type") == "set"}
        shown = {m["seq"]: m["setpoint_kpa"] for m in (line.get("from_driver", {}) for line in log)
                 if m.get("type") == "state"}
        compared = [k for k in asked if k in shown and {k - 1, k - 2} <= set(asked)]
        self.assertGreater(len(compared), 20)
        self.assertNotEqual([asked[k] for k in compared], [asked[k - 2] for k in compared])
        for k in compared:
            self.assertEqual(shown[k], asked[k - 2], k)

    def test_limits_are_scaled(self):
        run = json.loads(self.collect(served("--fast"), "--limit-scale", 0.3, "--json").stdout)
        self.assertGreater(run["frames"], 10)
        self.assertTrue(run["driver"]["vent"]["confirmed"])
        self.assertEqual(set(run["driver"]["late_ms"]), {"count", "p50", "p99", "p999", "max"})
        with h5py.File(self.folder / "run.h5") as file:
            largest = max(abs(e["setpoint_kpa"][()]).max() for e in file["episodes"].values())
        self.assertLessEqual(largest, 30.0)
        self.assertGreater(largest, 15.0)
        for scale in (0, -1, 1.5):
            self.assertIn("--limit-scale", self.collect("virtual", "--limit-scale", scale, code=2).stderr)

    def test_refuses_what_is_no_driver(self):
        for driver, message in (
            ("valves", "expected virtual or exec:COMMAND"),
            ("exec:", "no command found"),
            ("exec:python3 'a", "has no end"),
            ("exec:/no/such/program", "/no/such/program"),
        ):
            self.assertIn(message, self.collect(driver, code=2).stderr)
        self.assertIn("error: driver 'true'", self.collect("exec:true", code=3).stderr)
        self.assertIn("error: driver 'cat'", self.collect("exec:cat", code=3).stderr)
        self.assertFalse((self.folder / "run.h5").exists())

    def test_a_dry_run_prints_what_would_be_sent(self):
        arguments = ("collect", *ARM, *QUICK, "--approach", "straight", "--dry-run", "--out", "run.h5")
        lines = [json.loads(line) for line in self.run_limber(*arguments).stdout.splitlines()]
        self.assertEqual([lines[0]["type"], lines[-2]["type"], lines[-1]["type"]], ["hello", "vent", "bye"])
        sets = [line for line in lines if line["type"] == "set"]
        self.assertEqual([s["seq"] for s in sets], list(range(len(sets))))
        for before, after in zip(sets, sets[1:]):
            step = max(abs(a - b) for a, b in zip(before["pressure_kpa"], after["pressure_kpa"]))
            self.assertLessEqual(step, 5.001)  # 100 kPa/s at 20 Hz
        self.assertEqual(self.run_json(*arguments)["requests"], lines)
        self.assertEqual(list(self.folder.iterdir()), [])


class Checking(Driver):
    def check(self, *flags, code=0):
        return self.run_limber(
            "driver", "check", *ARM, "--driver", served(*flags), "--out", "checked", "--force", "--json", code=code
        )

    def test_a_healthy_driver_passes(self):
        result = limber(
            "driver", "check", *ARM, "--driver", served(), "--out", "checked", "--json", folder=self.folder
        )
        found = json.loads(result.stdout)
        # A machine that is busy with other tests may be late; nothing else may be wrong.
        wrong = [c for c in found["complaints"] if "after their slot" not in c]
        self.assertEqual(wrong, [])
        self.assertEqual(result.returncode, 1 if found["complaints"] else 0)
        self.assertEqual(len(found["steps"]), 4)
        for step in found["steps"]:
            self.assertAlmostEqual(step["reached_kpa"], step["setpoint_kpa"], delta=1.0)
            self.assertLess(step["rise_time_s"], 0.5)
        self.assertTrue(found["deadmen"]["silence"]["vented"])
        self.assertTrue(found["deadmen"]["end_of_input"]["vented"])
        for name in ("check.json", "report.html", "valves.yaml", "check.driver.jsonl"):
            self.assertTrue((self.folder / "checked" / name).exists(), name)
        self.run_limber("plan", "--valves", "checked/valves.yaml", "--help")

    def test_a_stuck_channel_fails(self):
        result = self.check("--fast", "--fault", "stuck@10", code=1)
        self.assertIn("segment 0 reads 0.00 kPa at a set point of 5.00 kPa", result.stderr)

    def test_start_is_where_the_driver_sees_the_arm(self):
        self.write("e.yaml", json.dumps({
            "schema": "limber/environment/1", "name": "e", "obstacles": [], "start": "rest", "goal": GOAL,
        }))
        self.run_limber(
            "plan", *ARM, "--no-load", "--max-iterations", 300, "--environment", "e.yaml", "--out", "p.json",
            "--start-from-driver", served("--fast"),
        )
        self.run_limber(
            "execute", *ARM, "--plan", "p.json", "--environment", "p.environment.yaml", "--driver", served("--fast"),
            "--out", "run.h5",
        )

    def test_a_start_too_far_off_is_refused(self):
        self.plan()
        result = self.run_limber(
            "execute", *ARM, "--plan", "p.json", "--environment", "e.yaml", "--out", "run.h5",
            "--driver", served("--fast", "--noise-m", 0.03), "--max-start-error-m", 0.01, code=2,
        )
        self.assertIn("cm from where the plan starts", result.stderr)


class Faults(Driver):
    def test_each_is_named_vented_and_leaves_a_valid_part(self):
        for kind, message in (
            ("late", "in time"), ("repeat", "more than one answer"), ("old", "out of order"),
            ("half", "part of a line"), ("huge", "more than 1048576 bytes"), ("nan", "wrongly"),
            ("size", "3 numbers found; expected 2"), ("clock", "time has to go on"), ("die", "exit code 9"),
            ("hang", "in time"), ("flood", "more than one answer"), ("over", "its limit is 100.0 kPa"),
            ("jump", "jumped by"), ("release", "vented by itself"), ("stuck", "stands still"),
        ):
            with self.subTest(kind=kind):
                driver = served("--fault", f"{kind}@12", "--device-log", "device.jsonl", "--force")
                result = self.collect(driver, "--approach", "straight", "--force", code=3)
                self.assertIn(message, result.stderr)
                self.assertEqual(result.stderr.count("error:"), 1)
                self.assertRegex(result.stderr, "vented: |VENT NOT CONFIRMED: ")
                self.assertFalse((self.folder / "run.h5").exists())
                self.assertEqual(self.device_events()[-1]["event"], "vent")
                part = self.run_json("inspect", "run.partial.h5", *ARM)
                self.assertGreaterEqual(part["frames"], 12)

    def test_a_hello_of_another_arm_moves_nothing(self):
        driver = served("--fault", "hello@0", "--device-log", "device.jsonl")
        self.assertIn("has 2 segments", self.collect(driver, code=3).stderr)
        self.assertNotIn("set", [event["event"] for event in self.device_events()])

    def test_a_vent_that_fails_is_said(self):
        for kind in ("sealed", "rise"):
            with self.subTest(kind=kind):
                result = self.collect(served("--fast", "--fault", f"{kind}@25"), "--force", code=3)
                self.assertRegex(result.stderr, "VENT NOT CONFIRMED: segment . at .* shut off the supply")

    def test_signals_vent(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGTSTP):
            with self.subTest(signal=number):
                log = self.folder / "device.jsonl"
                log.unlink(missing_ok=True)
                process = subprocess.Popen(
                    [PROGRAM, "collect", *ARM, "--schedule", "random", "--count", "50", "--out", "run.h5", "--force",
                     "--driver", served("--device-log", log)],
                    cwd=self.folder, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, encoding="utf-8")
                while not log.exists() or log.read_text().count('"set"') < 10:
                    self.assertIsNone(process.poll())
                    time.sleep(0.02)
                sent = time.monotonic()
                os.kill(process.pid, number)
                _, messages = process.communicate(timeout=30)
                self.assertEqual(process.returncode, 1, messages)
                self.assertRegex(messages, "vented: [0-9.]+ kPa after [0-9.]+ s")
                vents = [e["at_s"] for e in self.device_events() if e["event"] == "vent" and e["at_s"] > sent]
                self.assertLess(vents[0] - sent, 1.0)  # a frame; the rest is a busy machine
                self.run_limber("inspect", "run.partial.h5", *ARM)

    def test_unknown_faults_are_listed(self):
        result = self.run_limber("virtual-arm", "--serve", "--fault", "fire@3", code=2)
        self.assertIn("late, repeat, old", result.stderr)


class Executing(Driver):
    def setUp(self):
        super().setUp()
        self.plan()

    def test_runs_a_plan_on_a_driver(self):
        run = json.loads(self.execute("--driver", served("--fast"), "--out", "run.h5", "--json").stdout)
        self.assertEqual(run["status"], "done")
        self.assertTrue(run["driver"]["vent"]["confirmed"])
        here = json.loads(self.execute("--json").stdout)
        self.assertLess(abs(run["distance_to_goal_cm"] - here["distance_to_goal_cm"]), 0.5)
        self.run_limber("inspect", "run.h5", *ARM)

    def test_without_out_the_run_is_recorded_all_the_same(self):
        self.execute("--driver", served("--fast"))
        self.assertEqual(len(list(self.folder.glob("run_*.h5"))), 1)
        self.assertEqual(len(list(self.folder.glob("run_*.driver.jsonl"))), 1)

    def test_a_driver_that_answers_at_once_is_compared_with_the_frame_that_it_shows(self):
        errors = {}
        for name, flags in {"end": (), "at once": ("--at-once",)}.items():
            run = json.loads(self.execute("--driver", served("--fast", *flags), "--json",
                                          "--out", f"{len(flags)}.h5").stdout)
            errors[name] = run["prediction_error_cm"]
        for key, value in errors["end"].items():
            self.assertAlmostEqual(errors["at once"][key], value, delta=0.05 + 0.2 * value, msg=key)

    def test_refuses_a_plan_beyond_the_scaled_limits(self):
        result = self.execute("--limit-scale", 0.2, "--driver", served(), "--out", "run.h5", code=2)
        self.assertRegex(result.stderr, r"p\.json: frame \d+: set point of segment \d")
        self.assertEqual(list(self.folder.glob("run*")), [])

    def test_a_fault_in_mid_plan_leaves_what_was_recorded(self):
        result = self.execute("--driver", served("--fault", "die@9"), "--out", "run.h5", "--json", code=3)
        run = json.loads(result.stdout)
        self.assertEqual((run["status"], run["frames"]), ("fault", 9))
        self.assertIn("exit code 9", run["message"])
        self.assertEqual(self.run_json("inspect", "run.h5", *ARM)["frames"], 10)

    def test_a_dry_run_prints_the_plan(self):
        frames = json.loads((self.folder / "p.json").read_text())["frames"]
        lines = [json.loads(line) for line in self.execute("--dry-run").stdout.splitlines()]
        sets = [line["pressure_kpa"] for line in lines if line["type"] == "set"]
        self.assertGreaterEqual(len(sets), len(frames) - 1)
        for sent, frame in zip(sets, frames[1:]):
            for a, b in zip(sent, frame["setpoint_kpa"]):
                self.assertAlmostEqual(a, b, places=4)


if __name__ == "__main__":
    unittest.main()
