"""The valves between set points and pressures: found without being asked, stored with models, shown."""

import unittest

from program import ROOT, InFolder

ARM = ("--arm", "two_segment")


class Valves(InFolder):
    def collect(self, name="train.h5", arm=ARM, *arguments):
        return self.run_json(
            "collect", *arm, "--schedule", "random", "--count", 8, "--episodes", 5, "--hold-s", 1.5,
            "--hold-min-s", 0.2, "--out", name, *arguments,
        )

    def train(self, name, *arguments):
        return self.run_json(
            "train", *ARM, "--data", "train.h5", "--epochs", 3, "--hidden", 8, "--out", name,
            *arguments,
        )

    def test_every_verb_that_meets_a_recording_tells_the_same(self):
        collected = self.collect()["valves"]
        self.assertEqual(collected["schema"], "limber/valves/1")
        self.assertEqual(len(collected["segments"]), 2)
        segment = collected["segments"][0]
        # The virtual arm's 0.1 s and 0.01 s, but for what its controller adds (docs/valves.md).
        self.assertAlmostEqual(segment["inflate_time_constant_s"], 0.1, delta=0.01)
        self.assertAlmostEqual(segment["dead_time_s"], 0.01, delta=0.005)
        error = collected["identified"]["held_back_error"]
        self.assertLess(error["mean_kpa"], 0.5)
        self.assertLess(error["max_kpa"], 3.0)
        inspected = self.run_json("inspect", "train.h5", *ARM)["valves"]
        self.assertEqual(inspected["segments"], collected["segments"])
        result = self.run_limber("train", *ARM, "--data", "train.h5", "--epochs", 3, "--hidden", 8)
        self.assertIn("valves: inflate 0.0", result.stderr)
        model = self.run_json("inspect", "model.safetensors")["valves"]
        self.assertEqual(model["segments"], collected["segments"])
        self.assertEqual(model["identified"]["source"], "train.h5")

    def test_characterize_writes_and_draws_them(self):
        self.collect()
        found = self.run_json(
            "characterize", *ARM, "--valves", "train.h5", "--out", "valves.yaml", "--plots", "plots"
        )
        svg = (self.folder / "plots" / "valves.svg").read_text(encoding="utf-8")
        self.assertIn("modelled from the set points", svg)
        read = self.run_json("inspect", "valves.yaml", *ARM)
        self.assertEqual(read["kind"], "valves")
        self.assertEqual(read["segments"], found["segments"])
        self.assertEqual(read["hash"], found["hash"])
        other = self.run_limber("inspect", "valves.yaml", "--arm", "three_segment", code=2)
        self.assertIn("2 segments found; the arm has 3", other.stderr)
        again = self.run_limber(
            "characterize", *ARM, "--valves", "train.h5", "--out", "valves.yaml", code=2
        )
        self.assertIn("--force", again.stderr)

    def test_a_model_to_go_on_from_keeps_its_valves_where_new_data_tell_nothing(self):
        self.collect()
        first = self.train("first.safetensors", "--ensemble", 2)["valves"]
        self.assertEqual(len(first["segments"]), 2)
        self.run_json(
            "collect", *ARM, "--schedule", "random", "--count", 2, "--out", "little.h5"
        )
        second = self.run_json(
            "train", *ARM, "--data", "little.h5", "--from", "first.safetensors", "--epochs", 1,
            "--out", "second.safetensors",
        )["valves"]
        self.assertEqual(second["segments"], first["segments"])
        self.assertEqual(second["identified"]["source"], "train.h5")

    def test_evaluation_predicts_from_set_points_too(self):
        self.collect()
        self.train("model.safetensors")
        self.collect("test.h5", ARM, "--seed", 7)
        network = self.run_json(
            "evaluate", *ARM, "--model", "model.safetensors", "--data", "test.h5"
        )["network"]
        measured = network["open_loop"]["position_error_cm"]["mean"]
        planned = network["open_loop_from_setpoints"]["position_error_cm"]["mean"]
        self.assertLess(abs(planned - measured), 0.2 * measured)

    def test_a_recording_that_tells_nothing_says_why(self):
        self.run_json("collect", *ARM, "--schedule", "random", "--count", 2, "--out", "little.h5")
        found = self.run_json("characterize", *ARM, "--valves", "little.h5", code=1)
        self.assertEqual(found["segments"], [])
        self.assertIn("error: little.h5: no valves were found; v.yaml was not written", self.run_limber(
            "characterize", *ARM, "--valves", "little.h5", "--out", "v.yaml", "--quiet", code=1).stderr)
        self.assertIn("set points change in", found["identified"]["reason"])

    def test_other_peoples_valves_are_recovered(self):
        arm = ("--arm", str(ROOT / "tests" / "arms" / "late_valves.yaml"))
        segment = self.collect("late.h5", arm, "--noise-kpa", 0.5)["valves"]["segments"][0]
        self.assertAlmostEqual(segment["dead_time_s"], 0.13 + 0.01, delta=0.005)
        self.assertAlmostEqual(segment["vent_time_constant_s"], 0.12, delta=0.012)


if __name__ == "__main__":
    unittest.main()
