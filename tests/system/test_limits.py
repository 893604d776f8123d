"""Limits of each side: the whole chain on an arm whose sides differ, and plans within narrower limits."""

import json
import unittest

from program import ROOT, InFolder

ARM = ROOT / "arms" / "uneven_limits.yaml"
LIMITS = [[-70.0, 100.0], [-100.0, 85.0]]
ENVIRONMENT = {
    "schema": "limber/environment/1",
    "name": "free",
    "obstacles": [{"circle": {"x_m": -0.3, "y_m": 0.3, "radius_m": 0.05}}],
    "start": "rest",
    "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03},
}
BUDGET = ("--max-queries", 30000)
ROUNDING = 1e-4  # kPa, of a float32


class Limits(InFolder):
    def setUp(self):
        super().setUp()
        self.environment = self.write("e.yaml", json.dumps(ENVIRONMENT))

    def setpoints(self, recording):
        """Rows of set points of what was exported."""
        self.run_limber("export", recording, "--csv", "csv", "--force")
        rows = []
        for path in sorted((self.folder / "csv").glob("*.csv")):
            lines = path.read_text(encoding="utf-8").splitlines()
            names = lines[0].split(",")
            columns = [i for i, name in enumerate(names) if name.startswith("setpoint_")]
            rows += [[float(line.split(",")[i]) for i in columns] for line in lines[1:] if columns]
        self.assertTrue(rows)
        return rows

    def expect_within(self, rows, limits):
        for row in rows:
            for value, (lower, upper) in zip(row, limits):
                self.assertGreaterEqual(value, lower - ROUNDING)
                self.assertLessEqual(value, upper + ROUNDING)

    def plan_rows(self, name):
        plan = json.loads((self.folder / name).read_text(encoding="utf-8"))
        return plan, [frame["setpoint_kpa"] for frame in plan["frames"]] + plan["waypoints_kpa"]

    def plan(self, *arguments, code=0):
        return self.run_json("plan", "--arm", ARM, "--no-load", "--environment", self.environment,
                             *BUDGET, "--out", "p.json", "--force", *arguments, code=code)

    def test_the_chain_keeps_the_limits_of_each_side(self):
        self.run_limber("collect", "--arm", ARM, "--hold-s", 1.5, "--out", "all.h5")
        rows = self.setpoints("all.h5")
        self.expect_within(rows, LIMITS)
        for segment, (lower, upper) in enumerate(LIMITS):  # and goes as far as they do
            self.assertEqual(min(row[segment] for row in rows), lower)
            self.assertEqual(max(row[segment] for row in rows), upper)
        found = self.run_json("inspect", "all.h5", "--arm", ARM)
        self.assertEqual(found["limits_kpa"], LIMITS)
        self.assertEqual(found["transitions"]["attempted"], 81)
        self.run_limber("collect", "--arm", ARM, "--schedule", "random", "--count", 8, "--episodes",
                        2, "--out", "random.h5")
        self.expect_within(self.setpoints("random.h5"), LIMITS)
        self.run_limber("train", "--arm", ARM, "--data", "all.h5", "--epochs", 12, "--hidden", 16, 16,
                        "--out", "m.safetensors")
        model = ("--arm", ARM, "--model", "m.safetensors", "--environment", self.environment)
        self.run_json("plan", *model, *BUDGET, "--margin-m", 0, "--goal-margin-m", 0, "--out",
                      "p.json")
        plan, rows = self.plan_rows("p.json")
        self.assertNotIn("limits_kpa", plan)
        self.expect_within(rows, LIMITS)
        verified = self.run_json("verify", *model, "--plan", "p.json")
        self.assertEqual(verified["status"], "certified")
        self.run_execution("--arm", ARM, "--plan", "p.json", "--environment", self.environment,
                           "--out", "run.h5")
        self.expect_within(self.setpoints("run.h5"), LIMITS)

    def test_planning_within_narrower_limits(self):
        narrow = [[-60.0, 40.0], [-60.0, 55.0]]
        flags = ("--limit", "-60,40", "--limit", "1:-60,55")
        for planner in ("default", "paper"):
            with self.subTest(planner=planner):
                found = self.plan("--planner", planner, *flags)
                self.assertEqual(found["limits_kpa"], narrow)
                plan, rows = self.plan_rows("p.json")
                self.assertEqual(plan["limits_kpa"], narrow)
                self.expect_within(rows, narrow)
                verified = self.run_json("verify", "--arm", ARM, "--no-load", "--environment",
                                         self.environment, "--plan", "p.json")
                self.assertEqual(verified["status"], "certified")
        forest = ("--forest", "f", "--forest-nodes", 3000)
        self.plan("--build-forest", *forest)
        self.plan(*forest, *flags)
        self.expect_within(self.plan_rows("p.json")[1], narrow)

    def test_a_plan_beyond_its_own_limits_is_not_certified(self):
        self.plan("--limit", "-60,60")
        plan, rows = self.plan_rows("p.json")
        largest = max(abs(row[0]) for row in rows)
        plan["limits_kpa"][0] = [-0.5 * largest, 0.5 * largest]
        del plan["certificate"]
        (self.folder / "p.json").write_text(json.dumps(plan), encoding="utf-8")
        found = self.run_json("verify", "--arm", ARM, "--no-load", "--environment", self.environment,
                              "--plan", "p.json", code=1)
        self.assertEqual(found["status"], "refused")
        self.assertIn("the plan's own limits", json.dumps(found))

    def test_limits_that_are_none_are_refused(self):
        for value, message in (("10,-10", "expected LOWER,UPPER"),
                               ("a,b", "expected LOWER,UPPER"),
                               ("-8,nan", "expected LOWER,UPPER"),
                               ("2:-8,8", "'2' is no segment; arm 'uneven_limits' has segments 0 to 1"),
                               ("-80,80", "beyond the limits of segment 0, -70 to 100 kPa"),
                               ("1:-80,90", "beyond the limits of segment 1, -100 to 85 kPa")):
            with self.subTest(value=value):
                found = self.run_limber("plan", "--arm", ARM, "--no-load", "--environment",
                                        self.environment, "--limit", value, code=2)
                self.assertIn(f"--limit {value}: ", found.stderr)
                self.assertIn(message, found.stderr)

    def test_a_limit_scale_names_the_limit_to_plan_within(self):
        self.plan("--limit", "-60,60")
        found = self.run_limber("execute", "--arm", ARM, "--plan", "p.json", "--environment",
                                self.environment, "--driver", "exec:never-started",
                                "--limit-scale", 0.01, code=2)
        self.assertIn("--limit-scale 0.01 allows -", found.stderr)
        self.assertIn("limber plan --limit ", found.stderr)

    def test_the_message_names_the_limits_that_differ(self):
        self.plan()
        found = self.run_limber("execute", "--arm", "two_segment", "--plan", "p.json",
                                "--environment", self.environment, code=2)
        self.assertIn("segments[0].pressure_limit_kpa: [-70, 100] there, 100 here", found.stderr)
        self.assertIn("segments[1].pressure_limit_kpa: [-100, 85] there, 100 here", found.stderr)


if __name__ == "__main__":
    unittest.main()
