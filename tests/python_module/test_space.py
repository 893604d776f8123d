"""Arms in space: what Python does with them against an own calculation in NumPy and against the
program."""

import copy
import pathlib
import pickle
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

import limber
import space_oracle as oracle
from chain import HANGING, InFolder, chain, run_json, run_program, space

FLOAT = 2e-6  # [m], of a quaternion: single precision against double, over a chain
NETWORK = 2e-5  # the same behind sums of hundreds of terms


def told(model, episode):
    """Pressures with those of past frames beside them."""
    frames = np.arange(len(episode))
    return np.hstack([episode.pressure_kpa[np.maximum(frames - ago, 0)]
                      for ago in (0, *model.past_commands)])


def queries(model, episode, stride=3):
    """Pressures of two frames and backbones of the two before the second, as they were recorded."""
    t, kpa = np.arange(2, len(episode), stride), told(model, episode)
    return kpa[t - 1], kpa[t], episode.backbone[t - 1], episode.backbone[t - 2]


class Models(unittest.TestCase):
    def setUp(self):
        self.arm = space().arm
        self.model = limber.read_model(space().model)
        self.forward = limber.ForwardModel(self.arm, self.model)

    def test_sizes(self):
        self.assertEqual((self.arm.dimension, self.arm.segment_count, self.arm.channel_count,
                          self.arm.point_count), (3, 2, 6, 9))
        self.assertEqual((self.forward.dimension, self.forward.channel_count), (3, 6))
        self.assertEqual(self.model.dimension, 3)
        self.assertEqual(self.arm.pressure_ranges_kpa.tolist(), [[0, 100]] * 6)
        self.assertEqual([len(s.chambers) for s in self.arm.segments], [3, 3])
        self.assertEqual(self.model.bounds.max_bend_rad.shape, (8,))
        self.assertEqual(chain().arm.dimension, 2)

    def test_the_unloaded_arm_is_that_of_the_equations(self):
        kpa = np.random.default_rng(1).uniform(0, 100, (50, 6)).astype(np.float32)
        kpa[0] = 0
        found = self.forward.no_load.backbone(kpa)
        wanted = oracle.chained(oracle.over_gaps(self.arm, oracle.no_load_gaps(self.arm, kpa)))
        self.assertEqual(found.shape, (50, 9, 7))
        self.assertLess(np.abs(found - wanted).max(), FLOAT)
        self.assertGreater(np.ptp(found[:, -1, 1:3]), 0.1)  # it bends
        self.assertTrue(np.array_equal(self.forward.no_load.backbone(kpa[3]), found[3]))

    def test_the_network_is_that_of_the_equations(self):
        for share in (1.0, 0.02):
            with self.subTest(share), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "model.safetensors"
                path.write_bytes(space().model.read_bytes())
                if share < 1:
                    oracle.tighten_bounds(path, share)
                tensors, _ = oracle.read_tensors(path)
                forward = limber.ForwardModel(self.arm, limber.read_model(path))
                from_kpa, to_kpa, previous, before = queries(self.model, space().episodes[0])
                found = forward.step_batch(from_kpa, to_kpa, previous, before=before)
                query = oracle.query_of(self.arm, from_kpa, to_kpa, previous, before)
                gaps, held = oracle.next_gaps(self.arm, tensors, query,
                                              oracle.answer_of(tensors, query))
                self.assertLess(np.abs(found - oracle.chained(gaps)).max(), NETWORK)
                if share < 1:
                    self.assertGreater(min(held), 0.05, "bounds that hold nothing prove nothing")

    def test_one_query_is_a_batchs_row_and_a_rollouts_frame_to_the_bit(self):
        from_kpa, to_kpa, previous, before = queries(self.model, space().episodes[0])
        rows = self.forward.step_batch(from_kpa, to_kpa, previous, before=before)
        beside = limber.ParallelForward(2).step_batch(self.forward, from_kpa, to_kpa, previous,
                                                      before=before)
        self.assertTrue(np.array_equal(rows, beside))
        for k in (0, 7):
            one = [from_kpa[k], to_kpa[k], previous[k]]
            self.assertTrue(np.array_equal(self.forward.step(*one, before=before[k]), rows[k]))
            self.assertTrue(np.array_equal(self.forward.checked_step(*one, before=before[k]),
                                           rows[k]))
            out = np.array(previous[k])
            self.forward.step(from_kpa[k], to_kpa[k], out, out, before[k])
            self.assertTrue(np.array_equal(out, rows[k]))
        kpa, first = space().episodes[1].pressure_kpa[:30], space().episodes[1].backbone[0]
        rollout = self.forward.rollout(kpa, first)
        kpa, now, earlier = self.forward.told_commands(kpa), first, first
        self.assertTrue(np.array_equal(kpa, told(self.model, space().episodes[1])[:30]))
        for t in range(1, 30):
            now, earlier = self.forward.step(kpa[t - 1], kpa[t], now, before=earlier), now
            self.assertTrue(np.array_equal(rollout[t], now))

    def test_wrong_shapes_and_limits_are_named(self):
        rest = self.forward.no_load.backbone(np.zeros(6))
        fine, plane = np.zeros(self.forward.command_size, np.float32), np.zeros((9, 3), np.float32)
        for call, told in (
                (lambda: self.forward.step(fine, fine, plane),
                 r"previous has shape \(9, 3\); expected \(9, 7\)"),
                (lambda: self.forward.step(fine[:2], fine, rest),
                 r"previous_kpa has shape \(2,\); expected \(30,\)"),
                (lambda: self.forward.rollout(np.zeros((4, 6)), plane),
                 r"first has shape \(9, 3\); expected \(9, 7\)"),
                (lambda: self.forward.checked_step(fine, fine + 106, rest),
                 r"current_kpa\[0\] = 106 kPa; expected .* to 105 kPa, the chamber's limits"),
                (lambda: limber.ForwardModel(chain().arm, self.model), "trained for arm")):
            with self.assertRaisesRegex(limber.InputError, told):
                call()

    def test_an_ensemble_is_its_members(self):
        ensemble = limber.EnsembleForward(self.arm, self.model)
        self.assertEqual(ensemble.member_count, 2)
        kpa, first = space().episodes[1].pressure_kpa[:30], space().episodes[1].backbone[0]
        found = ensemble.rollout(kpa, first)
        leading = self.forward.rollout(kpa, first)
        # Of two, both are as far from the mean as the standard deviation says.
        off = np.abs(leading - found.mean)
        self.assertLess(np.abs(off - found.standard_deviation)[..., :3].max(), FLOAT)
        self.assertGreater(off[-1, -1].max(), 1e-3)
        self.assertLess(np.abs(np.linalg.norm(found.mean[..., 3:], axis=-1) - 1).max(), 1e-6)
        plane = limber.EnsembleForward(chain().arm, limber.read_model(chain().model))
        one = limber.read_recording(chain().recording).episodes[0]
        alone = plane.rollout(one.pressure_kpa, one.backbone[0])
        self.assertEqual(alone.mean.shape, one.backbone.shape)
        self.assertFalse(alone.standard_deviation.any())
        with self.assertRaisesRegex(limber.InputError, r"first has shape \(9, 3\)"):
            ensemble.rollout(kpa, np.zeros((9, 3)))

    def test_errors_are_the_programs(self):
        found = limber.evaluate(limber.ForwardModel(self.arm), self.forward, space().episodes)
        wanted = run_json("evaluate", "--arm", HANGING, "--data", space().recording, "--model",
                          space().model, folder=space().folder)
        self.assertEqual(found.network.open_loop.position_cm.mean,
                         wanted["network"]["open_loop"]["position_error_cm"]["mean"])
        self.assertEqual(found.no_load_open_loop.orientation_rad.mean,
                         wanted["no_load"]["open_loop"]["orientation_error_rad"]["mean"])
        self.assertEqual(wanted["ensemble"]["members"], 2)
        self.assertIn("<svg", found._repr_svg_())
        predicted = limber.predict(self.forward, space().episodes[0],
                                   limber.Restart.at_the_start_only)
        self.assertEqual(predicted.shape, space().episodes[0].backbone.shape)


