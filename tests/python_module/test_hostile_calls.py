"""Wrong arguments of every kind to everything public: an exception, never a crash, a hang, or numbers
from garbage."""

import copy
import subprocess
import sys
import unittest

import numpy as np

import limber
from chain import ROOT, InFolder, chain
from hostile_calls import Arguments, finer_arm, with_values

SEED = 38
CALLS = 500


class HostileCalls(InFolder):
    def test_drawn_calls_are_refused_or_answered(self):
        result = subprocess.run(
            [sys.executable, "-X", "faulthandler",
             str(ROOT / "tests" / "python_module" / "hostile_calls.py"), "--seed", str(SEED),
             "--calls", str(CALLS)],
            cwd=self.folder, capture_output=True, encoding="utf-8", errors="replace", check=False)
        self.assertEqual(result.returncode, 0, result.stdout[-3000:] + result.stderr[-3000:])


class ReachingPastTheEnd(InFolder):
    """What once read memory that was not there."""

    def test_a_part_of_a_model_outlives_it(self):
        model = limber.read_model(chain().model)
        model.valves = limber.ValveParameters(has_sides=True)
        valves, bounds = model.valves, model.bounds
        lengths = np.array(bounds.min_length_m)
        model.valves = model.bounds = model.learnt = None
        junk = [np.full_like(lengths, 7.0) for _ in range(1000)]
        self.assertTrue(valves.has_sides)
        np.testing.assert_array_equal(bounds.min_length_m, lengths)
        self.assertEqual(len(junk), 1000)

    def test_numbers_out_of_range(self):
        arm = chain().arm
        for wrong in (lambda: arm.segment_of_gap(100), lambda: arm.segment_of_gap(-1),
                      lambda: arm.frames_in(float("nan")), lambda: arm.frames_in(1e300),
                      lambda: limber.VirtualArm(arm).settle(np.zeros(2), float("inf")),
                      lambda: limber.ArmState(float("nan"), np.zeros(2)),
                      lambda: limber.RecordedRegion(limber.read_model(chain().model).learnt, float("nan")),
                      lambda: limber.learnt_region_of(limber.TrainingData([], []))):
            with self.assertRaises(limber.InputError):
                wrong()

    def test_arms_of_less_than_two_plates(self):
        for plates in (0, 1):
            with self.assertRaisesRegex(limber.InputError, rf"backbone has shape \(2, {plates}, 3\); .* m from 2"):
                limber.Episode([0, 1], np.zeros((2, 2)), np.zeros((2, 2)), np.zeros((2, plates, 3)), [0, 0])
        empty = limber.Episode([], np.zeros((0, 2)), np.zeros((0, 2)), np.zeros((0, 1, 3)), [])
        for function in (lambda: limber.gap_bounds_of([empty]),
                         lambda: limber.learnt_region_of(limber.TrainingData([empty]))):
            with self.assertRaises(limber.InputError):
                function()

    def test_a_fit_of_another_arm(self):
        episodes = limber.read_recording(chain().recording).episodes
        fit = limber.fit_simple_model(chain().arm, episodes)
        other = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        for function in (lambda: fit.describe(other), lambda: limber.fitted_arm(other, fit, episodes)):
            with self.assertRaisesRegex(limber.InputError, "a fit of 2 segments; arm 'three_segment' has 3"):
                function()

    def test_a_region_of_another_arm(self):
        region = limber.RecordedRegion(limber.read_model(chain().model).learnt, 20.0)
        other = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        model = limber.MotionModel(limber.ForwardModel(other))
        environment = limber.load_environment(ROOT / "environments" / "01_pillar.yaml")
        with self.assertRaisesRegex(limber.InputError, "stay_within: of 2 segments"):
            limber.PlanningProblem(other, model, environment, stay_within=region)

    def test_a_model_of_another_arm(self):
        arm, environment = chain().arm, chain().environment
        own = limber.MotionModel(limber.ForwardModel(arm))
        plan = limber.make_planner().plan(limber.PlanningProblem(arm, own, environment),
                                          limber.PlannerLimits(iterations=300), 5).plan
        finer = finer_arm(self.folder)
        other = limber.MotionModel(limber.ForwardModel(finer))

        class Own(limber.Controller):
            model = other

            def step(self, arm):
                return None
        for function in (lambda: limber.PlanningProblem(arm, other, environment),
                         lambda: limber.problem_with_room(arm, other, environment,
                                                          limber.error_room(other.forward)),
                         lambda: limber.plan(arm, other, environment),
                         lambda: limber.ClosedLoop(arm, other, environment),
                         lambda: limber.execute(arm, environment, plan, limber.VirtualArm(arm),
                                                controller=Own())):
            with self.assertRaisesRegex(limber.InputError, "arm 'finer', with 2 .* of 9, 9 gaps; "
                                                           "arm 'two_segment' has 2 and 5, 5"):
                function()
        three = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        with self.assertRaisesRegex(limber.InputError, "valves of 3 .* arm 'two_segment' has 2"):
            limber.MotionModel(limber.ForwardModel(arm), limber.ValveModel(three))

    def test_a_state_without_its_past(self):
        arm = chain().arm
        network = limber.MotionModel(limber.ForwardModel(arm, limber.read_model(chain().model)))
        if not limber.read_model(chain().model).reads_velocity:
            self.skipTest("the chain's network reads no velocity")
        state = limber.MotionModel(limber.ForwardModel(arm)).settled_state(
            np.zeros(2), limber.start_state(chain().environment, arm).backbone)
        with self.assertRaises(limber.InputError):
            network.step(np.zeros(2, np.float32), state)

    def test_a_run_and_a_plan_of_something_else(self):
        arm, environment = chain().arm, chain().environment
        problem = limber.PlanningProblem(arm, limber.MotionModel(limber.ForwardModel(arm)), environment)
        plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5).plan
        run = limber.execute(arm, environment, plan, limber.VirtualArm(arm))
        self.assertIsNotNone(run.closest)
        empty = limber.Environment("empty", [], environment.goal)
        with self.assertRaisesRegex(limber.InputError, "of 0 obstacles; the run tells of obstacle 0"):
            limber.to_json(run, empty)
        other = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        with self.assertRaisesRegex(limber.InputError, "plan: arm_hash: made for arm 'two_segment'"):
            limber.pressure_picture(other, plan)

    def test_a_driver_whose_states_are_of_no_arm(self):
        arm, environment = chain().arm, chain().environment
        problem = limber.PlanningProblem(arm, limber.MotionModel(limber.ForwardModel(arm)), environment)
        plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5).plan

        class Driver:
            def state(self):
                return limber.ArmState(0.0, np.zeros(2), np.zeros((0, 3)))

            def command(self, setpoint_kpa):
                return self.state()

            def vent(self):
                pass

        result = limber.execute(arm, environment, plan, Driver())
        self.assertEqual(result.status, limber.ExecutionStatus.fault)
        self.assertIn("0 backbone points", result.message)


