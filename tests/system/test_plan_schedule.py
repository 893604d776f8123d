"""`limber collect --schedule plans`, and `limber improve`, which learns from it in rounds."""

import unittest

from program import InFolder

ARM = ("--arm", "two_segment")


class PlanSchedule(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 10, "--episodes", 6, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 20, "--out", "m.safetensors")

    def collect(self, out, *arguments):
        return self.run_json("collect", *ARM, "--schedule", "plans", "--model", "m.safetensors", "--episodes", 2,
                             "--count", 3, "--max-queries", 3000, "--out", out, *arguments)

    def error(self, *arguments):
        return self.run_limber("collect", *ARM, *arguments, code=2).stderr

    def test_model_seed_and_counts_decide_the_recording(self):
        one = self.collect("one.h5", "--jobs", 1)
        self.collect("two.h5", "--jobs", 2)
        self.assertEqual((self.folder / "one.h5").read_bytes(), (self.folder / "two.h5").read_bytes())
        self.assertEqual((one["episodes"], one["motions"]), (2, 6))
        self.assertIn("plans, 2 episodes of 3, 3000 queries each, model ", one["settings"])
        again = self.collect("one.h5", "--resume")
        self.assertEqual(again["episodes_kept_from_before"], 2)

    def test_a_model_and_the_schedule_go_together(self):
        for arguments in (("--schedule", "plans"), ("--schedule", "random", "--count", 1, "--model", "m.safetensors")):
            self.assertIn("--schedule plans and --model: expected both or neither",
                          self.error(*arguments, "--out", "x.h5"))
        self.assertIn("--schedule plans has its own holds",
                      self.error("--schedule", "plans", "--model", "m.safetensors", "--hold-s", 1, "--out", "x.h5"))
        self.assertIn("m.safetensors: trained for arm 'two_segment'", self.run_limber(
            "plan", "--model", "m.safetensors", "--environment", "01_pillar", code=2).stderr)

    def test_what_cannot_be_is_refused_before_any_planning(self):
        self.write("x.h5", "mine")
        plans = ("--schedule", "plans", "--model", "m.safetensors", "--out")
        self.assertIn("x.h5: exists already", self.error(*plans, "x.h5"))
        self.assertIn("--count -3: expected 1", self.error(*plans, "y.h5", "--count", -3))
        self.assertIn("--episodes -2: expected 1", self.error(*plans, "y.h5", "--episodes", -2))
        self.assertIn("--count -5", self.error("--schedule", "identify", "--count", -5, "--out", "y.h5"))

    def improve(self, *arguments):
        return self.run_json("improve", *ARM, "--model", "m.safetensors", "--data", "t.h5", "--plans", 4,
                             "--epochs", 2, "--max-queries", 3000, "--out", "rounds", *arguments)

    def test_rounds_learn_from_plans_and_go_on(self):
        one = self.improve("--rounds", 1)
        self.assertEqual([list(found) for found in one["rounds"]], [["round", "collect", "train"]])
        self.assertEqual(one["rounds"][0]["collect"]["motions"], 4)
        model = self.folder / "rounds" / "model.safetensors"
        self.assertEqual(model.read_bytes(), (self.folder / "rounds/round_1/model.safetensors").read_bytes())
        self.assertIn("holds rounds already",
                      self.run_limber("improve", *ARM, "--model", "m.safetensors", "--data", "t.h5", "--out", "rounds",
                                      code=2).stderr)
        two = self.improve("--rounds", 2, "--resume")
        self.assertEqual(two["rounds"][0], one["rounds"][0])
        data = self.run_json("inspect", model)["training"]["data"]
        self.assertIn("plans.h5", data)
        first = model.read_bytes()
        (self.folder / "rounds/round_2/train.json").unlink()
        self.improve("--rounds", 2, "--resume")
        self.assertEqual(model.read_bytes(), first)
        # Stopped between the recording's end and its note: the arm is not moved again.
        recording = self.folder / "rounds/round_2/plans.h5"
        (self.folder / "rounds/round_2/collect.json").unlink()
        before = recording.stat().st_mtime_ns
        self.improve("--rounds", 2, "--resume")
        self.assertEqual(recording.stat().st_mtime_ns, before)
        self.assertIn("another model, data or settings",
                      self.run_limber("improve", *ARM, "--model", "m.safetensors", "--data", "t.h5", "--plans", 5,
                                      "--resume", "--out", "rounds", code=2).stderr)

    def test_nothing_of_the_users_is_replaced(self):
        plans, model = self.folder / "out/round_1/plans.h5", self.folder / "out/model.safetensors"
        plans.parent.mkdir(parents=True)
        plans.write_bytes((self.folder / "t.h5").read_bytes())
        command = ("improve", *ARM, "--out", "out", "--model", "m.safetensors", "--data", "t.h5")
        self.assertIn("plans.h5: exists already", self.run_limber(*command, "--resume", code=2).stderr)
        model.write_bytes((self.folder / "m.safetensors").read_bytes())
        before = plans.read_bytes(), model.read_bytes()
        for inputs, told in ((("m.safetensors", "t.h5"), "exists already"),
                             (("m.safetensors", plans, "--force"), "plans.h5 lies in out, the folder for results"),
                             ((model, "t.h5", "--force"), "model.safetensors lies in out, the folder for results")):
            command = ("improve", *ARM, "--out", "out", "--model", inputs[0], "--data", *inputs[1:])
            self.assertIn(told, self.run_limber(*command, code=2).stderr)
            self.assertEqual((plans.read_bytes(), model.read_bytes()), before)


if __name__ == "__main__":
    unittest.main()