class Files(InFolder):
    def test_onnx_gives_the_forward_models_backbones(self):
        try:
            import cv2
        except ImportError:
            self.skipTest("python3-opencv is not installed")
        if "missing" in run_json("doctor", folder=self.folder)["onnx"]:
            self.skipTest("limber was built without ONNX")
        path = self.folder / "model.safetensors"
        for share in (1.0, 0.02):
            path.write_bytes(space().model.read_bytes())
            if share < 1:
                oracle.tighten_bounds(path, share)
            run_program("export", path, "--onnx", "model.onnx", "--csv", "queries", "--force",
                        folder=self.folder)
            arm = space().arm
            network = cv2.dnn.readNetFromONNX(str(self.folder / "model.onnx"))
            with open(self.folder / "queries" / "reference_queries.csv", encoding="utf-8") as file:
                inputs = file.readline().count("query_")
                table = np.loadtxt(file, delimiter=",")
            network.setInput(table[:, :inputs].astype(np.float32), "query")
            answers = table[:, inputs:]
            found = network.forward("answer")
            self.assertLess(np.abs(found - answers).max(), 2e-6 + 2e-5 * np.abs(answers).max())
            from_kpa, to_kpa, previous, before = queries(limber.read_model(path), space().episodes[2])
            query = oracle.query_of(arm, from_kpa, to_kpa, previous, before).astype(np.float32)
            network.setInput(query, "query")
            gaps = network.forward("next").astype(np.float64).reshape(len(query), -1, 6)
            forward = limber.ForwardModel(arm, limber.read_model(path))
            wanted = forward.step_batch(from_kpa, to_kpa, previous, before=before)
            self.assertLess(np.abs(oracle.chained(gaps) - wanted).max(), NETWORK)
            _, held = oracle.bounded(oracle.read_tensors(path)[0], gaps)
            self.assertTrue(np.isfinite(gaps).all())

    def test_recordings_go_through_files_pickles_and_tables(self):
        arm, episodes = space().arm, space().episodes
        own = limber.make_recording(arm, [
            limber.Episode(e.time_s, e.pressure_kpa, e.setpoint_kpa, np.array(e.backbone),
                           e.motion_index, e.tracked) for e in episodes], "own", 1)
        limber.write_recording(self.folder / "own.h5", own)
        back = limber.read_recording(self.folder / "own.h5")
        self.assertEqual((back.dimension, back.channel_count, back.segment_count), (3, 6, 2))
        limber.require_recording_of(back, arm)
        run_program("inspect", self.folder / "own.h5", "--arm", HANGING, folder=self.folder)
        *logs, mapping = limber.export_csv(back, self.folder / "logs")
        imported = limber.import_csv(logs, arm, mapping).recording
        for e, one in enumerate(episodes):
            for other in (back.episodes[e], pickle.loads(pickle.dumps(one))):
                self.assertEqual((other.dimension, other.lifted), (3, False))
                self.assertTrue(np.array_equal(one.backbone, other.backbone))
            self.assertEqual(one.backbone.shape[1:], (9, 7))
            self.assertLess(np.abs(imported.episodes[e].backbone - one.backbone).max(), 1e-6)
        self.assertIn("chambers=6", repr(episodes[0]))
        self.assertIn("hanging_3x2", limber.inspect(back, arm))
        model = copy.copy(limber.read_model(space().model))
        self.assertEqual((model.dimension, model.member_count), (3, 2))
        self.assertEqual(limber.arm_to_yaml(pickle.loads(pickle.dumps(arm))),
                         limber.arm_to_yaml(arm))

    def test_the_program_exports_what_it_exports_of_planar_arms(self):
        run_program("export", space().recording, "--csv", "tables", "--motive", "logs",
                    folder=self.folder)
        episode = space().episodes[0]
        table = np.genfromtxt(self.folder / "tables" / "episode_000.csv", delimiter=",", names=True)
        self.assertLess(np.abs(table["z_8_m"] - episode.backbone[:, 8, 2]).max(), 1e-7)
        self.assertLess(np.abs(table["setpoint_5_kpa"] - episode.setpoint_kpa[:, 5]).max(), 1e-5)
        run_program("import", "motive", "logs/episode_000_motive.csv", "--pressures",
                    "logs/episode_000_pressures.csv", "--mapping", "logs/mapping.yaml",
                    "--time-offset-s", 0, "--arm", HANGING, "--out", "back.h5", folder=self.folder)
        back = limber.read_recording(self.folder / "back.h5").episodes[0]
        self.assertLess(np.abs(back.backbone - episode.backbone).max(), 2e-6)
        run_program("export", HANGING, "--mjcf", "arm.xml", folder=self.folder)
        bodies = xml.etree.ElementTree.parse(self.folder / "arm.xml").findall(".//body")
        self.assertEqual(len(bodies), space().arm.point_count)
        run_program("evaluate", "--arm", HANGING, "--data", space().recording, "--model",
                    space().model, "--predictions", "predicted", folder=self.folder)
        predicted = np.genfromtxt(self.folder / "predicted" / "open_loop.csv", delimiter=",",
                                  names=True)
        own = limber.predict(limber.ForwardModel(space().arm, limber.read_model(space().model)),
                             episode, limber.Restart.at_the_start_only)
        found = predicted["network_qy8"][predicted["episode"] == 0]
        self.assertLess(np.nanmax(np.abs(found - own[:, 8, 4])), 1e-6)

    def test_a_planar_recording_is_none_of_an_arm_in_space(self):
        with self.assertRaisesRegex(limber.InputError, "poses of another kind than the recording"):
            limber.make_recording(space().arm, limber.read_recording(chain().recording).episodes)
        with self.assertRaisesRegex(limber.InputError, r"expected \(T, m, 3\), in space \(T, m, 7\)"):
            limber.Episode([0.0], np.zeros((1, 6)), np.zeros((1, 6)), np.zeros((1, 9, 6)), [0])


