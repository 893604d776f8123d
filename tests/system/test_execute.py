"""`limber execute` and `limber inspect`: a plan runs on the virtual arm, and files that do not fit are
refused before anything moves."""

import json
import unittest

from program import InFolder, ROOT

ARM = ("--arm", "two_segment")
GOAL = {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03}
RUNS = ROOT / "tests" / "data" / "closed_loop"
REPLAN = ("--replan", "--model", RUNS / "ten_hours.safetensors")
KEYS = {
    "status", "collided", "min_clearance_cm", "distance_to_goal_cm", "orientation_to_goal_rad",
    "replans", "switches", "waits", "halts", "goal_time_s", "planned_goal_time_s", "frames",
    "frames_not_seen", "message",
}


class Execute(InFolder):
    def setUp(self):
        super().setUp()
        self.environment("e.yaml", [{"circle": {"x_m": 0.3, "y_m": -0.25, "radius_m": 0.04}}])
        self.run_limber(
            "plan", *ARM, "--no-load", "--max-iterations", 300, "--environment", "e.yaml",
            "--out", "p.json",
        )

    def environment(self, name, obstacles):
        content = {
            "schema": "limber/environment/1", "name": name, "obstacles": obstacles,
            "start": "rest", "goal": GOAL,
        }
        self.write(name, json.dumps(content))

    def execute(self, *arguments):
        return self.run_execution(*ARM, "--plan", "p.json", "--environment", "e.yaml", *arguments)

    def test_runs_to_the_end_and_judges_the_goal(self):
        found = self.execute("--out", "run.h5")
        self.assertLessEqual(KEYS, set(found))
        self.assertEqual((found["status"], found["collided"], found["replans"]), ("done", False, 0))
        self.assertGreater(found["min_clearance_cm"], 0.0)
        # The no-load model errs on this arm, but not by the arm's length.
        self.assertTrue(0.0 < found["distance_to_goal_cm"] < 40.0)
        self.assertIn(f"ended {found['distance_to_goal_cm']:.1f} cm from the goal (3.0 cm allowed)",
                      found["message"])
        recording = self.run_json("inspect", "run.h5")
        self.assertIn("two_segment", json.dumps(recording))
        # What ran is evaluated on like any other recording.
        evaluated = self.run_json("evaluate", *ARM, "--data", "run.h5")
        self.assertEqual(evaluated["frames"], recording["frames"] - 1)
        self.assertEqual((evaluated["network"], evaluated["reduction_percent"]), (None, None))

    def execute_with_a_network(self, *arguments):
        """A plan of a network of ten hours."""
        return self.run_execution("--plan", RUNS / "arm_019.plan.json", "--environment",
                                  RUNS / "arm_019.yaml", *arguments)

    def test_closed_loop_ends_nearer_to_the_goal(self):
        open_loop = self.execute_with_a_network()
        found = self.execute_with_a_network(*REPLAN, "--out", "run.h5")
        self.assertGreater(found["replans"] + found["switches"], 0)
        self.assertLess(found["distance_to_goal_cm"], 0.5 * open_loop["distance_to_goal_cm"])
        self.assertEqual((found["goal_reached"], found["collided"], found["message"]), (True, False, ""))
        self.assertEqual(found["seed"], self.run_json("inspect", "run.h5")["seed"])
        # What a time of this machine was worth in queries repeats the run.
        queries = ("--motion-queries", found["motion_queries"])
        self.assertGreater(found["motion_queries"], 0)
        self.assertEqual(
            self.execute_with_a_network(*REPLAN, "--out", "run.h5", *queries, "--force"), found)

    def test_an_arm_that_touches_something_is_not_held_for_ever(self):
        # The model has it strike whether it goes on or stays: it stood for 26 900 frames.
        found = self.run_execution("--plan", RUNS / "overshoot_006.plan.json", "--environment", "06_overshoot",
                                   *REPLAN, "--motion-queries", 2000, "--disturbance", "weak_actuator=0.4",
                                   "--seed", 172712329)
        self.assertTrue(found["collided"])
        self.assertLess(found["frames"], 200)
        self.assertIn("halted on its way", found["message"])

    def test_the_closed_loop_needs_a_network(self):
        for model, word in (((), "--model"), (("--no-load", "--no-valves"), "needs a network")):
            message = self.run_limber("execute", *ARM, "--plan", "p.json", "--environment", "e.yaml",
                                      "--replan", *model, code=2).stderr
            self.assertIn(word, message)
        message = self.run_limber("execute", *ARM, "--plan", "p.json", "--environment", "e.yaml", "--no-load",
                                  code=2).stderr
        self.assertIn("in open loop nothing is predicted", message)
        message = self.run_limber("execute", "--plan", RUNS / "arm_019.plan.json", "--environment",
                                  RUNS / "arm_019.yaml", *REPLAN, "--adapt", code=2).stderr
        self.assertIn("--adapt: nothing would be adapted", message)

    def test_without_queries_in_motion_it_plans_at_rest_alone(self):
        open_loop = self.execute_with_a_network()
        found = self.execute_with_a_network(*REPLAN, "--motion-queries", 0)
        self.assertGreater(found["replans"], 0)
        self.assertEqual((found["switches"], found["waits"]), (0, 0))
        self.assertEqual(
            found["open_loop_distance_to_goal_cm"], open_loop["distance_to_goal_cm"])
        self.assertLess(found["distance_to_goal_cm"], 0.5 * open_loop["distance_to_goal_cm"])

    def test_a_run_that_strikes_something_names_it(self):
        plan = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        x, y, _ = self.execute()["final_backbone"][-1]
        self.environment("e.yaml", [{"circle": {"x_m": x, "y_m": y, "radius_m": 0.01}}])
        inspected = self.run_json("inspect", "e.yaml")
        plan["environment"]["hash"] = inspected["hash"]
        del plan["certificate"]
        self.write("p.json", json.dumps(plan))
        found = self.execute()
        self.assertTrue(found["collided"])
        self.assertRegex(found["message"], r"^collided with obstacle 0 \(circle\), plates \d+ and \d+, after")

    def test_repeats_exactly(self):
        self.assertEqual(self.execute(), self.execute())

    def test_refuses_what_the_plan_was_not_made_for(self):
        self.environment("other.yaml", [])
        cases = [
            ("--arm", "three_segment", "--plan", "p.json", "--environment", "e.yaml"),
            (*ARM, "--plan", "p.json", "--environment", "other.yaml"),
            (*ARM, "--plan", "e.yaml", "--environment", "e.yaml"),
            (*ARM, "--plan", "none.json", "--environment", "e.yaml"),
        ]
        for arguments in cases:
            with self.subTest(arguments=arguments):
                result = self.run_limber("execute", *arguments, "--out", "run.h5", code=2)
                self.assertRegex(result.stderr, r"p\.json|e\.yaml|none\.json|other\.yaml")
                self.assertFalse((self.folder / "run.h5").exists())

    def test_refuses_broken_plans(self):
        whole = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        frames = whole["frames"]

        def with_pressure(value):
            broken = json.loads(json.dumps(frames))
            broken[len(broken) // 2]["setpoint_kpa"][0] = value
            return {**whole, "frames": broken}

        cases = [
            ("", "p.json"),
            ("{", "p.json"),
            (json.dumps(whole)[:-30], "p.json"),
            ({**whole, "schema": "limber/plan/99"}, "schema"),
            ({**whole, "frames": []}, "frames"),
            (with_pressure("much"), "setpoint_kpa"),
            (with_pressure(1e9), "setpoint_kpa"),
            (with_pressure(frames[0]["setpoint_kpa"][0] + 99.0), "p.json"),
            *(({k: v for k, v in whole.items() if k != key}, key) for key in ("arm", "frames")),
        ]
        for content, field in cases:
            text = content if isinstance(content, str) else json.dumps(content)
            with self.subTest(field=field, text=text[:60]):
                self.write("p.json", text)
                result = self.run_limber(
                    "execute", *ARM, "--plan", "p.json", "--environment", "e.yaml", code=2
                )
                self.assertIn("p.json", result.stderr)
                self.assertIn(field, result.stderr)

    def test_inspect_knows_every_kind_of_file(self):
        self.run_limber(
            "collect", *ARM, "--schedule", "random", "--count", 1, "--out", "r.h5", "--quiet"
        )
        for name, kind in (("p.json", "plan"), ("e.yaml", "environment"), ("r.h5", "recording")):
            with self.subTest(name=name):
                self.assertIn(kind, self.run_limber("inspect", name).stdout)
        self.write("x.bin", "\x00\x01")
        self.assertIn("x.bin", self.run_limber("inspect", "x.bin", code=2).stderr)


if __name__ == "__main__":
    unittest.main()