class WrongEpisodes(InFolder):
    """Each kind, to each function that takes an arm or a model and episodes."""

    def setUp(self):
        super().setUp()
        self.given = Arguments(self.folder, None)

    def test_every_function_refuses_every_kind(self):
        good = self.given.good
        arm, forward, no_load = good["arm"], good["network"], good["no_load"]
        settings = limber.best_preset()
        settings.hidden_units = [4]
        limber.set_epoch_count(settings, 40)
        fit = good["fit"]

        def data(episodes):
            return limber.TrainingData(episodes, episodes)
        functions = {
            "episode_errors": lambda e: limber.episode_errors(arm, e),
            "fit_simple_model": lambda e: limber.fit_simple_model(arm, e),
            "fitted_arm": lambda e: limber.fitted_arm(arm, fit, e),
            "train": lambda e: limber.train(arm, data(e), settings),
            "fine_tune": lambda e: limber.fine_tune(arm, data(e), settings, good["start"]),
            "evaluate": lambda e: limber.evaluate(no_load, forward, e),
            "evaluate without network": lambda e: limber.evaluate(no_load, None, e),
            "predict": lambda e: [limber.predict(forward, one, limber.Restart.every_frame)
                                  for one in e],
            "note_unseen": lambda e: limber.note_unseen(arm, good["start"], e)}
        for kind, episodes in self.given.wrong_episodes.items():
            for name, function in functions.items():
                with self.subTest(kind=kind, function=name):
                    with self.assertRaises(limber.InputError):
                        function(episodes)

    def test_models_in_each_others_place_are_refused(self):
        good = self.given.good
        with self.assertRaisesRegex(limber.InputError, "a no-load model and a network, in this"):
            limber.evaluate(good["network"], good["no_load"], good["episodes"])
        with self.assertRaisesRegex(limber.InputError, "in this order"):
            limber.evaluate(good["no_load"], good["no_load"], good["episodes"])
        with self.assertRaisesRegex(limber.InputError, "segments"):
            limber.evaluate(limber.ForwardModel(self.given.other_arm), good["network"],
                            good["episodes"])

    def test_a_model_without_layers_is_refused(self):
        good = self.given.good
        settings = limber.best_preset()
        settings.hidden_units = [4]
        settings.validation_interval = 1000
        stopped = limber.train(good["arm"], good["data"], settings, lambda _: False).model
        self.assertEqual(len(stopped.layers), 0)
        for function in (lambda: limber.ForwardModel(good["arm"], stopped),
                         lambda: limber.note_unseen(good["arm"], stopped, good["episodes"]),
                         lambda: limber.fine_tune(good["arm"], good["data"], settings, stopped),
                         lambda: limber.write_model(self.folder / "m.safetensors", stopped)):
            with self.assertRaises(limber.InputError):
                function()

    def test_episodes_of_several_sizes_are_refused_without_an_arm_too(self):
        mixed = self.given.wrong_episodes["one of another arm"]
        with self.assertRaisesRegex(limber.InputError, "episodes/000003"):
            limber.gap_bounds_of(mixed)
        with self.assertRaisesRegex(limber.InputError, "episodes/000003"):
            limber.learnt_region_of(limber.TrainingData(mixed))


