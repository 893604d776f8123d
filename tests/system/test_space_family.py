"""Families, fine-tuning and measured errors of arms in space, and the page in which they are turned."""

import unittest

from program import WithFiles

ARM = ("--arm", "hanging_3x2")
RANDOM = ("collect", *ARM, "--schedule", "random")
SMALL = ("--hidden", 30, "--epochs", 40)


class SpaceFamily(WithFiles):
    FILES = (
        ("arms.h5", (*RANDOM, "--count", 12, "--episodes", 14, "--vary-physics", 2, "--seed", 3)),
        ("minute.h5", (*RANDOM, "--count", 30, "--vary-physics", 2, "--seed", 70)),
        ("other.h5", (*RANDOM, "--count", 60, "--vary-physics", 2, "--seed", 70)),
        ("family.safetensors", ("train", *ARM, "--family", "--family-size", 2, "--data", "arms.h5", *SMALL)),
        ("one.safetensors", ("train", *ARM, "--data", "minute.h5", *SMALL)),
    )

    def adapt(self, *arguments):
        return self.run_json("adapt", *ARM, "--model", "family.safetensors", "--recording", "minute.h5",
                             "--weights", "never", "--out", "mine.safetensors", *arguments)

    def test_every_episode_of_varied_arms_is_an_arm(self):
        family = self.run_json("inspect", "family.safetensors")["family"]
        self.assertEqual(family["arms"], 13)  # one of fourteen validates

    def test_a_minute_makes_it_an_ordinary_model_of_one_arm(self):
        found = self.adapt()
        self.assertEqual(len(found["e"]), 2)
        self.assertLess(found["error_cm"]["e_alone"], found["error_cm"]["family_middle"])
        model = self.run_json("inspect", "mine.safetensors")
        self.assertGreater(model["prediction_error"]["largest_cm_p95"], 0)
        self.assertIsNone(model.get("tube"))
        self.run_json("evaluate", *ARM, "--model", "mine.safetensors", "--data", "other.h5")
        self.run_limber("export", "mine.safetensors", "--onnx", "mine.onnx")
        error = self.run_limber("evaluate", *ARM, "--model", "family.safetensors", "--data", "other.h5", code=2).stderr
        self.assertIn("limber adapt --model family.safetensors", error)
        error = self.run_limber("plan", *ARM, "--model", "mine.safetensors", "--environment", "01_pillar", code=2).stderr
        self.assertIn("limber plan can't use an arm in space yet", error)
        error = self.run_limber("improve", *ARM, "--model", "mine.safetensors", "--data", "minute.h5", code=2).stderr
        self.assertIn("limber improve can't use an arm in space yet", error)
        self.assertFalse((self.folder / "improved").exists())

    def test_limber_family_makes_one_without_a_tube(self):
        small = ("family", *ARM, "--hours", 0.1, "--family-size", 2, *SMALL)
        self.assertIsNone(self.run_json(*small, "--out", "own.safetensors")["tube"])
        self.run_json("adapt", *ARM, "--model", "own.safetensors", "--recording", "minute.h5",
                      "--weights", "never", "--out", "x.safetensors")
        error = self.run_limber(*small, "--tube-runs", 10, "--out", "y.safetensors", code=2).stderr
        self.assertIn("limber family --tube-runs can't use an arm in space yet", error)

    def test_training_goes_on_from_a_model(self):
        tuned = self.run_json("train", *ARM, "--from", "one.safetensors", "--data", "minute.h5", "--epochs", 10,
                              "--out", "tuned.safetensors")
        self.assertIn("fine_tuning", tuned)
        self.assertGreater(tuned["prediction_error"]["runs"], 0)
        shapes = [self.run_json("inspect", f"{name}.safetensors")["shape"] for name in ("one", "tuned")]
        self.assertEqual(*shapes)
        bounded = self.run_json("train", *ARM, "--from", "one.safetensors", "--data", "other.h5", "--epochs", 0,
                                "--out", "bounded.safetensors")
        self.assertGreater(max(bounded["bounds"]["max_bend_rad"]), 0)

    def test_evaluate_stores_the_error_and_writes_a_page(self):
        found = self.run_json("evaluate", *ARM, "--model", "one.safetensors", "--data", "other.h5",
                              "--plots", "plots", "--out", "measured.safetensors")
        measured = self.run_json("inspect", "measured.safetensors")["prediction_error"]
        self.assertEqual(measured, found["prediction_error"])
        self.assertLessEqual(measured["off_path_cm_p95"], measured["largest_cm_p95"])
        page = (self.folder / "plots/shapes.html").read_text()
        self.assertIn("hanging_3x2: recorded and predicted", page)
        self.assertIn('"name":"network, open loop"', page)
        for loaded in ("src=", "href=", "http-equiv=\"refresh\""):
            self.assertNotIn(loaded, page)
        self.run_limber("evaluate", *ARM, "--data", "other.h5", "--plots", "plots", code=2)  # in the way


if __name__ == "__main__":
    unittest.main()