class Learning(InFolder):
    def test_training_gives_the_programs_bytes(self):
        settings = limber.best_preset()
        settings.hidden_units, settings.seed = [16, 16], 4
        limber.set_epoch_count(settings, 12)
        data = limber.hold_back_validation(space().episodes, 0.34, 4)
        model = limber.train(space().arm, data, settings).model
        self.assertEqual(model.dimension, 3)
        tuned = limber.fine_tune(space().arm, data, limber.fine_tuning_of(settings), model).model
        limber.write_model(self.folder / "own.safetensors", tuned)
        text = run_json("evaluate", "--arm", HANGING, "--data", space().recording, "--model",
                        self.folder / "own.safetensors", folder=self.folder)
        self.assertLess(text["network"]["one_step"]["position_error_cm"]["mean"],
                        text["no_load"]["open_loop"]["position_error_cm"]["mean"])

    def test_the_fit_is_the_programs(self):
        arm, episodes = space().arm, space().episodes
        fit = limber.fit_space_model(arm, episodes)
        wanted = run_json("characterize", "--arm", HANGING, "--recording", space().recording,
                          "--out", "fitted.yaml", folder=self.folder)
        self.assertEqual(fit.tip_mm, wanted["tip_mm"])
        self.assertEqual((fit.shape.shape, fit.shape_sd.shape), ((6, 7), (6, 7)))
        self.assertIn("chamber 0 of segment 1", fit.describe(arm))
        fitted = limber.with_space_fit(arm, fit)
        theirs = limber.load_arm(self.folder / "fitted.yaml")  # with the arm file's comments
        self.assertEqual(limber.arm_to_yaml(fitted), limber.arm_to_yaml(theirs))
        self.assertEqual(fitted.no_load, limber.NoLoadKind.fitted)
        predicted = fit.predict(arm, episodes[0])
        off = np.linalg.norm(predicted[:, -1, :3] - episodes[0].backbone[:, -1, :3], axis=-1)
        self.assertLess(off.mean() * 1e3, 4 * fit.tip_mm)
        with self.assertRaisesRegex(limber.InputError, "is of arms in space; '.*' is in a plane"):
            limber.fit_space_model(chain().arm, limber.read_recording(chain().recording).episodes)

    def test_set_points_alone_are_learnt_from_and_asked_with(self):
        arm = space().arm
        alone = limber.with_setpoints_only(space().episodes)
        settings = limber.best_preset()
        settings.hidden_units = [4]
        limber.set_epoch_count(settings, 3)
        model = limber.train(arm, limber.hold_back_validation(alone, 0.3, 1), settings).model
        self.assertTrue(model.learnt_from_setpoints)
        self.assertEqual(model.past_commands, [2, 4, 8, 16])  # 0.1 to 0.8 s at 20 Hz
        limber.write_model(self.folder / "own.safetensors", model)
        limber.write_recording(self.folder / "alone.h5", limber.make_recording(arm, alone))
        found = run_json("evaluate", "--arm", HANGING, "--data", "alone.h5", "--model",
                         "own.safetensors", folder=self.folder)
        ours = limber.evaluate(limber.ForwardModel(arm), limber.ForwardModel(arm, model), alone)
        self.assertEqual(found["network"]["open_loop"]["position_error_cm"]["mean"],
                         ours.network.open_loop.position_cm.mean)

    def test_the_virtual_arm_and_a_driver_in_python(self):
        arm = space().arm
        virtual = limber.VirtualArm(arm)
        state = virtual.settle([80, 0, 0, 0, 0, 0], 2)
        self.assertEqual(state.backbone.shape, (9, 7))
        self.assertLess(np.abs(state.backbone - virtual.true_backbone()).max(), 1e-6)
        own = limber.ArmState(state.time_s, state.pressure_kpa, state.backbone)
        self.assertTrue(np.array_equal(own.backbone, state.backbone))

        class Driver(limber.ArmDriver):
            def __init__(self):
                self.arm = limber.VirtualArm(arm)

            def state(self):
                return self.arm.state()

            def command(self, setpoint_kpa):
                return self.arm.command(setpoint_kpa)

            def vent(self):
                self.arm.vent()

        schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=2, hold_s=0.5)
        settings = limber.virtual_collection(arm, schedule)
        recordings = [limber.collect(arm, settings, make, self.folder / f"{name}.h5").recording
                      for name, make in (("own", lambda _: Driver()),
                                         ("virtual", limber.virtual_arm_factory(arm)))]
        a, b = (recording.episodes[0].backbone for recording in recordings)
        self.assertTrue(np.array_equal(a, b))


