"""`limber calibrate`: a tube is measured, planned with and verified; runs don't depend on jobs or stops."""

import json
import unittest

from program import PROGRAM, WithFiles
from test_plan import PILLAR

ARM = ("--arm", "two_segment")
SMALL = ("--max-queries", 3000, "--shape-runs", 10, "--screen-runs", 5, "--test-runs", 6,
         "--audit-runs", 4, "--levels", 0.2, 0.3, "--confidence", 0.5)


class Calibrate(WithFiles):
    FILES = (
        ("t.h5", ("collect", *ARM, "--schedule", "random", "--count", 400)),
        ("m.safetensors", ("train", *ARM, "--data", "t.h5", "--epochs", 60, "--windows", 8)),
    )

    def calibrate(self, out, *arguments, code=0):
        return self.run_json("calibrate", *ARM, "--model", "m.safetensors", "--out", out, *SMALL,
                             *arguments, code=code)

    def error(self, *arguments):
        return self.run_limber("calibrate", *ARM, *arguments, code=2).stderr

    def test_a_calibrated_model_plans_with_its_tube_and_verify_holds_it_to_that(self):
        found = self.calibrate("c.safetensors")
        levels = found["tube"]["levels"]
        self.assertEqual([level["level"] for level in levels], [0.2, 0.3])
        self.assertTrue(all(level["runs"] == 6 and level["audit_runs"] == 4 for level in levels))
        self.assertTrue((self.folder / "c.safetensors.calibration/evidence.html").exists())
        self.assertEqual(self.run_json("inspect", "c.safetensors")["tube"]["levels"], levels)
        environment = self.write("e.yaml", json.dumps({**PILLAR, "obstacles": []}))
        shared = (*ARM, "--model", "c.safetensors", "--environment", environment)
        plan = self.run_json("plan", *shared, "--tube", 0.2, "--max-queries", 20000, "--out", "p.json")
        self.assertEqual(plan["tube"]["level"], 0.2)
        self.assertEqual(self.run_json("inspect", "p.json")["tube"]["level"], 0.2)
        judged = self.run_json("verify", *shared, "--plan", "p.json", "--also", "m.safetensors")["also"][0]
        self.assertTrue(judged["goal_reached"], "the other model's file carries no tube")
        narrow = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        narrow["tube"]["plate_radius_m"][-1] *= 0.5
        self.write("p.json", json.dumps(narrow))
        checks = [failure["check"] for failure in
                  self.run_json("verify", *shared, "--plan", "p.json", code=1)["failures"]]
        self.assertIn("tube", checks)
        default = self.run_json("plan", *shared, "--max-queries", 20000)
        self.assertEqual(default["tube"]["level"], 0.3)
        bare = self.run_json("plan", *shared, "--max-queries", 20000, "--margin-m", 0.001)
        self.assertIsNone(bare["tube"])
        error = self.run_limber("plan", *shared, "--tube", 0.99, code=2).stderr
        self.assertIn("the model carries 0.2, 0.3", error)
        checked = self.run_json("calibrate", *ARM, "--model", "c.safetensors", "--check", 3,
                                "--max-queries", 1500, "--friction-factor", 2)
        self.assertEqual(checked["runs"], 3)

    def test_jobs_and_stops_change_nothing(self):
        one = self.calibrate("one.safetensors", "--jobs", 1)
        two = self.calibrate("two.safetensors", "--jobs", 2)
        for phases in (one["phases"], two["phases"]):
            for phase in phases:
                del phase["first_solution_s_median"]  # clock
        self.assertEqual(one, two)
        self.assertEqual((self.folder / "one.safetensors").read_bytes(),
                         (self.folder / "two.safetensors").read_bytes())
        runs = sorted((self.folder / "two.safetensors.calibration/runs").iterdir())
        for path in runs[1::2]:
            path.unlink()
        resumed = self.calibrate("two.safetensors", "--resume", "--force")
        for phase in resumed["phases"]:
            del phase["first_solution_s_median"]
        self.assertEqual(one, resumed)
        error = self.run_limber(
            "calibrate", *ARM, "--model", "m.safetensors", "--out", "two.safetensors", *SMALL,
            "--resume", "--force", "--seed", 2, code=2).stderr
        self.assertIn("seed = 1; this run has 2", error)

    def test_executed_recordings_calibrate_as_far_as_they_reach(self):
        environment = self.write("e.yaml", json.dumps({**PILLAR, "obstacles": []}))
        plans, recordings = [], []
        # One frame late, as hardware is, and its set points in force say so.
        driver = f"'{PROGRAM}' virtual-arm --serve --fast --at-once --arm {ARM[1]}"
        late = ("--driver", f"exec:{driver}", "--simulated", "--max-start-error-m", 1)
        for seed in (1, 2, 3):
            plans.append(f"p{seed}.json")
            recordings.append(f"r{seed}.h5")
            self.run_limber("plan", *ARM, "--model", "m.safetensors", "--environment", environment,
                            "--max-queries", 3000, "--seed", seed, "--out", plans[-1])
            self.run_execution(*ARM, "--plan", plans[-1], "--environment", environment,
                               "--out", recordings[-1], *(late if seed == 3 else ()))
        shared = ("--model", "m.safetensors", "--plans", *plans, "--recordings", *recordings)
        error = self.error(*shared, "--out", "c.safetensors")
        self.assertIn("3 runs can't promise that 90 % stay in any tube", error)
        self.assertIn("the largest level is 0.368", error)
        found = self.run_json("calibrate", *ARM, *shared, "--levels", 0.3, "--out", "c.safetensors")
        level = found["tube"]["levels"][0]
        self.assertEqual((level["runs"], level["outside"], level["audit_runs"]), (3, 0, 0))
        error = self.error("--model", "m.safetensors", "--plans", *reversed(plans), "--recordings",
                           *recordings, "--levels", 0.3, "--out", "d.safetensors")
        self.assertIn("it is not that plan's run", error)
        error = self.error("--model", "m.safetensors", "--plans", plans[0], plans[0], "--recordings",
                           recordings[0], recordings[0], "--levels", 0.3, "--out", "d.safetensors")
        self.assertIn("r1.h5: the same recording as r1.h5; give it once", error)

    def test_what_can_give_nothing_is_refused_before_any_work(self):
        model = ("--model", "m.safetensors")
        self.assertIn("--out is required", self.error(*model))
        self.assertIn("so few can't show a level of 0.95: at least 80",
                      self.error(*model, "--out", "c.safetensors", "--test-runs", 79))
        self.assertIn("rising shares", self.error(*model, "--out", "c", "--levels", 0.9, 0.5))
        self.assertIn("carries no tube to check", self.error(*model, "--check", 3))
        self.assertIn("need --check", self.error(*model, "--out", "c", "--load-kg", 0.1))
        self.assertIn("--tube requires --check", self.error(*model, "--out", "c", "--tube", 0.9))
        for flags in (("--out", "c"), ("--levels", 0.9), ("--resume",), ("--test-runs", 90)):
            self.assertIn(f"{flags[0]} excludes --check", self.error(*model, "--check", 3, *flags))
        self.assertIn("--recordings excludes --audit-runs", self.error(
            *model, "--plans", "p.json", "--recordings", "r.h5", "--audit-runs", 9, "--out", "c"))


if __name__ == "__main__":
    unittest.main()
