"""The chain from bench test to evaluation, verb by verb, on little data: files, JSON keys, and the
same result for the same seed, whatever the number of threads."""

import unittest

from program import InFolder

ARM = ("--arm", "two_segment")


def numbers_in(tree):
    """Every number of a JSON tree."""
    if isinstance(tree, dict):
        return [number for value in tree.values() for number in numbers_in(value)]
    return [tree] if isinstance(tree, (int, float)) else []


class Chain(InFolder):
    def collect(self, name, *arguments):
        return self.run_json("collect", *ARM, "--hold-s", 1.5, "--out", name, *arguments)

    def collect_both(self):
        self.collect("train.h5")
        self.collect("test.h5", "--schedule", "random", "--count", 10, "--seed", 7)

    def train(self, name, *arguments):
        return self.run_json(
            "train", *ARM, "--data", "train.h5", "--epochs", 12, "--hidden", 16, 16, "--out", name,
            *arguments,
        )

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_characterize_writes_an_arm_that_the_other_verbs_read(self):
        self.run_limber("characterize", *ARM, "--out", "mine.yaml", "--plot", "bench.svg")
        self.run_limber(
            "collect", "--arm", "mine.yaml", "--schedule", "random", "--count", 1, "--out", "x.h5"
        )
        self.assertIn("<svg", (self.folder / "bench.svg").read_text(encoding="utf-8"))

    def test_transitions_are_all_ordered_pairs(self):
        self.assertEqual(self.collect("train.h5")["motions"], 81)

    def test_recordings_are_the_same_for_any_number_of_threads(self):
        self.collect("one.h5", "--jobs", 1)
        self.collect("two.h5", "--jobs", 2)
        self.assertEqual(self.bytes_of("one.h5"), self.bytes_of("two.h5"))

    def test_another_seed_records_other_motions(self):
        random = ("--schedule", "random", "--count", 2)
        self.collect("one.h5", *random, "--seed", 1)
        self.collect("two.h5", *random, "--seed", 2)
        self.assertNotEqual(self.bytes_of("one.h5"), self.bytes_of("two.h5"))

    def test_an_existing_file_is_kept_without_force(self):
        self.write("train.h5", "precious")
        result = self.run_limber("collect", *ARM, "--out", "train.h5", code=2)
        self.assertIn("--force", result.stderr)
        self.assertEqual(self.bytes_of("train.h5"), b"precious")

    def test_evaluation_reports_every_way_of_predicting(self):
        self.collect_both()
        trained = self.train("model.safetensors")
        self.assertEqual(trained["epochs"], 12)
        found = self.run_json(
            "evaluate", *ARM, "--model", "model.safetensors", "--data", "test.h5", "--plots", "plots"
        )
        statistics = {"mean", "std", "p95", "worst_motion"}
        errors = {"position_error_cm", "orientation_error_rad", "plates_error_cm"}
        kinds = {
            "one_step", "one_step_moving", "window_32", "per_motion", "open_loop",
            "open_loop_from_setpoints",
        }
        self.assertEqual(set(found["network"]), kinds)
        self.assertEqual(set(found["no_load"]), {"open_loop"})
        self.assertEqual(
            set(found["baselines"]),
            {"hold", "constant_velocity", "linear_one_step", "simple_model"},
        )
        for kind in kinds:
            self.assertEqual(set(found["network"][kind]), errors)
            for error in errors:
                self.assertEqual(set(found["network"][kind][error]), statistics)
        self.assertEqual(found["long_rollout"]["frames"], 20000)
        rollout = found["long_rollout"]
        self.assertIs(rollout["bounded"], rollout["held_share"] <= 0.1)
        for number in numbers_in(found):
            self.assertTrue(-1e6 < number < 1e6, number)
        no_load = found["no_load"]["open_loop"]["position_error_cm"]["mean"]
        network = found["network"]["open_loop"]["position_error_cm"]["mean"]
        self.assertAlmostEqual(
            found["reduction_percent"]["position"], 100 * (1 - network / no_load), places=6
        )
        self.assertGreater(len(list((self.folder / "plots").glob("*.svg"))), 2)

    def test_training_is_the_same_for_any_number_of_threads(self):
        self.collect_both()
        first = self.train("one.safetensors", "--jobs", 1)
        second = self.train("two.safetensors", "--jobs", 2)
        self.assertEqual(first["loss"], second["loss"])
        # The record holds the wall time; everything else is the same.
        evaluate = ("evaluate", *ARM, "--data", "test.h5", "--model")
        self.assertEqual(
            self.run_json(*evaluate, "one.safetensors"), self.run_json(*evaluate, "two.safetensors")
        )

    def test_files_that_do_not_belong_together_are_refused(self):
        self.collect_both()
        self.train("model.safetensors")
        data = ("--data", "test.h5")
        wrong_arm = self.run_limber(
            "evaluate", "--arm", "three_segment", "--model", "model.safetensors", *data, code=2
        )
        self.assertIn("two_segment", wrong_arm.stderr)
        self.assertIn("three_segment", wrong_arm.stderr)
        swapped = self.run_limber(
            "evaluate", *ARM, "--model", "test.h5", "--data", "test.h5", code=2
        )
        self.assertIn("test.h5", swapped.stderr)
        missing = self.run_limber("evaluate", *ARM, "--data", "none.h5", code=2)
        self.assertIn("none.h5", missing.stderr)

    def test_damaged_files_are_refused_by_name(self):
        self.collect_both()
        self.train("model.safetensors")
        for name in ("test.h5", "model.safetensors"):
            whole = self.bytes_of(name)
            for kept in (0, 7, len(whole) // 2, len(whole) - 1):
                with self.subTest(name=name, kept=kept):
                    (self.folder / name).write_bytes(whole[:kept])
                    result = self.run_limber(
                        "evaluate", *ARM, "--model", "model.safetensors", "--data", "test.h5", code=2
                    )
                    self.assertIn(name, result.stderr)
            (self.folder / name).write_bytes(whole)


if __name__ == "__main__":
    unittest.main()
