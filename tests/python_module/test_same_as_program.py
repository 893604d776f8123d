"""The same seed gives the program's bits: what the module makes is compared with what `limber`
made."""

import contextlib
import json
import unittest

import numpy as np

import limber
from chain import ROOT, TWO_SEGMENT, InFolder, chain, run_execution, run_json, run_program

HELD_BACK = 0.1  # as `limber train` holds back
SEED = 5
QUERIES = 50_000  # of each search


class SameAsProgram(InFolder):
    def setUp(self):
        super().setUp()
        self.chain = chain()
        self.network = limber.read_model(self.chain.model)
        self.forward = limber.ForwardModel(self.chain.arm, self.network)

    def assert_same_recording(self, one, other):
        self.assertEqual(len(one.episodes), len(other.episodes))
        for a, b in zip(one.episodes, other.episodes):
            for name in ("time_s", "pressure_kpa", "setpoint_kpa", "backbone", "motion_index",
                         "tracked"):
                np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)

    def test_collected_recordings_are_the_programs(self):
        schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=6, episodes=3,
                                           hold_s=1.0)
        options = limber.VirtualArmOptions(seed=4)
        limber.collect(self.chain.arm, limber.virtual_collection(self.chain.arm, schedule, options),
                       limber.virtual_arm_factory(self.chain.arm, options),
                       self.folder / "own.h5")
        own = limber.read_recording(self.folder / "own.h5")
        program = limber.read_recording(self.chain.recording)
        self.assert_same_recording(own, program)
        self.assertEqual((own.settings, own.seed), (program.settings, program.seed))

    def test_trained_models_are_the_programs_to_the_byte(self):
        recording = limber.read_recording(self.chain.recording)
        settings = limber.best_preset()
        limber.set_epoch_count(settings, 180)
        settings.hidden_units = [16, 16]
        settings.seed = 4
        data = limber.hold_back_validation(recording.episodes, HELD_BACK, settings.seed)
        limber.hold_back_unseen(data, HELD_BACK, settings.seed)
        epochs = []
        result = limber.train(self.chain.arm, data, settings,
                              lambda point: epochs.append(point.epoch))
        self.assertEqual(epochs, list(range(1, settings.epoch_count + 1)))
        model = result.model
        model.training = {**model.training,
                          "data": f"train.h5 {limber.content_hash(self.chain.recording)}",
                          # The program names windows and episodes too; they show in the bytes.
                          **{key: limber.read_model(self.chain.model).training[key]
                             for key in ("validation", "windows")}}
        model.set_valves(
            limber.identify_valves(recording.episodes, self.chain.arm, "train.h5"))
        model.learnt = limber.learnt_region_of(data)
        limber.note_unseen(self.chain.arm, model, data.unseen)
        limber.write_model(self.folder / "own.safetensors", model)
        self.assertEqual((self.folder / "own.safetensors").read_bytes(),
                         self.chain.model.read_bytes())

    def test_evaluations_are_the_programs(self):
        theirs = run_json("evaluate", "--arm", TWO_SEGMENT, "--model", self.chain.model, "--data",
                          self.chain.recording, folder=self.folder)
        recording = limber.read_recording(self.chain.recording)
        evaluation = limber.evaluate(limber.ForwardModel(self.chain.arm), self.forward,
                                     recording.episodes)
        within = evaluation.novel.pressures_within
        self.assertGreater(within.frames, 0)
        self.assertLessEqual(within.novel, 0.05 * within.frames)  # it has seen them all
        own = limber.to_json(evaluation)
        # The program measures these beside its other yardsticks, in single precision.
        for name, horizons in own.pop("baselines").items():
            for horizon, errors in horizons.items():
                for error, statistics in errors.items():
                    for statistic, value in statistics.items():
                        other = theirs["baselines"][name][horizon][error][statistic]
                        if value is not None:
                            self.assertAlmostEqual(value, other, delta=1e-5 * max(1.0, abs(value)))
        self.assertEqual({key: theirs[key] for key in own}, own)

    def test_what_is_not_there_is_refused_in_words(self):
        with self.assertRaisesRegex(limber.InputError, "no logs; expected at least one"):
            limber.import_csv([], self.chain.arm)
        with self.assertRaisesRegex(limber.InputError, "no logs; expected at least one"):
            limber.import_motive([], self.chain.arm)
        with self.assertRaisesRegex(limber.InputError, "there is no plan"):
            limber.certify(None, self.chain.arm, self.network, limber.ValveParameters(),
                           self.chain.environment)

    def program_plans(self, *arguments, code=0):
        return run_json("plan", "--arm", TWO_SEGMENT, "--model", self.chain.model, "--environment",
                        self.chain.environment_file, "--max-queries", QUERIES, "--seed", SEED,
                        "--out", "program.json", *arguments, folder=self.folder, code=code)

    def plan(self, model, **settings):
        return limber.plan(self.chain.arm, model, self.chain.environment,
                           limber.PlannerLimits(queries=QUERIES), SEED, **settings)

    def assert_same_plan(self, result, name="program.json"):
        self.assertEqual(result.status, limber.PlanStatus.solved, result.reason)
        limber.write_plan(self.folder / "own.json", result.plan)
        self.assertEqual((self.folder / "own.json").read_text(encoding="utf-8"),
                         (self.folder / name).read_text(encoding="utf-8"))

    def test_plans_are_the_programs_to_the_byte(self):
        theirs = self.program_plans()
        result = self.plan(self.chain.model)
        self.assert_same_plan(result)
        # The model's own, or a share of it where that leaves no way.
        self.assertLessEqual(result.plan.margin_m, self.network.prediction_error.off_path_m)
        self.assertGreater(result.plan.margin_m, 0.0)
        own = limber.to_json(result, self.chain.environment.goal, "default", "network", SEED)
        for key in ("status", "cost_kpa", "queries", "nodes", "frames", "distance_to_goal_cm"):
            self.assertEqual(own[key], theirs[key], key)
        self.assertIn("no valve model", own["warnings"][0])  # the program says so before it plans
        self.assertEqual(own["warnings"][1:], theirs["warnings"])

    def test_a_model_in_memory_gives_the_plan_of_its_file_without_the_files_hash(self):
        self.program_plans()
        result = self.plan(self.network)
        self.assertEqual(result.plan.model_hash, "")
        result.plan.model_hash = limber.content_hash(self.chain.model)
        self.assert_same_plan(result)

    def test_arguments_are_the_programs_flags(self):
        for flags, settings in (
                (("--margin-m", 0.002, "--goal-margin-m", 0), {"margin_m": 0.002, "goal_margin_m": 0}),
                (("--limit", "-60,70"), {"limits_kpa": [(-60, 70)] * 2}),
                (("--planner", "default,improved_plans=0"), {"planner": "default,improved_plans=0"})):
            with self.subTest(flags=flags):
                self.program_plans(*flags, "--force")
                self.assert_same_plan(self.plan(self.chain.model, **settings))
        theirs = self.program_plans("--stay-recorded", "--force", code=1)  # a recording of minutes: no plan
        self.assertEqual(self.plan(self.chain.model, stay_recorded=True).reason, theirs["reason"])

    def test_without_a_network_it_is_the_no_load_models_plan(self):
        theirs = run_json("plan", "--arm", TWO_SEGMENT, "--no-load", "--environment",
                          self.chain.environment_file, "--max-queries", QUERIES, "--seed", SEED,
                          "--out", "no_load.json", folder=self.folder)
        result = self.plan(limber.MotionModel(limber.ForwardModel(self.chain.arm)))
        self.assert_same_plan(result, "no_load.json")
        self.assertIn("the no-load model's error is not known", result.warnings[0])
        self.assertEqual(result.warnings, theirs["warnings"])

    def test_no_plan_says_so(self):
        far = limber.Environment("far", [], limber.PoseGoal(x_m=3.0))
        result = limber.plan(self.chain.arm, self.chain.model, far, limber.PlannerLimits(time_s=1))
        self.assertEqual(result.status, limber.PlanStatus.goal_unreachable)
        self.assertIsNone(result.plan)
        self.assertIn("beyond the arm's reach", result.reason)
        stopped = self.plan(self.chain.model, callback=lambda _: False)
        self.assertNotEqual(stopped.reason, "")
        for model in (None, self.forward, 3):
            with self.assertRaises(TypeError):
                self.plan(model)
        with self.assertRaisesRegex(limber.InputError, "no.safetensors"):
            self.plan("no.safetensors")

    def test_certificates_and_executions_are_the_programs(self):
        self.program_plans()
        plan = limber.read_plan(self.folder / "program.json")
        theirs = run_json("verify", "--arm", TWO_SEGMENT, "--model", self.chain.model,
                          "--environment", self.chain.environment_file, "--plan", "program.json",
                          folder=self.folder)
        certificate = limber.certify(plan, self.chain.arm, self.network,
                                     self.network.valves or limber.ValveParameters(),
                                     self.chain.environment)
        own = limber.to_json(certificate, self.chain.environment)
        self.assertEqual({key: theirs[key] for key in own}, own)

        theirs = run_execution("--arm", TWO_SEGMENT, "--environment", self.chain.environment_file,
                               "--plan", "program.json", "--out", "run.h5", folder=self.folder)
        result = limber.execute(self.chain.arm, self.chain.environment, plan,
                                limber.VirtualArm(self.chain.arm))
        own = limber.to_json(result, self.chain.environment)
        self.assertEqual(theirs, own)
        run = limber.read_recording(self.folder / "run.h5").episodes[0]
        np.testing.assert_array_equal(run.backbone, result.episode.backbone)

    def test_errors_have_the_programs_text(self):
        bad = self.folder / "bad.yaml"
        bad.write_text(TWO_SEGMENT.read_text(encoding="utf-8").replace("length_m: ", "length_m: -"),
                       encoding="utf-8")
        message = run_program("inspect", bad, folder=self.folder, code=2).stderr
        with self.assertRaises(limber.InputError) as refused:
            limber.load_arm(bad)
        self.assertIsInstance(refused.exception, ValueError)
        self.assertIn(str(refused.exception), message)

    def broken_files(self):
        """Files of every kind that are not right; the folder's names stand in the messages."""
        environment = (ROOT / "environments" / "01_pillar.yaml").read_text(encoding="utf-8")
        for name, text in [("wall.yaml", environment.replace("radius_m: ", "radius_m: -")),
                           ("model.safetensors", "abc"), ("plan.json", "{}"),
                           ("other.json", '{"schema": "limber/plan/99"}'),
                           ("bench.csv", "pressure_kpa,strain\n10,a\n")]:
            (self.folder / name).write_text(text, encoding="utf-8")
        limber.write_recording(self.folder / "two.h5", limber.read_recording(self.chain.recording))

    def test_errors_have_the_programs_text_whatever_is_wrong(self):
        self.broken_files()
        three = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        recording = limber.read_recording(self.chain.recording)
        model = ("--model", self.chain.model)
        with contextlib.chdir(self.folder):
            for arguments, function in [
                    (("evaluate", "--model", "none.safetensors", "--data", "two.h5"),
                     lambda: limber.read_model("none.safetensors")),
                    (("evaluate", "--model", "model.safetensors", "--data", "two.h5"),
                     lambda: limber.read_model("model.safetensors")),
                    (("verify", "--plan", "plan.json", "--environment", "01_pillar"),
                     lambda: limber.read_plan_unchecked("plan.json")),
                    (("execute", "--plan", "other.json", "--environment", "01_pillar"),
                     lambda: limber.read_plan("other.json")),
                    (("plan", "--arm", TWO_SEGMENT, "--no-load", "--environment", "wall.yaml"),
                     lambda: limber.load_environment("wall.yaml")),
                    (("plan", "--arm", TWO_SEGMENT, *model, "--environment",
                      self.chain.environment_file, "--planner", "quick"),
                     lambda: limber.make_planner("quick")),
                    (("train", "--arm", "three_segment", "--data", "two.h5", "--out", "x"),
                     lambda: limber.require_recording_of(recording, three, "two.h5")),
                    (("plan", "--arm", "three_segment", "--environment", "01_pillar", *model),
                     lambda: limber.require_model_of(self.network, three, str(self.chain.model)))]:
                message = run_program(*arguments, folder=self.folder, code=2).stderr
                with self.assertRaises(limber.InputError) as refused:
                    function()
                self.assertIn("error: " + str(refused.exception), message)

    def test_errors_that_differ(self):
        """docs/python.md lists them: the program looks for names among its own arms."""
        with self.assertRaisesRegex(limber.InputError, "^x.yaml: can't be read"):
            limber.load_arm("x.yaml")
        self.assertIn("error: --arm x.yaml: no such file, and none of limber's own arms",
                      run_program("inspect", "--arm", "x.yaml", self.chain.recording,
                                  folder=self.folder, code=2).stderr)
        with self.assertRaisesRegex(limber.InputError, "^--preset quick: expected paper or best"):
            limber.training_preset("quick")  # a flag's name stands for the argument

    def test_imported_logs_are_the_recording(self):
        recording = limber.read_recording(self.chain.recording)
        *logs, mapping = limber.export_csv(recording, self.folder / "logs")
        imported = limber.import_csv(logs, self.chain.arm, mapping)
        self.assertEqual(imported.recording.frame_count, recording.frame_count)
        self.assertIn("frames", imported.report)
        np.testing.assert_allclose(imported.recording.episodes[0].backbone,
                                   recording.episodes[0].backbone, atol=1e-5)  # [m]: decimals

    def test_environments_made_here_are_those_of_files(self):
        again = limber.load_environment(self.chain.environment_file, self.chain.arm)
        self.assertEqual(limber.environment_hash(again),
                         limber.environment_hash(self.chain.environment))
        with self.assertRaisesRegex(limber.InputError, "radius_m"):
            limber.Environment("x", [limber.Circle(radius_m=-1.0)], limber.PoseGoal(x_m=0.3))