class WrongNumbers(InFolder):
    def setUp(self):
        super().setUp()
        self.episodes = limber.read_recording(chain().recording).episodes

    def test_shares_threads_and_times(self):
        for share in (0.0, 1.0, 2.0, -1.0, float("nan")):
            with self.assertRaisesRegex(limber.InputError, "held back"):
                limber.hold_back_validation(self.episodes, share, 1)
        with self.assertRaisesRegex(limber.InputError, "held back"):
            limber.hold_back_validation([], 0.1, 1)
        data = limber.hold_back_validation(self.episodes, 0.1, 1)
        with self.assertRaisesRegex(limber.InputError, "held back"):
            limber.hold_back_unseen(data, 2.0, 1)
        forward = limber.ForwardModel(chain().arm)
        for function in (lambda: limber.evaluate(forward, None, self.episodes, jobs=-1),
                         lambda: limber.make_planner("default", jobs=-1),
                         lambda: limber.ParallelForward(-1),
                         lambda: limber.train(chain().arm, data,
                                              limber.TrainingSettings(jobs=-1, stages=limber.best_preset().stages))):
            with self.assertRaisesRegex(limber.InputError, "jobs"):
                function()
        with self.assertRaisesRegex(limber.InputError, "expected times to increase"):
            with_values(self.episodes[0], time_s=self.episodes[0].time_s[::-1])

    def test_more_threads_than_there_are(self):
        data = limber.hold_back_validation(self.episodes, 0.1, 1)
        settings = limber.best_preset()
        settings.jobs = 100000
        for function in (lambda: limber.ParallelForward(2**31 - 1),
                         lambda: limber.train(chain().arm, data, settings)):
            with self.assertRaisesRegex(limber.InputError, r"jobs = \d+; expected .* 1024"):
                function()

    def test_texts_with_zero_bytes(self):
        for episodes, source in ((self.episodes, "a\0b"), ([with_values(self.episodes[0], log="a\0b")], "a")):
            with self.assertRaisesRegex(limber.InputError, "zero byte"):
                limber.make_recording(chain().arm, episodes, source=source)

    def test_choices_have_no_other_values(self):
        choices = [one for name in limber.__all__ if hasattr(one := getattr(limber, name), "__members__")]
        self.assertGreater(len(choices), 10)
        for choice in choices:
            for one in choice.__members__.values():
                self.assertEqual(choice(int(one)), one)
            with self.assertRaisesRegex(limber.InputError, rf"{choice.__name__}\(300\): expected \d+ \("):
                choice(300)

    def test_what_is_not_finite_or_out_of_range(self):
        arm = chain().arm
        model, forward = limber.NoLoadModel(arm), limber.ForwardModel(arm)
        settings = limber.virtual_collection(arm, limber.ScheduleSettings())
        settings.hold_limit_s = np.nan
        for wrong in (lambda bad: model.segment_shape(0, bad), lambda bad: model.pressure_for_curvature(0, bad),
                      lambda bad: limber.RandomStream(1).uniform(0, bad),
                      lambda bad: limber.error_room(forward, margin_m=bad),
                      lambda bad: limber.ArmState(0.0, [0, 0], tracker_t=bad)):
            for bad in (np.nan, np.inf):
                with self.assertRaises(limber.InputError):
                    wrong(bad)
        for wrong in (lambda: limber.RandomStream(1).uniform(5, 1), lambda: limber.error_room(forward, margin_m=-1),
                      lambda: limber.collect(arm, settings, limber.virtual_arm_factory(arm), self.folder / "a.h5"),
                      lambda: limber.bench_test_all(arm, 10**9),
                      lambda: limber.solve_inverse_kinematics(
                          model, limber.PoseGoal(x_m=0.3), limber.InverseKinematicsSettings(starts=10**6),
                          limber.RandomStream(1))):
            with self.assertRaises(limber.InputError):
                wrong()

    def test_valves_that_no_file_can_have(self):
        never = limber.ValveParameters(segments=[limber.SegmentValves()])
        with self.assertRaisesRegex(limber.InputError, "rate_limit_kpa_per_s = 0"):
            limber.write_valves(self.folder / "v.yaml", limber.IdentifiedValves(parameters=never))
        self.assertFalse((self.folder / "v.yaml").exists())

    def test_a_field_of_another_type_is_named(self):
        with self.assertRaisesRegex(TypeError, r"PlannerLimits\(iterations=100\.0\): expected Optional\[int\]"):
            limber.PlannerLimits(iterations=100.0)

    def test_nothing_equals_what_is_of_another_kind(self):
        arm = chain().arm
        state = limber.MotionModel(limber.ForwardModel(arm)).settled_state(
            [0, 0], limber.NoLoadModel(arm).backbone([0, 0]))
        for one in (limber.ValveParameters(), state):
            self.assertTrue(one == one and one != None)  # noqa: E711
            self.assertNotIn(one, [1])

    def test_a_goal_in_millimetres(self):
        arm = chain().arm
        environment = limber.Environment("far", [], limber.PoseGoal(x_m=550.0, y_m=0.0))
        result = limber.make_planner().plan(limber.PlanningProblem(
            arm, limber.MotionModel(limber.ForwardModel(arm)), environment),
            limber.PlannerLimits(iterations=10), 1)
        self.assertEqual(result.status, limber.PlanStatus.goal_unreachable)
        self.assertRegex(result.reason, r"goal.x_m = 550 .* Is it in millimetres\?")

    def test_complex_numbers_dates_and_texts(self):
        model = limber.NoLoadModel(chain().arm)
        for wrong in (np.zeros(2, complex), np.zeros(2, "datetime64[s]"), ["1", "2"]):
            with self.assertRaises(TypeError):
                model.backbone(wrong)
        with self.assertRaises(TypeError):
            limber.Polygon(np.zeros((4, 2), complex))

    def test_a_drivers_method_that_returns_something_else_is_named(self):
        class Mine(limber.ArmDriver):
            def __init__(self):
                self.arm = limber.VirtualArm(chain().arm)

            def state(self):
                return self.arm.state()

            def command(self, setpoint_kpa):
                self.arm.command(setpoint_kpa)

            def vent(self):
                self.arm.vent()
        problem = limber.PlanningProblem(
            chain().arm, limber.MotionModel(limber.ForwardModel(chain().arm)),
            chain().environment)
        plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5).plan
        with self.assertRaisesRegex(TypeError, r"Mine.command returned NoneType; expected an ArmS"):
            limber.execute(chain().arm, chain().environment, plan, Mine())


