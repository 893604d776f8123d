"""NumPy arrays at the border: what is copied, what is shared, and what is refused."""

import ctypes
import os
import tracemalloc
import unittest

import numpy as np

import limber
from chain import TWO_SEGMENT, chain

QUERIES = 4096
LARGE = 100000  # queries: 19 MB of backbones
SMALL = 4096  # bytes that Python allocates for a call itself, far below one array of a batch


def batch(arm, queries, seed=1):
    """Random queries of an arm: pressures before and after, and backbones of the first."""
    random = np.random.default_rng(seed)
    limits = arm.pressure_limits_kpa
    before, after = (random.uniform(-limits, limits, (queries, arm.segment_count))
                     .astype(np.float32) for _ in range(2))
    return before, after, limber.NoLoadModel(arm).backbone(before)


def peak_of(function):
    """Most bytes that NumPy and Python held at once, over what they held before."""
    function()
    tracemalloc.start()
    function()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak


class MallocInfo(ctypes.Structure):
    """What glibc says of its memory: sizes in bytes."""

    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks",
        "fordblks", "keepcost")]


def native_bytes():
    """In use by whatever language, big blocks (which are mapped) counted; None without glibc."""
    try:
        mallinfo2 = ctypes.CDLL(None).mallinfo2
    except AttributeError:
        return None
    mallinfo2.restype = MallocInfo
    info = mallinfo2()
    return info.uordblks + info.hblkhd


class Peak:
    """Most memory of the process in use at once during a call, over what it was before.

    The kernel's high-water mark (VmHWM) shows what no snapshot between two calls would: an array
    that is made and given back within one, by whatever language.
    """

    @staticmethod
    def of(function):
        function()  # what is made once: workspaces, threads
        before = Peak.reset()
        function()
        return Peak.high_water() - before

    @staticmethod
    def reset():
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write("5")
        return Peak.high_water()

    @staticmethod
    def high_water():
        with open("/proc/self/status", encoding="ascii") as file:
            (line,) = [line for line in file if line.startswith("VmHWM:")]
        return int(line.split()[1]) * 1024