class Kinematics(unittest.TestCase):
    def test_solutions_reach_the_goal_by_the_no_load_model(self):
        arm = limber.load_arm(TWO_SEGMENT)
        model = limber.NoLoadModel(arm)
        tip = limber.tip_pose(model.backbone([20.0, -35.0]))
        goal = limber.PoseGoal(x_m=tip.x_m, y_m=tip.y_m, position_tolerance_m=0.001)
        found = limber.solve_inverse_kinematics(model, goal, limber.InverseKinematicsSettings(),
                                                limber.RandomStream(1))
        self.assertTrue(found.reachable)
        for pressures in found.pressures_kpa:
            error = limber.pose_error(goal, limber.tip_pose(model.backbone(pressures)))
            self.assertLess(error.position_m, 0.001)
        far = limber.solve_inverse_kinematics(model, limber.PoseGoal(x_m=5.0, y_m=5.0),
                                              limber.InverseKinematicsSettings(),
                                              limber.RandomStream(1))
        self.assertFalse(far.reachable)
        self.assertTrue(far.reason)

    def test_curvature_and_pressure_are_inverse(self):
        model = limber.NoLoadModel(limber.load_arm(TWO_SEGMENT))
        for pressure in (-60.0, -5.0, 3.0, 70.0):
            shape = model.segment_shape(0, pressure)
            back = model.pressure_for_curvature(0, shape.curvature_per_m)
            self.assertAlmostEqual(back.pressure_kpa, pressure, places=6)
        with self.assertRaises(IndexError):
            model.segment_shape(2, 0.0)

    def test_valves_follow_a_first_order_lag(self):
        arm = limber.load_arm(TWO_SEGMENT)
        lag = limber.SegmentValves(
            inflating=limber.ValveDirection(time_constant_s=0.2, rate_limit_kpa_per_s=np.inf),
            venting=limber.ValveDirection(time_constant_s=0.2, rate_limit_kpa_per_s=np.inf))
        valves = limber.ValveModel(arm, limber.ValveParameters(segments=[lag, lag]))
        setpoints = np.full((41, 2), 30.0)
        pressures = valves.run(setpoints, [0.0, 0.0])
        expected = 30.0 * (1.0 - np.exp(-np.arange(41) / arm.frame_rate_hz / 0.2))
        np.testing.assert_allclose(pressures[:, 0], expected, atol=1e-6)  # [kPa]

    def test_clearance_of_a_circle_is_the_distance(self):
        arm = limber.load_arm(TWO_SEGMENT)
        obstacle = limber.Circle(x_m=0.2, y_m=0.5, radius_m=0.1)
        environment = limber.Environment("c", [obstacle], limber.PoseGoal(x_m=0.3))
        checker = limber.CollisionChecker(arm, environment)
        rest = limber.NoLoadModel(arm).backbone([0, 0])
        radius = arm.segments[0].width_m / 2 + arm.actuator_radius_m
        found = checker.clearance(rest)
        self.assertAlmostEqual(found.value_m, 0.5 - 0.1 - radius, delta=0.001)  # its tolerance
        self.assertEqual(found.obstacle, 0)
        self.assertTrue(checker.is_free(rest))


class Json(unittest.TestCase):
    def test_to_json_gives_what_json_writes(self):
        valves = limber.read_model(chain().model)
        json.dumps(limber.to_json(limber.identify_valves(
            limber.read_recording(chain().recording).episodes, chain().arm)))
        self.assertIsNotNone(valves.prediction_error)
        self.assertEqual(limber.to_json(valves.prediction_error)["runs"],
                         valves.prediction_error.runs)


if __name__ == "__main__":
    unittest.main()
