"""Networks that were trained elsewhere: the file that examples/python/model_file.py writes, and the
example that trains in PyTorch."""

import importlib.util
import sys
import unittest

import numpy as np

import limber
import space_oracle as oracle
from chain import EXAMPLES, HANGING, ROOT, TWO_SEGMENT, InFolder, chain, run_example

sys.path.insert(0, str(EXAMPLES))
from model_file import write_network  # noqa: E402

HAS_TORCH = importlib.util.find_spec("torch") is not None
COMMITTED = ROOT / "tests" / "data" / "written_elsewhere.safetensors"
TOLERANCE = 2e-6  # [m, rad]: float32 beside float64 over numbers up to 0.5


def numbers(*shape, seed):
    """The same on every machine: no generator of NumPy's, whose streams may change."""
    k = np.arange(int(np.prod(shape))) + 1000 * seed
    return np.sin(1.0 + 12.9898 * k).reshape(shape).astype(np.float32)


def small_network(arm):
    asked, poses = 2 * arm.segment_count + 6 * arm.point_count, 3 * arm.point_count
    layers = [(0.2 * numbers(8, asked, seed=1), 0.1 * numbers(8, seed=2)),
              (0.05 * numbers(poses, 8, seed=3), 0.01 * numbers(poses, seed=4))]
    inputs = (0.1 * numbers(asked, seed=5), 1 + 0.1 * numbers(asked, seed=6))
    outputs = (0.001 * numbers(poses, seed=7), 2 + 0.1 * numbers(poses, seed=8))
    return layers, inputs, outputs


class ModelFile(InFolder):
    def test_the_writer_still_writes_the_committed_file(self):
        arm = limber.load_arm(TWO_SEGMENT)
        write_network(str(self.folder / "own.safetensors"), arm, *small_network(arm))
        self.assertEqual((self.folder / "own.safetensors").read_bytes(), COMMITTED.read_bytes())

    def test_limber_answers_as_numpy_does(self):
        arm = limber.load_arm(TWO_SEGMENT)
        model = limber.ForwardModel(arm, limber.read_model(COMMITTED))
        layers, (in_offset, in_scale), (out_offset, out_scale) = small_network(arm)
        before, after = np.float32([10, -20]), np.float32([15, -12])
        backbone, free = model.no_load.backbone(before), model.no_load.backbone(after)
        x = np.concatenate([before, after, backbone.ravel(), free.ravel()]).astype(np.float64)
        x = (x - in_offset) * in_scale
        for weight, bias in layers[:-1]:
            x = np.maximum(weight @ x + bias, 0)
        answer = layers[-1][0] @ x + layers[-1][1]
        expected = free + (answer / out_scale + out_offset).reshape(-1, 3)
        np.testing.assert_allclose(model.step(before, after, backbone), expected, atol=TOLERANCE)
        self.assertGreater(np.abs(expected - free).max(), 1000 * TOLERANCE)

    def test_in_space_limber_answers_as_numpy_does(self):
        arm = limber.load_arm(HANGING)
        n, gaps = arm.channel_count, 6 * (arm.point_count - 1)
        asked = 2 * n + gaps + 6 * arm.segment_count
        layers = [(0.2 * numbers(8, asked, seed=1), 0.1 * numbers(8, seed=2)),
                  (0.05 * numbers(gaps, 8, seed=3), 0.01 * numbers(gaps, seed=4))]
        inputs = (0.1 * numbers(asked, seed=5), 1 + 0.1 * numbers(asked, seed=6))
        outputs = (0.001 * numbers(gaps, seed=7), 2 + 0.1 * numbers(gaps, seed=8))
        write_network(str(self.folder / "own.safetensors"), arm, layers, inputs, outputs)
        model = limber.ForwardModel(arm, limber.read_model(self.folder / "own.safetensors"))
        before, after = np.float32([[10, 0, 40, 0, 5, 60]]), np.float32([[15, 5, 30, 9, 0, 70]])
        backbone = model.no_load.backbone(before)
        free = oracle.no_load_gaps(arm, after)
        x = np.concatenate([before[0], after[0], oracle.gaps_of(backbone).ravel(), free.ravel()])
        x = np.maximum(layers[0][0] @ ((x - inputs[0]) * inputs[1]) + layers[0][1], 0)
        answer = (layers[1][0] @ x + layers[1][1]) / outputs[1] + outputs[0]
        expected = oracle.chained(oracle.over_gaps(arm, free) + answer.reshape(1, -1, 6))
        np.testing.assert_allclose(model.step_batch(before, after, backbone), expected,
                                   atol=5 * TOLERANCE)
        self.assertGreater(np.abs(expected - model.no_load.backbone(after)).max(), 1e-2)

    def test_another_arms_file_is_refused(self):
        arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
        with self.assertRaisesRegex(limber.InputError, "two_segment"):
            limber.ForwardModel(arm, limber.read_model(COMMITTED))

    def test_bounds_let_it_plan(self):
        network = limber.read_model(COMMITTED)
        recording = limber.read_recording(chain().recording)
        network.bounds = limber.gap_bounds_of(recording.episodes)
        limber.write_model(self.folder / "bounded.safetensors", network)
        again = limber.read_model(self.folder / "bounded.safetensors")
        np.testing.assert_array_equal(again.layers[0].weight, network.layers[0].weight)
        forward = limber.ForwardModel(chain().arm, again)
        problem = limber.PlanningProblem(chain().arm, limber.MotionModel(forward),
                                         chain().environment)
        result = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=20), 1)
        self.assertIn(result.status, (limber.PlanStatus.solved, limber.PlanStatus.limit))

    @unittest.skipUnless(HAS_TORCH, "PyTorch is not installed: 08_train_in_pytorch was not run")
    def test_08_train_in_pytorch(self):
        arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
        schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=20)
        limber.collect(arm, limber.virtual_collection(arm, schedule),
                       limber.virtual_arm_factory(arm), self.folder / "train.h5")
        result = run_example("08_train_in_pytorch.py", "train.h5", "model.safetensors", 3,
                             folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        losses = [float(line.split()[-1]) for line in result.stdout.splitlines()
                  if line.startswith("epoch")]
        self.assertLess(losses[-1], losses[0])
        limber.ForwardModel(arm, limber.read_model(self.folder / "model.safetensors"))


if __name__ == "__main__":
    unittest.main()