class Families(InFolder):
    """Adapting, tuning and measuring in Python, as in a plane."""

    def test_a_family_becomes_one_arms(self):
        run_program("collect", "--arm", HANGING, "--schedule", "random", "--count", 12, "--episodes", 14,
                    "--vary-physics", 2, "--seed", 3, "--out", "arms.h5", folder=self.folder)
        arm = space().arm
        *others, mine = limber.read_recording(self.folder / "arms.h5").episodes
        settings = limber.best_preset()
        limber.set_family_size(settings, 2)
        settings.hidden_units = [24]
        limber.set_epoch_count(settings, 60)
        family = limber.train(arm, limber.hold_back_arms(others, range(len(others)), 0.1, 1), settings).model
        self.assertTrue(limber.is_family(family))
        done = limber.adapt(arm, family, [mine], train_weights=False)
        self.assertFalse(limber.is_family(done.model))
        self.assertLess(done.uncertainty, 0.95)
        found = limber.predict(limber.ForwardModel(arm, done.model), mine, limber.Restart.every_frame)
        self.assertEqual(np.asarray(found).shape, mine.backbone.shape)
        e = np.array([0.5, -0.5])
        followed = limber.model_of_followed_arm(done.model, e)
        other = limber.model_of_followed_arm(followed, e + 1.0)
        back = limber.model_of_followed_arm(other, e)
        found = limber.predict(limber.ForwardModel(arm, followed), mine, limber.Restart.every_frame)
        for model, is_same in ((other, False), (back, True)):
            again = limber.predict(limber.ForwardModel(arm, model), mine, limber.Restart.every_frame)
            self.assertEqual(np.allclose(again, found, atol=1e-5, equal_nan=True), is_same)
        with self.assertRaisesRegex(limber.InputError, "3 numbers that say which arm"):
            limber.model_of_followed_arm(done.model, np.zeros(3))

    def test_a_model_is_tuned_and_its_error_is_measured(self):
        arm, episodes = space().arm, space().episodes
        start = limber.read_model(space().model)
        settings = limber.fine_tuning_of(limber.best_preset())
        limber.set_epoch_count(settings, 3)
        data = limber.TrainingData(episodes[:2], episodes[2:])
        tuned = limber.fine_tune(arm, data, settings, start).model
        self.assertEqual(tuned.shape, start.shape)
        limber.note_unseen(arm, tuned, episodes[2:])
        self.assertGreater(tuned.prediction_error.max_position_m, 0)

    def test_signs_of_quaternions_are_made_continuous(self):
        own = space().episodes[0]
        flipped = own.backbone.copy()
        flipped[::3, 1:, 3:] *= -1
        foreign = limber.Episode(own.time_s, own.pressure_kpa, own.setpoint_kpa, flipped, own.motion_index)
        np.testing.assert_array_equal(foreign.backbone, own.backbone)


if __name__ == "__main__":
    unittest.main()
