"""examples/six_motors: three discs on tendons, six motors. From logs of motors to a model, a plan and what the motors get."""

import csv
import json
import re
import shutil
import unittest

from program import ROOT, InFolder, limber


class SixMotors(InFolder):
    def setUp(self):
        super().setUp()
        self.mine = self.folder / "mine"
        shutil.copytree(ROOT / "examples" / "six_motors", self.mine)

    def run_ok(self, *arguments):
        result = limber(*arguments, "--json", folder=self.mine)
        self.assertEqual(result.returncode, 0, f"{arguments}\n{result.stderr}")
        return json.loads(result.stdout)

    def imported(self, *trials, out):
        return self.run_ok("import", "csv", *(f"trial_{i}.csv" for i in trials), "--mapping", "mapping.yaml",
                           "--arm", "arm.yaml", "--out", out)

    def test_from_logs_of_six_motors_to_a_plan_in_motors(self):
        found = self.imported(0, 1, 2, 3, out="train.h5")
        self.assertEqual(found["commands_are"], "setpoints")
        self.assertEqual(len(found["columns"]), 3)
        for segment in found["columns"]:
            self.assertGreater(segment["correlation"], 0.8)
        self.imported(4, out="test.h5")
        self.run_ok("characterize", "--arm", "arm.yaml", "--recording", "train.h5", "--out", "fitted.yaml")
        kept = (self.mine / "fitted.yaml").read_text(encoding="utf-8")
        self.assertEqual(re.sub(r"(length_m|curvature_per_unit): [-.0-9]+", r"\1", kept),
                         re.sub(r"(length_m|curvature_per_unit): [-.0-9]+", r"\1",
                                (self.mine / "arm.yaml").read_text(encoding="utf-8")),
                         "fitting leaves all else in the file, comments too")
        self.assertNotIn("curvature_per_unit: -1.5}", kept)
        self.run_ok("train", "--arm", "fitted.yaml", "--data", "train.h5", "--epochs", "150", "--out",
                    "model.safetensors")
        errors = self.run_ok("evaluate", "--arm", "fitted.yaml", "--model", "model.safetensors", "--data",
                             "test.h5", "--fit", "train.h5")
        network = errors["network"]["open_loop"]["position_error_cm"]["mean"]
        for yardstick in ("hold", "linear_one_step"):  # 80 s teach no more than that
            error = errors["baselines"][yardstick]["open_loop"]["position_error_cm"]["mean"]
            self.assertLess(network, error, yardstick)
        said = limber("evaluate", "--arm", "fitted.yaml", "--model", "model.safetensors", "--data", "test.h5",
                      folder=self.mine).stdout
        self.assertRegex(said, "frames beyond what the model learnt from: .* with commands that it knows")
        self.run_ok("plan", "--arm", "fitted.yaml", "--model", "model.safetensors", "--environment",
                    "goal.yaml", "--max-iterations", "3000", "--out", "plan.json")
        self.run_ok("verify", "--plan", "plan.json", "--arm", "fitted.yaml", "--model", "model.safetensors",
                    "--environment", "goal.yaml")
        written = self.run_ok("export", "plan.json", "--csv", "set_points", "--arm", "fitted.yaml")
        self.assertIn("commands.csv", " ".join(written["written"]))
        self.motors_make_the_set_points()

    def rows(self, name):
        with open(self.mine / "set_points" / name, encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def motors_make_the_set_points(self):
        commands, setpoints = self.rows("commands.csv"), self.rows("setpoints.csv")
        self.assertEqual(len(commands), len(setpoints))
        self.assertGreater(len(commands), 5)
        self.assertEqual(list(commands[0]), ["time_s"] + [f"motor_{k}" for k in range(6)])
        for told, wanted in zip(commands, setpoints):
            self.assertEqual(told["time_s"], wanted["time_s"])
            for i in range(3):
                one, other = float(told[f"motor_{2 * i}"]), float(told[f"motor_{2 * i + 1}"])
                self.assertAlmostEqual(0.5 * one - 0.5 * other, float(wanted[f"setpoint_{i}"]), places=5)
                self.assertAlmostEqual(one, -other, places=5)

    def test_shares_are_found_from_logs_and_make_an_arm_file(self):
        text = (self.mine / "arm.yaml").read_text(encoding="utf-8")
        begin, end = text.index("commands:\n"), text.index("\n# How much a radian bends")
        (self.mine / "bare.yaml").write_text(text[:begin] + text[end:], encoding="utf-8")
        refused = limber("import", "csv", "trial_0.csv", "--mapping", "mapping.yaml", "--arm", "bare.yaml",
                         "--dry-run", folder=self.mine)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("6 columns found; expected 3, one for each segment", refused.stderr)
        self.assertIn("limber characterize --commands", refused.stderr)
        asked = ("characterize", "--arm", "bare.yaml", "--commands", "trial_0.csv", "trial_1.csv", "trial_2.csv",
                 "trial_3.csv", "--mapping", "mapping.yaml")
        found = self.run_ok(*asked)
        self.assertEqual(found["idle"], [])
        for k, command in enumerate(found["commands"]):
            self.assertEqual(command["name"], f"motor_{k}")
            for segment, share in enumerate(command["shares"]):
                own = 0.0 if segment != k // 2 else 0.5 if k % 2 == 0 else -0.5
                self.assertAlmostEqual(share, own, delta=0.02 if own else 0.1, msg=f"{command}")
        self.assertIn(["motor_0", "motor_1"], found["alike"])
        said = limber(*asked, folder=self.mine).stdout
        self.assertIn("motor_0 and motor_1 never moved apart from each other", said)
        block = said[said.index("commands:\n"):]
        self.assertEqual(block.rstrip(), found["yaml"].rstrip())
        (self.mine / "arm.yaml").write_text(text[:begin] + text[end:] + block, encoding="utf-8")
        imported = self.imported(0, 1, 2, 3, out="train.h5")
        for segment in imported["columns"]:
            self.assertGreater(segment["correlation"], 0.8)

    def test_shares_of_what_nothing_moves_are_refused(self):
        mapping = (self.mine / "mapping.yaml").read_text(encoding="utf-8")
        (self.mine / "four.yaml").write_text(mapping.replace(", motor_4, motor_5]", "]"), encoding="utf-8")
        result = limber("characterize", "--arm", "arm.yaml", "--commands", "trial_0.csv", "trial_1.csv", "--mapping",
                        "four.yaml", folder=self.mine)
        self.assertEqual(result.returncode, 2)
        self.assertIn("segment 2: no command moves it for certain", result.stderr)
        with_sign = mapping.replace("[motor_0,", "[-motor_0,")
        (self.mine / "sign.yaml").write_text(with_sign, encoding="utf-8")
        result = limber("characterize", "--arm", "arm.yaml", "--commands", "trial_0.csv", "--mapping", "sign.yaml",
                        folder=self.mine)
        self.assertIn("expected a column without a sign", result.stderr)

    def test_inspect_shows_which_commands_make_those_of_segments(self):
        result = limber("inspect", "arm.yaml", folder=self.mine)
        self.assertIn("segment 1 = 0.5 motor_2 - 0.5 motor_3", result.stdout)
        shown = self.run_ok("inspect", "arm.yaml")
        self.assertEqual(shown["commands"][4], {"name": "motor_4", "shares": [0, 0, 0.5]})

    def test_exchanged_motors_are_refused_with_what_would_fit(self):
        mapping = (self.mine / "mapping.yaml").read_text(encoding="utf-8")
        wrong = mapping.replace("[motor_0, motor_1, motor_2, motor_3,", "[motor_2, motor_3, motor_0, motor_1,")
        self.assertNotEqual(wrong, mapping)
        (self.mine / "wrong.yaml").write_text(wrong, encoding="utf-8")
        result = limber("import", "csv", "trial_0.csv", "trial_1.csv", "--mapping", "wrong.yaml", "--arm",
                        "arm.yaml", "--dry-run", folder=self.mine)
        self.assertEqual(result.returncode, 2)
        self.assertIn("segment 0: 0.5 motor_2 - 0.5 motor_3", result.stderr)
        self.assertIn("or 'commands' in the arm file", result.stderr)

    def test_commands_that_can_not_be_are_refused_with_file_and_line(self):
        text = (self.mine / "arm.yaml").read_text(encoding="utf-8")
        line = 1 + text[:text.index("- {name: motor_5")].count("\n")
        for wrong, said in (("{9: -0.5}", f"arm.yaml:{line}: commands[5].acts_on.9: no segment '9'"),
                            ("{}", f"arm.yaml:{line}: commands[5].acts_on: the command acts on nothing")):
            (self.mine / "arm.yaml").write_text(text.replace("{2: -0.5}", wrong), encoding="utf-8")
            result = limber("inspect", "arm.yaml", folder=self.mine)
            self.assertEqual(result.returncode, 2)
            self.assertIn(said, result.stderr)
        alone = text.replace("{2: 0.5}", "{1: 0.1}").replace("{2: -0.5}", "{1: 0.1}")
        (self.mine / "arm.yaml").write_text(alone, encoding="utf-8")
        result = limber("inspect", "arm.yaml", folder=self.mine)
        self.assertIn("no command acts on segment 2", result.stderr)

    def test_recordings_of_other_shares_are_refused(self):
        self.imported(0, 1, out="train.h5")
        text = (self.mine / "arm.yaml").read_text(encoding="utf-8")
        (self.mine / "other.yaml").write_text(text.replace("{0: 0.5}", "{0: 0.25}"), encoding="utf-8")
        result = limber("train", "--arm", "other.yaml", "--data", "train.h5", "--epochs", "3", folder=self.mine)
        self.assertEqual(result.returncode, 2)
        self.assertIn("commands[0].acts_on[0]: 0.5 there, 0.25 here", result.stderr)


if __name__ == "__main__":
    unittest.main()
