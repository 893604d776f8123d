"""`limber train` and `limber evaluate`: files beside the model, resuming, and what they refuse."""

import signal
import subprocess
import unittest

from program import PROGRAM, InFolder

ARM = ("--arm", "two_segment")


class Train(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--hold-s", 1.0, "--out", "train.h5", "--count", 12)

    def train(self, *arguments, code=0):
        return self.run_limber(
            "train", *ARM, "--data", "train.h5", "--hidden", 8, *arguments, code=code
        )

    def refused(self, *arguments):
        message = self.train(*arguments, code=2).stderr
        self.assertFalse((self.folder / "model.safetensors").exists())
        return message

    def test_the_learning_curve_lies_beside_the_model(self):
        self.train("--epochs", 6)
        curve = (self.folder / "model.curve.csv").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(curve), 7)
        self.assertIn("<svg", (self.folder / "model.curve.svg").read_text(encoding="utf-8"))
        self.assertFalse((self.folder / "model.safetensors.checkpoint").exists())

    def test_evaluating_on_the_training_data_is_said(self):
        self.train("--epochs", 3)
        result = self.run_limber(
            "evaluate", *ARM, "--model", "model.safetensors", "--data", "train.h5", "--plots", "plots"
        )
        self.assertIn("the model was trained on train.h5", result.stderr)
        self.assertEqual(len(list((self.folder / "plots").glob("*.svg"))), 4)

    def test_a_diverging_run_names_epoch_and_rate(self):
        message = self.train(
            "--preset", "paper", "--learning-rate", 50, "--epochs", 20, code=1
        ).stderr
        self.assertIn("training diverged in epoch ", message)
        self.assertIn("at learning rate 50", message)
        self.assertIn("Try --learning-rate 5", message)

    def test_a_stopped_run_goes_on_to_the_same_model(self):
        self.train("--epochs", 300, "--out", "unbroken.safetensors")
        command = [PROGRAM, "train", *ARM, "--data", "train.h5", "--hidden", "8", "--epochs", "300"]
        with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.PIPE) as process:
            process.stderr.readline()  # "training on …": Ctrl-C is caught by now
            process.send_signal(signal.SIGINT)
            process.communicate()
        self.assertEqual(process.returncode, 1)
        self.train("--epochs", 300, "--resume")
        self.assertEqual(
            (self.folder / "model.safetensors").read_bytes(),
            (self.folder / "unbroken.safetensors").read_bytes(),
        )

    def test_another_arms_recording_is_refused(self):
        message = self.run_limber(
            "train", "--arm", "three_segment", "--data", "train.h5", code=2
        ).stderr
        self.assertIn("train.h5", message)
        self.assertIn("2 segments", message)

    def test_another_arms_model_is_refused(self):
        self.train("--epochs", 3)
        self.run_limber(
            "collect", "--arm", "three_segment", "--schedule", "random", "--count", 1, "--out", "t.h5"
        )
        message = self.run_limber(
            "evaluate", "--arm", "three_segment", "--model", "model.safetensors", "--data", "t.h5",
            code=2,
        ).stderr
        self.assertIn("two_segment", message)

    def test_too_few_epochs_are_refused(self):
        self.assertIn("3 stages", self.refused("--epochs", 2))

    def test_resuming_nothing_is_refused(self):
        self.assertIn("there is no checkpoint", self.refused("--resume"))

    def test_missing_and_broken_recordings_are_refused(self):
        self.assertIn("nothing.h5", self.refused("--data", "nothing.h5"))
        self.write("broken.h5", "no HDF5")
        self.assertIn("broken.h5", self.refused("--data", "broken.h5"))


if __name__ == "__main__":
    unittest.main()
