"""`limber train` and `limber evaluate`: files beside the model, resuming, and what they refuse."""

import json
import os
import re
import signal
import subprocess
import time
import unittest

import h5py

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
        self.assertEqual(len(list((self.folder / "plots").glob("*.svg"))), 5)

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

    def killed(self, *arguments):
        """Starts training and kills it, no signal handler asked, some time after a checkpoint."""
        checkpoint = self.folder / "model.safetensors.checkpoint"
        command = [PROGRAM, "train", *ARM, "--data", "train.h5", "--hidden", "8", *arguments]
        with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL) as process:
            while not checkpoint.exists():
                self.assertIsNone(process.poll(), "training ended before it was killed")
                time.sleep(0.005)
            time.sleep(0.05)
            process.kill()
        self.assertEqual(process.returncode, -signal.SIGKILL)
        self.assertFalse((self.folder / "model.safetensors").exists())

    def test_a_killed_run_loses_what_followed_its_last_checkpoint_and_nothing_else(self):
        for ensemble in ("1", "2"):
            with self.subTest(ensemble=ensemble):
                run = ("--epochs", "600", "--ensemble", ensemble)
                self.train(*run, "--out", "unbroken.safetensors", "--force")
                self.killed(*run, "--checkpoint-interval-s", "0")
                self.train(*run, "--resume")
                self.assertEqual(
                    (self.folder / "model.safetensors").read_bytes(),
                    (self.folder / "unbroken.safetensors").read_bytes(),
                )
                self.assertFalse((self.folder / "model.safetensors.checkpoint").exists())
                for name in ("model.safetensors", "model.curve.csv", "model.curve.svg"):
                    (self.folder / name).unlink()

    def test_a_run_that_is_killed_after_its_folds_goes_on_without_them(self):
        self.train("--out", "unbroken.safetensors")
        folds = self.folder / "model.safetensors.checkpoint.folds.json"
        command = [PROGRAM, "train", *ARM, "--data", "train.h5", "--hidden", "8"]
        with subprocess.Popen(command, cwd=self.folder, stderr=subprocess.DEVNULL) as process:
            while not folds.exists():
                self.assertIsNone(process.poll(), "training ended before it was killed")
                time.sleep(0.002)
            process.kill()
        self.assertFalse((self.folder / "model.safetensors").exists())
        self.assertIn("folds.json: a run with other data or settings began there",
                      self.refused("--resume", "--seed", 9))
        self.assertIn("there is no checkpoint", self.refused("--resume", "--learning-rate", 0.001))
        self.train("--resume")
        self.assertEqual((self.folder / "model.safetensors").read_bytes(),
                         (self.folder / "unbroken.safetensors").read_bytes())
        self.assertEqual([], list(self.folder.glob("model.safetensors.checkpoint*")))

    def test_resuming_with_other_settings_is_refused(self):
        self.killed("--epochs", "3000", "--checkpoint-interval-s", "0")
        message = self.refused("--epochs", 600, "--resume")
        self.assertIn("the checkpoint of a run of 3000 epochs of 32-frame windows", message)
        self.assertIn("leave out --resume to start over", message)
        self.assertIn("a run that was stopped; --resume goes on", self.refused("--epochs", 3000))
        self.assertIn("other data or settings", self.refused("--epochs", 3000, "--resume", "--ensemble", 2))

    def test_an_ensemble_says_how_sure_it_is(self):
        result = self.run_json(
            "train", *ARM, "--data", "train.h5", "--hidden", 8, "--epochs", 30, "--ensemble", 3
        )
        self.assertEqual(result["members"], 3)
        errors = result["member_validation_position_error_cm"]
        self.assertEqual(errors, sorted(errors))
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 5, "--out", "test.h5")
        evaluation = self.run_json(
            "evaluate", *ARM, "--model", "model.safetensors", "--data", "test.h5"
        )["ensemble"]
        self.assertEqual(evaluation["members"], 3)
        self.assertGreater(evaluation["open_loop"]["spread"]["mean_cm"], 0)
        for key in ("one_step", "window_32", "per_motion", "open_loop"):
            self.assertGreater(evaluation[key]["position_error_cm"]["mean"], 0)
        self.assertEqual(self.run_json("inspect", "model.safetensors")["members"], 3)

    def test_velocities_are_read_or_not_as_asked_for_and_kept_by_fine_tuning(self):
        for flags, read in (((), True), (("--velocity",), True), (("--no-velocity",), False),
                            (("--preset", "paper"), False)):
            self.train("--epochs", 3, *flags, "--out", "model.safetensors", "--force")
            found = self.run_json("inspect", "model.safetensors")
            self.assertEqual(found["reads_velocity"], read, flags)
        message = self.train("--epochs", 3, "--from", "model.safetensors", "--velocity",
                             "--out", "other.safetensors", code=2).stderr
        self.assertIn("model.safetensors does not read velocities, and keeps to that", message)

    def test_fine_tuning_shows_errors_before_and_after(self):
        self.train("--epochs", 6, "--out", "old.safetensors")
        self.run_limber(
            "collect", *ARM, "--schedule", "random", "--count", 30, "--out", "new.h5", "--seed", 5
        )
        arguments = ("train", *ARM, "--from", "old.safetensors", "--data", "new.h5", "--epochs", 4)
        result = self.run_json(*arguments, "--old-data", "train.h5")["fine_tuning"]
        for data in ("new_data", "old_data"):
            for when in ("before", "after"):
                error = result[data][when]["open_loop"]["position_error_cm"]["mean"]
                self.assertGreater(error, 0)
        self.assertNotEqual(result["old_data"]["before"], result["old_data"]["after"])
        table = self.run_limber(*arguments, "--force").stdout
        self.assertIn("new data, before", table)
        self.assertNotIn("old data", table)
        message = self.run_limber(*arguments, "--force", "--hidden", 9, code=2).stderr
        self.assertIn("--hidden 9: old.safetensors has hidden layers of 8 units", message)
        message = self.run_limber(*arguments, "--force", "--ensemble", 2, code=2).stderr
        self.assertIn("--ensemble 2: old.safetensors holds 1 networks", message)
        message = self.train("--old-data", "train.h5", "--force", code=2).stderr
        self.assertIn("--old-data requires --from", message)

    def test_nothing_is_overwritten_unasked(self):
        self.write("model.curve.csv", "mine")
        self.assertIn("model.curve.csv: exists already; --force", self.refused("--epochs", 3))
        self.train("--epochs", 3, "--force")
        (self.folder / "plots").mkdir()
        self.write("plots/backbones.svg", "mine")
        evaluate = (
            "evaluate", *ARM, "--model", "model.safetensors", "--data", "train.h5", "--plots", "plots"
        )
        self.assertIn("backbones.svg: exists already", self.run_limber(*evaluate, code=2).stderr)
        self.assertEqual((self.folder / "plots/backbones.svg").read_text(encoding="utf-8"), "mine")
        self.run_limber(*evaluate, "--force")

    def test_what_is_read_is_never_written(self):
        os.symlink("train.h5", self.folder / "link.h5")
        message = "is the file that --data reads; give it another name"
        self.assertIn(message, self.refused("--out", "train.h5", "--force"))
        self.assertIn(message, self.refused("--out", self.folder / "." / "link.h5", "--force"))
        self.train("--epochs", 3)
        result = self.run_limber(
            "bench", "--model", "model.safetensors", "--plot", "model.safetensors", "--force", code=2
        )
        self.assertIn("--plot model.safetensors is the file that --model reads", result.stderr)
        result = self.run_limber("export", "train.h5", "--motive", "train.h5", code=2)
        self.assertIn("--motive train.h5 is the file that the argument file reads", result.stderr)
        twice = ("characterize", *ARM, "--out", "arm.yaml", "--plot", "./arm.yaml")
        message = self.run_limber(*twice, code=2).stderr
        self.assertIn("is the file that", message)
        self.assertIn("also writes", message)

    def test_a_recording_has_one_part(self):
        (self.folder / "copy.h5").write_bytes((self.folder / "train.h5").read_bytes())
        self.assertIn("copy.h5: the same recording as train.h5", self.refused("--data", "copy.h5"))
        self.assertIn("--unseen copy.h5: learnt from", self.refused("--unseen", "copy.h5"))
        for flag in ("--unseen", "--validation"):
            self.assertIn("--family: leave out", self.refused("--family", flag, "copy.h5"))

    def test_an_episode_has_one_part_and_warnings_are_in_the_result(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 12, "--episodes", 3, "--out", "twice.h5")
        with h5py.File(self.folder / "twice.h5", "r+") as file:
            file.copy("episodes/000001", file["episodes"], "000003")
        result = self.run_limber("train", *ARM, "--data", "twice.h5", "--hidden", 8, "--epochs", 3, "--json")
        found = json.loads(result.stdout)
        self.assertEqual(found["warnings"], re.findall(r"^warning: (.*)$", result.stderr, flags=re.M))
        self.assertIn("left out: twice.h5, episode 3, which holds the frames of twice.h5, episode 1 again",
                      found["warnings"])
        too_much = 10  # times, as `evaluate` has it
        self.assertEqual(found["noise_multiplied"] > too_much,
                         any("the noise of a tracker comes out" in warning for warning in found["warnings"]))

    def test_what_was_learnt_before_is_known(self):
        self.train("--epochs", 3, "--out", "old.safetensors")
        (self.folder / "copy.h5").write_bytes((self.folder / "train.h5").read_bytes())
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 30, "--out", "new.h5", "--seed", 5)
        tune = ("train", *ARM, "--from", "old.safetensors", "--epochs", 3, "--data", "new.h5")
        error = self.run_limber(*tune, "--old-data", "train.h5", "--old-data", "new.h5", code=2).stderr
        self.assertIn("new.h5: the same recording as new.h5; give it once", error)
        for more in ((), ("--old-data", "train.h5")):
            error = self.run_limber(*tune, *more, "--unseen", "copy.h5", code=2).stderr
            self.assertIn("--unseen copy.h5: learnt from", error)
        again = self.run_limber("train", *ARM, "--from", "old.safetensors", "--epochs", 3, "--data", "train.h5", "--out",
                                "again.safetensors").stderr
        self.assertIn("the model of --from has learnt train.h5 already", again)
        said = self.run_limber(*tune, "--validation", "copy.h5").stderr
        self.assertIn("--validation copy.h5 is learnt from too", said)
        said = self.run_limber("evaluate", *ARM, "--model", "model.safetensors", "--data", "train.h5").stderr
        self.assertIn("the model was trained on train.h5", said)
        record = self.run_json("inspect", "model.safetensors")["training"]["data"]
        self.assertEqual([entry.split()[0] for entry in record.split(", ")], ["new.h5", "train.h5"])

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
        self.assertIn("3 stages", self.refused("--epochs", 2, "--windows", 2, 8, 32))
        self.assertIn("needs --from MODEL", self.refused("--epochs", 0))
        self.assertIn("--epochs: Value -1 not in range 0 to ", self.refused("--epochs", -1))

    def test_resuming_nothing_is_refused(self):
        self.assertIn("there is no checkpoint", self.refused("--resume"))

    def test_missing_and_broken_recordings_are_refused(self):
        self.assertIn("nothing.h5", self.refused("--data", "nothing.h5"))
        self.write("broken.h5", "no HDF5")
        self.assertIn("broken.h5", self.refused("--data", "broken.h5"))


if __name__ == "__main__":
    unittest.main()
