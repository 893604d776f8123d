"""Training beyond `train` itself: the simple model fitted to
recordings, broken episodes found."""

import unittest

import numpy as np

import limber
from chain import TWO_SEGMENT, InFolder, chain, run_json, run_program


def settings_of(epochs):
    settings = limber.best_preset()
    settings.hidden_units = [8]
    limber.set_epoch_count(settings, epochs)
    return settings


class Training(InFolder):
    def setUp(self):
        super().setUp()
        self.chain = chain()
        self.episodes = limber.read_recording(self.chain.recording).episodes

    def data(self):
        return limber.hold_back_validation(self.episodes, 0.1, 1)

    def test_results_say_how_the_model_drifts(self):
        data = self.data()
        self.assertEqual(len(data.held_back), len(data.validation))
        result = limber.train(self.chain.arm, data, settings_of(20))
        self.assertEqual(result.long_rollout.frames, 20_000)
        self.assertEqual(result.long_rollout.bounded, result.long_rollout.held_share <= 0.1)
        self.assertIsInstance(result.passed_over_epochs, list)

    def test_what_is_changed_meanwhile_changes_no_run(self):
        data, settings = self.data(), settings_of(6)
        alone = limber.train(self.chain.arm, data, settings).model

        def on_epoch(_):
            data.validation, settings.hidden_units = [], [4]
        other = limber.train(self.chain.arm, data, settings, on_epoch).model
        for one, same in zip(alone.layers, other.layers, strict=True):
            np.testing.assert_array_equal(one.weight, same.weight)

    def test_the_fitted_arm_is_the_programs(self):
        theirs = run_json("characterize", "--arm", TWO_SEGMENT, "--recording",
                          self.chain.recording, "--out", "fitted.yaml", folder=self.folder)
        fit = limber.fit_simple_model(self.chain.arm, self.episodes)
        arm = limber.fitted_arm(self.chain.arm, fit, self.episodes)
        theirs_arm = limber.load_arm(self.folder / "fitted.yaml")
        self.assertEqual(limber.arm_differences(theirs_arm, arm), [])
        self.assertIn("95 %", fit.describe(self.chain.arm))
        self.assertEqual(len(theirs["segments"]), 2)

    def test_a_broken_episode_is_found(self):
        run_program("collect", "--arm", TWO_SEGMENT, "--schedule", "random", "--count", 8,
                    "--episodes", 6, "--hold-s", 1, "--seed", 8, "--out", "six.h5",
                    folder=self.folder)
        episodes = limber.read_recording(self.folder / "six.h5").episodes
        self.assertEqual(limber.episode_errors(self.chain.arm, episodes).outliers, [])
        one, other = episodes[2], episodes[3]
        count = min(len(one), len(other))
        episodes[2] = limber.Episode(one.time_s[:count], other.pressure_kpa[:count],
                                     other.setpoint_kpa[:count], one.backbone[:count],
                                     one.motion_index[:count])
        errors = limber.episode_errors(self.chain.arm, episodes)
        self.assertEqual(errors.outliers, [2])
        self.assertGreater(errors.tip_cm[2], errors.limit_cm)
        self.assertLess(np.median(errors.tip_cm), errors.limit_cm)
        self.assertIn("episode 2", str(errors))


if __name__ == "__main__":
    unittest.main()
