"""Logs without measured pressures: set points from import to plan, never called measured, no valves."""

import csv
import json
import math
import unittest

from program import InFolder

ARM = ("--arm", "two_segment")


class Setpoints(InFolder):
    """The virtual arm's logs, with what it measured left out."""

    def setUp(self):
        super().setUp()
        self.run_json("collect", *ARM, "--schedule", "random", "--count", 20, "--episodes", 6,
                      "--hold-s", 1.5, "--hold-min-s", 0.2, "--out", "measured.h5")
        self.run_limber("export", "measured.h5", "--csv", "logs")
        text = (self.folder / "logs" / "mapping.yaml").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if not line.strip().startswith("columns:")]
        self.write("setpoints.yaml", "\n".join(lines) + "\n")
        self.imported = self.run_json(
            "import", "csv", *sorted((self.folder / "logs").glob("*.csv")), *ARM,
            "--mapping", "setpoints.yaml", "--out", "setpoints.h5")

    def train(self, name, *arguments, code=0):
        return self.run_limber("train", *ARM, "--epochs", 10, "--hidden", 16, 16, "--out", name,
                               "--json", "--force", *arguments, code=code)

    def test_the_recording_says_that_nothing_was_measured(self):
        self.assertEqual(self.imported["commands_are"], "setpoints")
        self.assertIn("nothing measured", str(self.imported["logs"][0]["notes"]))
        inspected = self.run_json("inspect", "setpoints.h5", *ARM)
        self.assertEqual(inspected["commands_are"], "setpoints")
        self.assertIsNone(inspected["pressure_kpa"])
        self.assertEqual(inspected["valves"]["segments"], [])
        self.assertIn("no pressure was measured", inspected["valves"]["identified"]["reason"])
        self.assertIn("set points only", self.run_limber("inspect", "setpoints.h5").stdout)
        self.assertEqual(self.run_json("inspect", "measured.h5", *ARM)["commands_are"], "measured")
        # Every set point is one that the log has: none lies between two of its rows.
        self.run_limber("export", "setpoints.h5", "--csv", "again")
        for name in ("episode_000.csv", "episode_005.csv"):
            rows = {}
            for folder in ("logs", "again"):
                with open(self.folder / folder / name, encoding="utf-8", newline="") as file:
                    table = list(csv.DictReader(file))
                self.assertEqual("pressure_0_kpa" in table[0], folder == "logs")
                rows[folder] = {row["setpoint_0_kpa"] for row in table}
            self.assertLessEqual(rows["again"], rows["logs"])
        refused = self.run_limber("characterize", *ARM, "--valves", "setpoints.h5", code=2)
        self.assertIn("nothing to identify valves from", refused.stderr.replace("\n", " "))
        fitted = self.run_json("characterize", *ARM, "--recording", "setpoints.h5")
        self.assertGreater(len(fitted["segments"]), 0)

    def test_a_model_says_which_of_the_two_it_has_learnt_from(self):
        self.train("s.safetensors", "--data", "setpoints.h5")
        model = self.run_json("inspect", "s.safetensors")
        self.assertEqual(model["learnt_from"], "setpoints")
        self.assertEqual(model["valves"]["segments"], [])
        self.assertIn("learnt from set points only", self.run_limber("inspect", "s.safetensors").stdout)
        self.train("m.safetensors", "--data", "measured.h5")
        self.assertEqual(self.run_json("inspect", "m.safetensors")["learnt_from"], "measured")
        mixed = self.train("x.safetensors", "--data", "measured.h5", "--data", "setpoints.h5", code=2)
        for part in ("measured.h5: what was measured", "setpoints.h5: set points only", "--setpoints"):
            self.assertIn(part, mixed.stderr)
        mixed = self.train("x.safetensors", "--data", "setpoints.h5", "--validation", "measured.h5",
                           code=2)
        self.assertIn("measured.h5", mixed.stderr)
        other = self.train("x.safetensors", "--from", "m.safetensors", "--data", "setpoints.h5", code=2)
        self.assertIn("m.safetensors: what was measured; setpoints.h5: set points only", other.stderr)
        self.assertFalse((self.folder / "x.safetensors").exists())
        # Leaving out what was measured makes one kind of both.
        both = ("--data", "measured.h5", "--data", "setpoints.h5", "--setpoints")
        self.train("x.safetensors", *both)
        self.assertEqual(self.run_json("inspect", "x.safetensors")["learnt_from"], "setpoints")
        self.train("y.safetensors", "--from", "s.safetensors", "--data", "measured.h5", "--setpoints")
        self.assertEqual(self.run_json("inspect", "y.safetensors")["learnt_from"], "setpoints")

    def test_yardsticks_are_measured_with_set_points(self):
        self.train("s.safetensors", "--data", "setpoints.h5")
        self.train("m.safetensors", "--data", "measured.h5")
        ask = ("evaluate", *ARM, "--model", "s.safetensors", "--data")
        errors = self.run_json(*ask, "setpoints.h5")
        self.assertEqual(errors["commands_are"], "setpoints")
        self.assertIsNone(errors["network"]["open_loop_from_setpoints"])
        for name in ("hold", "linear_one_step", "simple_model"):
            error = errors["baselines"][name]["open_loop"]["position_error_cm"]["mean"]
            self.assertTrue(math.isfinite(error) and error > 0.0, name)
        # The fitted lag makes up for what the no-load model does not know: the valves, for one.
        simple = errors["baselines"]["simple_model"]["open_loop"]["position_error_cm"]["mean"]
        self.assertLess(simple, 0.8 * errors["no_load"]["open_loop"]["position_error_cm"]["mean"])
        # Asked with the set points of a recording that measured too, it says the same.
        again = self.run_json(*ask, "measured.h5")
        self.assertEqual(again["commands_are"], "setpoints")
        self.assertAlmostEqual(errors["network"]["open_loop"]["position_error_cm"]["mean"],
                               again["network"]["open_loop"]["position_error_cm"]["mean"], delta=0.05)
        refused = self.run_limber("evaluate", *ARM, "--model", "m.safetensors", "--data",
                                  "setpoints.h5", code=2)
        self.assertIn("can't be asked without them", refused.stderr.replace("\n", " "))

    def test_no_verb_puts_valves_before_such_a_model(self):
        self.train("s.safetensors", "--data", "setpoints.h5")
        self.train("m.safetensors", "--data", "measured.h5")
        self.run_json("characterize", *ARM, "--valves", "measured.h5", "--out", "valves.yaml")
        self.write("goal.yaml", "schema: limber/environment/1\nname: a turn\nobstacles: []\n"
                   "start: rest\ngoal: {x_m: 0.36, y_m: 0.10, position_tolerance_m: 0.08}\n")
        where = (*ARM, "--environment", "goal.yaml")
        model = ("--model", "s.safetensors")
        search = ("--max-iterations", 2000, "--goal-margin-m", 0, "--margin-m", 0)
        made = self.run_limber("plan", *where, *model, *search, "--out", "plan.json")
        self.assertNotIn("no valve model", made.stderr)
        plan = json.loads((self.folder / "plan.json").read_text(encoding="utf-8"))
        self.assertEqual(plan["valves"], {"hash": ""})
        verify = ("verify", "--plan", "plan.json", *where, *model)
        self.run_limber(*verify)
        self.run_limber(*verify, "--no-valves")
        judged = self.run_json(*verify, "--also", "m.safetensors", code=None)
        self.assertEqual(judged["also"][0]["model"], "m.safetensors")
        execute = ("execute", "--plan", "plan.json", *where)
        self.run_limber(*execute, "--driver", "model:s.safetensors")
        folder = self.folder / "environments"
        folder.mkdir()
        (folder / "goal.yaml").write_bytes((self.folder / "goal.yaml").read_bytes())
        for arguments in (
            ("plan", *where, *model, *search),
            verify,
            (*execute, "--replan", *model),
            ("experiment", *ARM, *model, "--environments", "environments", "--trials", 1,
             "--max-queries", 1000, "--out", "table"),
            ("environment", "check", "goal.yaml", *ARM, *model),
        ):
            with self.subTest(verb=arguments[0]):
                refused = self.run_limber(*arguments, "--valves", "valves.yaml", code=2)
                text = refused.stderr.replace("\n", " ")
                self.assertIn("valves.yaml", text)
                self.assertIn("learnt from set points", text)
        # A plan of a model with valves, judged by one that has learnt them.
        self.run_limber("plan", *where, "--model", "m.safetensors", *search, "--out", "valves.json")
        judged = self.run_json("verify", "--plan", "valves.json", *where, "--model", "m.safetensors",
                               "--also", "s.safetensors", code=None)
        self.assertEqual(judged["also"][0]["model"], "s.safetensors")


if __name__ == "__main__":
    unittest.main()