class Arrays(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.arm = limber.load_arm(TWO_SEGMENT)
        cls.model = limber.ForwardModel(cls.arm, limber.read_model(chain().model))
        cls.before, cls.after, cls.backbones = batch(cls.arm, QUERIES)

    def test_results_are_written_to_out_itself(self):
        out = np.empty_like(self.backbones)
        result = self.model.step_batch(self.before, self.after, self.backbones, out)
        self.assertTrue(np.shares_memory(result, out))
        np.testing.assert_array_equal(
            out, self.model.step_batch(self.before, self.after, self.backbones))

    def test_contiguous_float32_is_not_copied(self):
        out = np.empty_like(self.backbones)
        peak = peak_of(lambda: self.model.step_batch(self.before, self.after, self.backbones, out))
        self.assertLess(peak, SMALL)

    def calls_with_results_in_place(self):
        """By name: of batches so large that a copy of one array shows among pages of memory."""
        before, after, backbones = batch(self.arm, LARGE)
        out = np.empty_like(backbones)
        no_load = limber.NoLoadModel(self.arm)
        parallel = limber.ParallelForward(2)
        return backbones.nbytes, {
            "step_batch": lambda: self.model.step_batch(before, after, backbones, out),
            "NoLoadModel.backbone": lambda: no_load.backbone(before, out),
            "ParallelForward.step_batch":
                lambda: parallel.step_batch(self.model, before, after, backbones, out),
        }, lambda: self.model.rollout(before, backbones[0])

    def test_nothing_is_copied_natively_either(self):
        size, calls, rollout = self.calls_with_results_in_place()
        if native_bytes() is None or not os.access("/proc/self/clear_refs", os.W_OK):
            self.skipTest("neither glibc nor Linux: native memory is not counted")
        for name, call in calls.items():
            call()
            before = native_bytes()
            call()
            self.assertLess(native_bytes() - before, SMALL, name)  # and nothing is kept
            self.assertLess(Peak.of(call), size / 4, name)
        self.assertLess(Peak.of(rollout), 1.25 * size)  # its result alone

    def test_anything_else_is_copied_once(self):
        out = np.empty_like(self.backbones)
        for other in (self.backbones.astype(np.float64), np.asfortranarray(self.backbones),
                      np.repeat(self.backbones, 2, axis=0)[::2]):
            peak = peak_of(lambda: self.model.step_batch(self.before, self.after, other, out))
            self.assertGreaterEqual(peak, self.backbones.nbytes)
            self.assertLess(peak, self.backbones.nbytes + SMALL)
            np.testing.assert_array_equal(
                out, self.model.step_batch(self.before, self.after, self.backbones))

    def test_a_result_without_out_is_one_array(self):
        peak = peak_of(lambda: self.model.step_batch(self.before, self.after, self.backbones))
        self.assertLess(peak, self.backbones.nbytes + SMALL)

    def test_out_may_be_the_backbones_before(self):
        state = self.backbones.copy()
        expected = self.model.step_batch(self.before, self.after, state)
        self.model.step_batch(self.before, self.after, state, state)
        np.testing.assert_array_equal(state, expected)

    def test_out_may_not_be_a_part_of_an_input(self):
        with self.assertRaisesRegex(limber.InputError, "out overlaps previous; expected previous itself"):
            self.model.step_batch(self.before[1:], self.after[1:], self.backbones[:-1],
                                  self.backbones[1:])

    def test_out_may_not_begin_where_commands_do(self):
        memory = np.zeros(self.backbones.size, np.float32)
        commands = memory[:self.before.size].reshape(self.before.shape)
        with self.assertRaisesRegex(limber.InputError, "out overlaps previous_kpa; expected memory of its own"):
            self.model.step_batch(commands, self.after, self.backbones, memory.reshape(self.backbones.shape))

    def test_the_simple_models_out_may_not_be_its_pressures(self):
        memory = np.zeros(self.backbones.size, np.float32)
        pressures = memory[:self.before.size].reshape(self.before.shape)
        with self.assertRaisesRegex(limber.InputError, "out overlaps pressures_kpa; expected memory of its own"):
            limber.NoLoadModel(self.arm).backbone(pressures, memory.reshape(self.backbones.shape))

    def test_out_of_another_kind_is_refused(self):
        for out in (np.empty(self.backbones.shape), np.asfortranarray(self.backbones), [1.0]):
            with self.assertRaisesRegex(limber.InputError, "out: expected a writable C-contiguous"):
                self.model.step_batch(self.before, self.after, self.backbones, out)
        locked = self.backbones.copy()
        locked.flags.writeable = False
        with self.assertRaisesRegex(limber.InputError, "out: expected a writable"):
            self.model.step_batch(self.before, self.after, self.backbones, locked)

    def test_a_batch_is_its_single_queries_to_the_bit(self):
        together = self.model.step_batch(self.before[:99], self.after[:99], self.backbones[:99])
        for k in range(99):
            alone = self.model.step(self.before[k], self.after[k], self.backbones[k])
            np.testing.assert_array_equal(alone, together[k])

    def test_threads_of_a_batch_change_nothing(self):
        alone = self.model.step_batch(self.before, self.after, self.backbones)
        parallel = limber.ParallelForward(2)
        np.testing.assert_array_equal(
            parallel.step_batch(self.model, self.before, self.after, self.backbones), alone)

    def test_a_rollout_is_its_steps(self):
        pressures = self.before[:50]
        rolled = self.model.rollout(pressures, self.backbones[0])
        before = state = self.backbones[0]
        for t in range(1, len(pressures)):
            after = self.model.step(pressures[t - 1], pressures[t], state, before=before)
            before, state = state, after
            np.testing.assert_array_equal(state, rolled[t])

    def test_how_the_arm_moved_before_counts(self):
        self.assertTrue(self.model.reads_velocity)
        before = (0.99 * self.backbones).astype(np.float32)
        moving = self.model.step_batch(self.before, self.after, self.backbones, before=before)
        still = self.model.step_batch(self.before, self.after, self.backbones)
        self.assertGreater(np.abs(moving - still).max(), 1e-5)
        np.testing.assert_array_equal(still, self.model.step_batch(
            self.before, self.after, self.backbones, before=self.backbones))
        alone = self.model.step(self.before[3], self.after[3], self.backbones[3], before=before[3])
        np.testing.assert_array_equal(alone, moving[3])
        np.testing.assert_array_equal(alone, self.model.checked_step(
            self.before[3], self.after[3], self.backbones[3], before=before[3]))
        np.testing.assert_array_equal(moving, limber.ParallelForward(2).step_batch(
            self.model, self.before, self.after, self.backbones, before=before))
        with self.assertRaisesRegex(limber.InputError, "before"):
            self.model.step(self.before[3], self.after[3], self.backbones[3], before=before[3][1:])
        before[5, 2, 1] = np.nan
        with self.assertRaisesRegex(limber.InputError, "before"):
            self.model.step_batch(self.before, self.after, self.backbones, before=before)

    def test_an_empty_batch_is_an_empty_answer(self):
        empty = self.model.step_batch(self.before[:0], self.after[:0], self.backbones[:0])
        self.assertEqual(empty.shape, (0, self.arm.point_count, 3))

    def test_lists_are_understood(self):
        rest = limber.NoLoadModel(self.arm).backbone([0, 0])
        np.testing.assert_array_equal(self.model.no_load.backbone(np.zeros(2)), rest)

    def test_wrong_shapes_name_both(self):
        with self.assertRaisesRegex(limber.InputError,
                                    r"previous_kpa has shape \(4,\); expected \(2,\)"):
            self.model.step(np.zeros(4), np.zeros(2), self.backbones[0])
        with self.assertRaisesRegex(limber.InputError, r"current_kpa has shape \(7, 2\); expected "
                                                       r"\(8, 2\)"):
            self.model.step_batch(self.before[:8], self.after[:7], self.backbones[:8])
        with self.assertRaisesRegex(limber.InputError, "expected one row a query"):
            self.model.step_batch(np.float32(1), self.after, self.backbones)

    def test_what_is_not_finite_is_named(self):
        for bad in (np.nan, np.inf, -np.inf):
            broken = self.backbones.copy()
            broken[17, 3, 1] = bad
            with self.assertRaisesRegex(limber.InputError, r"previous\[17, 3, 1\] = -?(nan|inf)"):
                self.model.step_batch(self.before, self.after, broken)

    def test_no_load_batches_are_single_queries(self):
        model = limber.NoLoadModel(self.arm)
        for k in range(20):
            np.testing.assert_array_equal(model.backbone(self.before[k]), self.backbones[k])

    def test_without_a_network_the_forward_model_is_the_no_load_model(self):
        simple = limber.ForwardModel(self.arm)
        self.assertIsNone(simple.compensation)
        np.testing.assert_allclose(
            simple.step_batch(self.before, self.after, self.backbones),
            limber.NoLoadModel(self.arm).backbone(self.after), atol=1e-5)  # [m]: batches round else


class Views(unittest.TestCase):
    def test_an_episodes_arrays_are_limbers_own_memory(self):
        recording = limber.read_recording(chain().recording)
        episode = recording.episodes[0]
        for name in ("time_s", "pressure_kpa", "setpoint_kpa", "backbone", "motion_index"):
            array = getattr(episode, name)
            self.assertTrue(np.shares_memory(array, getattr(recording.episodes[0], name)), name)
            self.assertEqual(len(array), episode.frame_count)
        self.assertEqual(episode.backbone.dtype, np.float32)
        self.assertEqual(episode.backbone.shape[2], 3)

    def test_views_outlive_their_recording(self):
        def pressures():
            return limber.read_recording(chain().recording).episodes[1].pressure_kpa
        kept = pressures()
        again = pressures().copy()
        np.testing.assert_array_equal(kept, again)

    def test_weights_are_views(self):
        model = limber.read_model(chain().model)
        weight = model.layers[0].weight
        self.assertTrue(np.shares_memory(weight, model.layers[0].weight))
        self.assertEqual(weight.shape[0], 16)

    def test_views_are_read_only(self):
        model = limber.read_model(chain().model)
        for view in (model.layers[0].weight, model.layers[0].bias, model.bounds.min_length_m,
                     limber.read_recording(chain().recording).episodes[0].time_s):
            with self.assertRaisesRegex(ValueError, "read-only"):
                view[:] = 0

    def test_an_episode_holds_what_it_was_given(self):
        frames = 5
        arm = chain().arm
        backbone = np.tile(limber.NoLoadModel(arm).backbone([0, 0]), (frames, 1, 1))
        episode = limber.Episode(np.arange(frames) / 20, np.zeros((frames, 2)),
                                 np.ones((frames, 2)), backbone, np.zeros(frames, int),
                                 tracked=[1, 1, 0, 1, 1])
        self.assertEqual(episode.untracked_count, 1)
        np.testing.assert_array_equal(episode.backbone, backbone)
        np.testing.assert_array_equal(episode.tracked, [True, True, False, True, True])
        recording = limber.make_recording(arm, [episode])
        self.assertEqual(recording.frame_count, frames)
        self.assertFalse(recording.setpoints_only)
        (setpoints,) = limber.with_setpoints_only([episode])
        self.assertTrue(setpoints.setpoints_only)
        np.testing.assert_array_equal(setpoints.pressure_kpa, episode.setpoint_kpa)
        self.assertTrue(limber.make_recording(arm, [setpoints]).setpoints_only)
        with self.assertRaisesRegex(limber.InputError, "expected one kind"):
            limber.make_recording(arm, [episode, setpoints])
        with self.assertRaisesRegex(limber.InputError, "expected 5 frames"):
            limber.Episode(np.arange(frames) / 20, np.zeros((4, 2)), np.ones((frames, 2)),
                           backbone, np.zeros(frames, int))

    def test_arrays_that_no_episode_can_have(self):
        good = {"time_s": [0, 1], "pressure_kpa": np.zeros((2, 2)), "setpoint_kpa": np.zeros((2, 2)),
                "backbone": np.zeros((2, 3, 3)), "motion_index": [0, 0]}
        self.assertEqual(len(limber.Episode(**good, tracked=[True, False])), 2)
        for name, wrong, told in (
                ("pressure_kpa", np.zeros(2), r"pressure_kpa has shape \(2,\); expected \(T, n\)"),
                ("pressure_kpa", np.zeros((2, 2, 2)), r"pressure_kpa has shape \(2, 2, 2\)"),
                ("setpoint_kpa", np.zeros((2, 3)), r"setpoint_kpa has shape \(2, 3\); expected \(2, 2\)"),
                ("motion_index", [0, 2**40], r"motion_index = 1\.\S+; expected 0 to 2147483647"),
                ("tracked", [1, 256], "tracked = 256; expected 0 to 1")):
            with self.subTest(told), self.assertRaisesRegex(limber.InputError, told):
                limber.Episode(**{**good, name: wrong})
        for name, wrong in (("motion_index", [0, np.nan]), ("tracked", [1, 0.5])):
            with self.assertRaisesRegex(limber.InputError, f"{name} = .*; expected"):
                limber.Episode(**{**good, name: wrong})
        with self.assertRaises(TypeError):
            limber.Episode(**{**good, "motion_index": [0, 1j]})
        with self.assertRaisesRegex(limber.InputError, "expected that with setpoints_only"):
            limber.Episode(**{**good, "setpoint_kpa": np.ones((2, 2))}, setpoints_only=True)


if __name__ == "__main__":
    unittest.main()
