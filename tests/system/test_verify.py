"""`limber verify`: what `limber plan` finds is certified; what was changed by hand is refused."""

import json
import unittest

from program import InFolder
from test_plan import ARM, BUDGET, PILLAR, changed


class Verify(InFolder):
    def setUp(self):
        super().setUp()
        self.environment = self.write("e.yaml", json.dumps(PILLAR))
        found = self.run_json(
            "plan", *ARM, *BUDGET, "--environment", self.environment, "--out", "p.json"
        )
        self.assertTrue(found["certificate"]["certified"])
        self.assertLess(found["certificate"]["largest_deviation_m"], 1e-4)
        self.plan = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))

    def verify(self, *arguments, code=0, environment=None):
        return self.run_json(
            "verify", *ARM, "--plan", "p.json", "--environment", environment or self.environment,
            *arguments, code=code,
        )

    def error(self, *arguments):
        return self.run_limber(*arguments, code=2).stderr

    def rewrite(self, plan):
        (self.folder / "p.json").write_text(json.dumps(plan), encoding="utf-8")

    def test_certifies_what_plan_wrote(self):
        found = self.verify()
        self.assertEqual(found["status"], "certified")
        self.assertEqual(found["failures"], [])
        self.assertLessEqual(found["largest_deviation_m"], 1e-4)
        self.assertGreaterEqual(found["clearance_cm"], 0.01)
        self.assertLessEqual(found["distance_to_goal_cm"], 3.0)
        self.assertEqual(found["frames"], len(self.plan["frames"]))

    def test_certifies_a_plan_that_was_asked_to_be_slow(self):
        self.run_json("plan", *ARM, *BUDGET, "--environment", self.environment, "--rate-limit", 25,
                      "--out", "p.json", "--force")
        self.assertEqual(self.verify()["status"], "certified")

    def test_refuses_a_plan_changed_by_hand_with_or_without_its_seal(self):
        def nudge_set_point(plan):
            plan["frames"][3]["setpoint_kpa"][0] += 0.01

        def nudge_backbone(plan):
            plan["frames"][4]["backbone"][5][1] += 0.0003

        def cheapen(plan):
            plan["cost_kpa"] -= 1.0

        def move_waypoint(plan):
            plan["waypoints_kpa"][1][0] += 0.01

        for change in (nudge_set_point, nudge_backbone, cheapen, move_waypoint):
            for sealed in (True, False):
                plan = json.loads(json.dumps(self.plan))
                change(plan)
                if not sealed:
                    del plan["certificate"]
                self.rewrite(plan)
                found = self.verify(code=1)
                self.assertEqual(found["status"], "refused")
                quiet = self.run_limber("verify", *ARM, "--plan", "p.json", "--environment",
                                        self.environment, "--quiet", code=1)
                self.assertIn("error: p.json: not certified: ", quiet.stderr)
                checks = {failure["check"] for failure in found["failures"]}
                self.assertTrue(checks - {"seal"}, change.__name__)
                self.assertEqual("seal" in checks, sealed)

    def test_another_environment_arm_or_model_is_bad_input(self):
        other = self.write("other.yaml", json.dumps(changed(obstacles=[])))
        error = self.error("verify", *ARM, "--plan", "p.json", "--environment", other,
        )
        self.assertIn("made for another environment", error)
        error = self.error("verify", "--no-load", "--arm", "three_segment", "--plan", "p.json",
            "--environment", self.environment,
        )
        self.assertIn("made for another arm", error)
        error = self.error("verify", "--arm", "two_segment", "--plan", "p.json",
            "--environment", self.environment,
        )
        self.assertIn("give --no-load", error)
        error = self.error("verify", "--arm", "two_segment", "--plan", "p.json", "--environment",
                           self.environment, "--model", "any.safetensors")
        self.assertIn("p.json was made with the no-load model: give --no-load", error)

    def test_execution_refuses_what_was_changed(self):
        self.plan["frames"][3]["setpoint_kpa"][0] += 0.01
        self.rewrite(self.plan)
        error = self.error("execute", "--arm", "two_segment", "--plan", "p.json",
            "--environment", self.environment,
        )
        self.assertIn("certificate: the plan was changed since it was certified", error)

    def test_another_model_judges_the_same_set_points(self):
        self.run_limber("collect", "--arm", "two_segment", "--schedule", "random", "--count", 20,
                        "--seed", 3, "--out", "train.h5")
        for seed in (1, 2):
            self.run_limber("train", "--arm", "two_segment", "--data", "train.h5", "--hidden", 8,
                            "--epochs", 3, "--seed", seed, "--out", f"m{seed}.safetensors")
        result = self.run_limber("verify", *ARM, "--plan", "p.json", "--environment",
                                 self.environment, "--also", "m1.safetensors", "--also",
                                 "m2.safetensors", "--json", code=None)
        self.assertIn(result.returncode, (0, 1))
        found = json.loads(result.stdout)
        self.assertEqual(found["status"], "certified", "the plan's own model is its judge as ever")
        self.assertEqual([j["model"] for j in found["also"]], ["m1.safetensors", "m2.safetensors"])
        self.assertEqual(result.returncode, 0 if all(j["agrees"] for j in found["also"]) else 1)
        ends = [judgement["distance_to_goal_cm"] for judgement in found["also"]]
        self.assertNotEqual(ends[0], ends[1])
        for judgement in found["also"]:
            # Nothing stored helps here: what departs is the other model's own rollout.
            self.assertGreater(judgement["largest_departure_cm"], 0.1)
        executed = self.run_limber("execute", "--arm", "two_segment", "--plan", "p.json", "--json",
                                   "--environment", self.environment, "--driver",
                                   "model:m1.safetensors", "--out", "run.h5", code=None)
        self.assertIn(executed.returncode, (0, 1), executed.stderr)
        self.assertEqual(json.loads(executed.stdout)["frames"] > 0, True)
        self.assertIn("model:m1.safetensors", self.run_limber("inspect", "run.h5").stdout)
        error = self.error("execute", "--arm", "two_segment", "--plan", "p.json", "--environment",
                           self.environment, "--driver", "nobody")
        self.assertIn("expected virtual, model:FILE.safetensors or exec:COMMAND", error)
        error = self.error("execute", "--arm", "two_segment", "--plan", "p.json", "--environment",
                           self.environment, "--driver", "model:")
        self.assertIn("--driver model:: expected virtual, model:FILE.safetensors", error)
        error = self.error("verify", *ARM, "--plan", "p.json", "--environment", self.environment,
                           "--also", "nowhere.safetensors")
        self.assertIn("nowhere.safetensors", error)


if __name__ == "__main__":
    unittest.main()
