"""Bounds of gaps: every trained model has them, `plan` refuses one without, and `train --epochs 0` adds
them; and the windows of the default preset."""

import json
import struct
import unittest

from program import InFolder

ARM = ("--arm", "two_segment")
PLAN = ("--environment", "01_pillar", "--max-iterations", 50)


def without_bounds(content):
    """A model as an earlier limber wrote it."""
    (length,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8:8 + length])
    data = content[8 + length:]
    kept, body = {"__metadata__": header.pop("__metadata__")}, b""
    for name, entry in sorted(header.items(), key=lambda item: item[1]["data_offsets"]):
        if not name.startswith("bounds."):
            part = data[slice(*entry["data_offsets"])]
            kept[name] = {**entry, "data_offsets": [len(body), len(body) + len(part)]}
            body += part
    text = json.dumps(kept).encode()
    text += b" " * (-len(text) % 8)
    return struct.pack("<Q", len(text)) + text + body


class Bounds(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--hold-s", 1.0, "--out", "train.h5", "--count", 12)

    def train(self, *arguments):
        return self.run_json(
            "train", *ARM, "--data", "train.h5", "--hidden", 8, "--out", "m.safetensors", *arguments
        )

    def test_an_old_model_is_refused_by_plan_and_given_bounds_without_training(self):
        trained = self.train("--epochs", 6)
        self.assertEqual(len(trained["bounds"]["min_length_m"]), 10)
        self.assertEqual(trained["long_rollout"]["frames"], 20000)
        self.assertEqual(self.run_json("inspect", "m.safetensors")["bounds"], trained["bounds"])
        old = self.folder / "old.safetensors"
        old.write_bytes(without_bounds((self.folder / "m.safetensors").read_bytes()))
        self.assertIsNone(self.run_json("inspect", "old.safetensors")["bounds"])

        refused = self.run_limber("plan", *ARM, "--model", "old.safetensors", *PLAN, code=2).stderr
        self.assertIn("old.safetensors: the model has no bounds", refused)
        command = "limber train --from old.safetensors --epochs 0 --data train.h5 --out "
        self.assertIn(command, refused)

        evaluate = ("evaluate", *ARM, "--data", "train.h5", "--model")
        before = self.run_json(*evaluate, "old.safetensors")
        given = self.run_json(
            "train", *ARM, "--from", "old.safetensors", "--epochs", 0, "--data", "train.h5",
            "--out", "bounded.safetensors")
        self.assertEqual(given["status"], "bounded")
        bounded = self.run_json("inspect", "bounded.safetensors")
        self.assertEqual(bounded["bounds"], given["bounds"])
        self.assertEqual(bounded["learnt"], self.run_json("inspect", "old.safetensors")["learnt"])
        after = self.run_json(*evaluate, "bounded.safetensors")
        self.assertEqual(after["network"]["one_step"], before["network"]["one_step"])
        result = self.run_limber(
            "plan", *ARM, "--model", "bounded.safetensors", *PLAN, code=None)
        self.assertNotIn("no bounds", result.stderr)

    def test_epochs_0_asks_for_a_model_and_overwrites_nothing(self):
        self.train("--epochs", 3)
        message = self.run_limber(
            "train", *ARM, "--epochs", 0, "--data", "train.h5", "--out", "x.safetensors", code=2
        ).stderr
        self.assertIn("it only adds bounds to an old model, and needs --from MODEL", message)
        message = self.run_limber(
            "train", *ARM, "--from", "m.safetensors", "--epochs", 0, "--data", "train.h5",
            "--out", "m.safetensors", code=2
        ).stderr
        self.assertIn("m.safetensors", message)
        for flags in (("--validation", "train.h5"), ("--hidden", 8), ("--no-velocity",), ("--resume",)):
            message = self.run_limber(
                "train", *ARM, "--from", "m.safetensors", "--epochs", 0, "--data", "train.h5", *flags,
                "--out", "x.safetensors", code=2).stderr
            flag = flags[0].replace("--no-", "--")
            self.assertIn(f"--epochs 0 only adds bounds, and does not use {flag}; leave it out", message)

    def test_little_is_learnt_from_as_a_whole_and_measured_by_folds(self):
        one = self.train("--jobs", 1)
        folds = one["cross_validation"]
        self.assertEqual([t["optimiser"] for t in folds["tried"]], ["soap", "adam"])
        self.assertIn(4, [t["folds"] for t in folds["tried"]])
        self.assertEqual((one["epochs"], one["best_epoch"]), (folds["epochs"], folds["epochs"]))
        self.assertEqual(one["validation_episodes"], [])
        self.assertGreater(one["prediction_error"]["runs"], 0)
        record = self.run_json("inspect", "m.safetensors")["training"]
        self.assertIn("chosen", record["cross_validation"])
        frames = self.run_json("inspect", "train.h5")["frames"]
        self.assertEqual(int(record["training_frames"]), frames)
        self.assertEqual([], list(self.folder.glob("*.checkpoint*")))
        first = (self.folder / "m.safetensors").read_bytes()
        said = self.run_limber("train", *ARM, "--data", "train.h5", "--hidden", 8, "--out", "m.safetensors",
                               "--jobs", 2, "--force").stderr
        self.assertEqual((self.folder / "m.safetensors").read_bytes(), first)
        self.assertIn("no segment's set points take more than 3 values", said)

    def test_validation_by_what_is_learnt_from_is_named(self):
        said = self.run_limber("train", *ARM, "--data", "train.h5", "--validation", "train.h5", "--hidden", 8,
                               "--epochs", 3, "--out", "m.safetensors").stderr
        self.assertIn("--validation train.h5 is learnt from too", said)

    def test_where_something_validates_any_number_of_jobs_gives_the_same(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 5, "--seed", 9, "--out",
                        "other.h5")
        validation = ("--validation", "other.h5")
        one = self.train("--jobs", 1, *validation)
        self.assertEqual(one["epochs"], 180)
        self.assertEqual(self.run_json("inspect", "m.safetensors")["training"]["windows"], "32")
        first = (self.folder / "m.safetensors").read_bytes()
        self.train("--jobs", 2, "--force", *validation)
        self.assertEqual((self.folder / "m.safetensors").read_bytes(), first)

    def test_windows_are_as_given(self):
        self.train("--windows", 8, "--epochs", 3)
        self.assertEqual(self.run_json("inspect", "m.safetensors")["training"]["windows"], "8")


if __name__ == "__main__":
    unittest.main()