class WrongPaths(InFolder):
    def test_what_is_no_plain_file_is_never_replaced(self):
        link = self.folder / "null"
        link.symlink_to("/dev/null")  # of a device, it would be the whole machine's
        given = chain()
        recording, model = limber.read_recording(given.recording), limber.read_model(given.model)
        for function, value in ((limber.write_arm, given.arm), (limber.write_model, model),
                                (limber.write_recording, recording),
                                (limber.write_environment, given.environment)):
            with self.assertRaisesRegex(limber.InputError, "not a plain file; it is never"):
                function(link, value)
            self.assertTrue(link.is_symlink())


class LostAssignments(unittest.TestCase):
    """What is set in a copy would change nothing, and say nothing."""

    def assert_fixed(self, copies):
        for one, field in copies:
            with self.subTest(field=field):
                before = getattr(one, field)
                with self.assertRaisesRegex(AttributeError, f"{type(one).__name__}.{field}: this"):
                    setattr(one, field, 5.0)
                self.assertEqual(getattr(one, field), before)
                own = copy.copy(one)
                setattr(own, field, 5.0)
                self.assertEqual(getattr(own, field), 5.0)

    def test_an_environments_goal_and_obstacles_do_not_change(self):
        environment = limber.Environment(
            "e", [limber.Circle(x_m=0.3, y_m=0.3, radius_m=0.02), limber.Rectangle(
                x_m=0.3, y_m=-0.3, width_m=0.02, height_m=0.02)], limber.PoseGoal(x_m=0.4))
        before = limber.environment_hash(environment)
        self.assert_fixed([(environment.goal, "x_m"), (environment.obstacles[0], "radius_m"),
                           (environment.obstacles[1], "width_m")])
        self.assertEqual(limber.environment_hash(environment), before)
        again = limber.Environment("e", environment.obstacles, environment.goal)
        self.assertEqual(limber.environment_hash(again), before)

    def test_valves_do_not_change_and_outlive_their_list(self):
        one = limber.SegmentValves(inflating=limber.ValveDirection(rate_limit_kpa_per_s=100.0),
                                   venting=limber.ValveDirection(rate_limit_kpa_per_s=100.0))
        parameters = limber.ValveParameters(segments=[one] * 2)
        model = limber.ValveModel(chain().arm, parameters)
        valves = parameters.segments[0]
        self.assert_fixed([(valves, "dead_time_s"), (valves.inflating, "time_constant_s"),
                           (model.parameters.segments[1], "dead_band_kpa")])
        with self.assertRaises(AttributeError):
            model.parameters.has_sides = False
        network = limber.read_model(chain().model)
        network.valves = parameters
        with self.assertRaises(AttributeError):
            network.valves.has_sides = False
        self.assertEqual(network.valves, parameters)
        parameters.segments = []
        self.assertEqual(valves.venting.rate_limit_kpa_per_s, 100.0)

    def test_what_a_forward_model_and_a_problem_hold_does_not_change(self):
        forward = limber.ForwardModel(chain().arm, limber.read_model(chain().model))
        forward.compensation.bounds = None
        self.assertIsNotNone(forward.compensation.bounds)
        room = limber.error_room(forward)
        problem = limber.PlanningProblem(chain().arm, limber.MotionModel(forward), chain().environment,
                                         goal_margin=room.goal_margin)
        self.assert_fixed([(room.goal_margin, "position_m"), (problem.goal_margin, "orientation_rad")])

    def test_stages_do_not_change_and_outlive_their_list(self):
        settings = limber.best_preset()
        stage = settings.stages[0]
        before = repr(stage)
        with self.assertRaisesRegex(AttributeError, "TrainingStage.epochs: this"):
            stage.epochs = 5
        limber.set_window_frames(settings, list(range(1, 150)))
        self.assertEqual(repr(stage), before)


if __name__ == "__main__":
    unittest.main()
