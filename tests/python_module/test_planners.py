"""Planners of one's own, tubes, and plans made again while the arm moves."""

import json
import struct
import unittest

import numpy as np

import limber
from chain import TWO_SEGMENT, InFolder, chain, run_execution, run_json

LEVELS = [{"level": 0.9, "factor": 0.8, "runs": 0, "outside": 0, "confidence": 0.9,
           "audit_runs": 0, "audit_outside": 0},
          {"level": 0.95, "factor": 1.0, "runs": 0, "outside": 0, "confidence": 0.9,
           "audit_runs": 0, "audit_outside": 0}]
SCALE_M = 0.004


def with_tube(model, path):
    """The model's file with a tube in its metadata: SCALE_M at the tip, less towards the base."""
    content = model.read_bytes()
    (size,) = struct.unpack_from("<Q", content)
    header = json.loads(content[8:8 + size])
    points = int(header["__metadata__"]["point_count"])
    header["__metadata__"]["tube"] = json.dumps({
        "plate_scale_m": [SCALE_M * (i + 1) / points for i in range(points)],
        "end_scale_m": 0.002, "end_heading_scale_rad": 0.01, "start_share": 1.0, "full_after_m": 0.0, "source": "made up",
        "levels": LEVELS})
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(struct.pack("<Q", len(text)) + text + content[8 + size:])
    return path


class PlansAlong(InFolder):
    def setUp(self):
        super().setUp()
        self.chain = chain()
        self.network = limber.read_model(self.chain.model)
        self.forward = limber.ForwardModel(self.chain.arm, self.network)
        self.model = limber.MotionModel(self.forward)
        self.problem = limber.PlanningProblem(self.chain.arm, self.model, self.chain.environment)

    def test_a_planners_own_motion_is_certified_again(self):
        found = limber.make_planner().plan(self.problem, limber.PlannerLimits(iterations=300), 1)
        self.assertTrue(found.plan, found.reason)
        along = limber.plan_along(self.problem, found.plan.waypoints_kpa[1:], "mine", 3)
        self.assertEqual(along.status, limber.PlanStatus.solved)
        self.assertTrue(along.certificate.certified)
        self.assertEqual((along.plan.planner, along.plan.seed), ("mine", 3))
        np.testing.assert_array_equal(along.plan.backbone, found.plan.backbone)
        limber.write_plan(self.folder / "plan.json", along.plan)
        judged = limber.certify(limber.read_plan(self.folder / "plan.json"), self.chain.arm,
                                self.network, limber.ValveParameters(), self.chain.environment)
        self.assertTrue(judged.certified, judged.failures)

    def test_a_miss_says_by_how_much(self):
        along = limber.plan_along(self.problem, [[0.0, 0.0]], "mine")
        self.assertEqual(along.status, limber.PlanStatus.not_certified)
        self.assertIsNone(along.plan)
        tip = limber.tip_pose(along.best_partial.backbone[-1])
        error = limber.pose_error(self.chain.environment.goal, tip)
        self.assertAlmostEqual(along.best_partial.goal_distance_m, error.position_m, delta=1e-6)
        self.assertIn(f"{100 * error.position_m:.2f} cm", along.reason)

    def test_bad_waypoints_are_named(self):
        for waypoints, words in (([[0.0]], r"\(1, 1\)"), ([[0.0, np.nan]], "finite"),
                                 ([[0.0, 1e4]], "waypoint 0: segment 1"),
                                 (np.zeros((0, 2)), "no waypoints")):
            with self.assertRaisesRegex(limber.InputError, words):
                limber.plan_along(self.problem, waypoints, "mine")

    def test_plans_keep_the_tube_to_the_byte_as_the_program(self):
        calibrated = with_tube(self.chain.model, self.folder / "calibrated.safetensors")
        network = limber.read_model(calibrated)
        forward = limber.ForwardModel(self.chain.arm, network)
        valves = network.valves or limber.ValveParameters()
        model = limber.MotionModel(forward, limber.ValveModel(self.chain.arm, valves))
        room = limber.error_room(forward)
        self.assertEqual(room.tube.level, 0.95)
        self.assertAlmostEqual(room.tube.plate_radius_m[-1], SCALE_M)
        self.assertAlmostEqual(room.margin_m, SCALE_M)
        problem = limber.problem_with_room(self.chain.arm, model, self.chain.environment, room)
        self.assertEqual(problem.tube.plate_radius_m, room.tube.plate_radius_m)
        result = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 5)
        self.assertTrue(result.plan, result.reason)
        self.assertEqual(result.plan.tube.level, 0.95)
        self.assertEqual(result.plan.margin_m, 0.0)
        result.plan.model_hash = limber.content_hash(calibrated)
        limber.write_plan(self.folder / "own.json", result.plan)
        run_json("plan", "--arm", TWO_SEGMENT, "--model", calibrated, "--environment",
                 self.chain.environment_file, "--max-iterations", 300, "--seed", 5, "--out",
                 "program.json", folder=self.folder)
        self.assertEqual((self.folder / "own.json").read_bytes(),
                         (self.folder / "program.json").read_bytes())
        result = limber.plan(self.chain.arm, calibrated, self.chain.environment,
                             limber.PlannerLimits(iterations=300), 5)
        limber.write_plan(self.folder / "own.json", result.plan)
        self.assertEqual((self.folder / "own.json").read_bytes(),
                         (self.folder / "program.json").read_bytes())
        with self.assertRaisesRegex(limber.InputError, "0.9, 0.95"):
            limber.error_room(forward, tube_level=0.5)
        self.assertIsNone(limber.error_room(forward, margin_m=0.01).tube)

    def test_another_level_of_the_tube_is_kept_where_it_is_asked_for(self):
        forward = limber.ForwardModel(self.chain.arm, limber.read_model(
            with_tube(self.chain.model, self.folder / "calibrated.safetensors")))
        tube = limber.error_room(forward, tube_level=0.9).tube
        self.assertAlmostEqual(tube.plate_radius_m[-1], 0.8 * SCALE_M)
        problem = limber.PlanningProblem(self.chain.arm, limber.MotionModel(forward),
                                         self.chain.environment, tube=tube)
        result = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 1)
        self.assertTrue(result.plan, result.reason)
        self.assertEqual(result.plan.tube.level, 0.9)
        self.assertEqual(result.plan.tube.plate_radius_m, tube.plate_radius_m)

    def test_an_adapted_models_arm_is_followed_unless_it_is_not_to_be(self):
        run_json("collect", "--arm", TWO_SEGMENT, "--schedule", "identify", "--seed", 5, "--out", "minute.h5",
                 folder=self.folder)
        run_json("adapt", "--arm", TWO_SEGMENT, "--model", "two_segment", "--recording", "minute.h5",
                 "--out", "mine.safetensors", folder=self.folder)
        forward = limber.ForwardModel(self.chain.arm, limber.read_model(self.folder / "mine.safetensors"))
        model = limber.MotionModel(forward)
        problem = limber.PlanningProblem(self.chain.arm, model, self.chain.environment)
        plan = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=300), 1).plan
        for adapts in (True, False):
            run = limber.execute(
                self.chain.arm, self.chain.environment, plan, limber.VirtualArm(self.chain.arm),
                controller=limber.ClosedLoop(self.chain.arm, model, self.chain.environment, adapts=adapts))
            if adapts:
                self.assertEqual((run.arm.dtype, run.arm.ndim), (np.float32, 1))
                self.assertGreater(run.largest_window_error_m, 0)
                self.assertGreaterEqual(run.largest_window_error_m, run.last_window_error_m)
            else:
                self.assertIsNone(run.arm)

    def test_plans_made_again_end_nearer_to_the_goal_as_the_programs(self):
        plan = limber.make_planner().plan(
            self.problem, limber.PlannerLimits(iterations=300), 1).plan
        plan.model_hash = limber.content_hash(self.chain.model)
        limber.write_plan(self.folder / "plan.json", plan)
        run = [limber.execute(
            self.chain.arm, self.chain.environment, plan, limber.VirtualArm(self.chain.arm),
            controller=limber.ClosedLoop(self.chain.arm, self.model, self.chain.environment))
            for _ in range(2)]
        self.assertEqual(run[0].replans, run[1].replans)
        np.testing.assert_array_equal(run[0].episode.backbone, run[1].episode.backbone)
        open_loop = limber.execute(self.chain.arm, self.chain.environment, plan,
                                   limber.VirtualArm(self.chain.arm))
        self.assertEqual(open_loop.replans, 0)
        self.assertIsNone(open_loop.open_loop_goal_error)
        self.assertLess(run[0].goal_error.position_m, open_loop.goal_error.position_m)
        theirs = run_execution(
            "--arm", TWO_SEGMENT, "--environment", self.chain.environment_file,
            "--plan", "plan.json", "--model", self.chain.model, "--no-valves", "--replan",
            "--motion-queries", 2000, folder=self.folder)
        self.assertEqual(theirs["replans"], run[0].replans)
        self.assertAlmostEqual(theirs["distance_to_goal_cm"], 100.0 * run[0].goal_error.position_m,
                               places=4)

    def test_a_controller_of_ones_own_is_asked_and_its_wrong_answers_are_named(self):
        arm, environment = self.chain.arm, self.chain.environment
        plan = limber.make_planner().plan(
            self.problem, limber.PlannerLimits(iterations=300), 1).plan

        class Mine(limber.Controller):
            """Answers from a list."""

            def __init__(self, answers, model=None):
                self.answers, self.model, self.seen = iter(answers), model, []

            def step(self, arm):
                self.seen.append(arm)
                self.model = None  # the run keeps what it began with
                return next(self.answers)

        def run(controller):
            return limber.execute(arm, environment, plan, limber.VirtualArm(arm),
                                  controller=controller)

        still = np.zeros(arm.segment_count, np.float32)
        mine = Mine([still, still, None],
                    limber.MotionModel(limber.ForwardModel(arm, limber.read_model(self.chain.model))))
        self.assertEqual(run(mine).frames, 2)
        self.assertEqual([one.frames for one in mine.seen], [0, 1, 2])
        self.assertEqual(mine.seen[-1].state.backbone.shape, mine.seen[-1].measured.backbone.shape)
        for controller, error, words in (
                (Mine(["left"]), TypeError, "Mine.step returned str; expected set points or None"),
                (Mine([still[:1]]), limber.InputError, "the controller's set points"),
                (Mine([still + 1e6]), limber.InputError, "expected ±"),
                (Mine([], model=3), TypeError, "Mine.model is int; expected a MotionModel or None"),
                (object(), TypeError, r"object has no method step\(arm\)")):
            with self.subTest(words), self.assertRaisesRegex(error, words):
                run(controller)
        loop = limber.ClosedLoop(arm, self.model, environment)
        run(loop)
        with self.assertRaisesRegex(limber.InputError, "runs once"):
            run(loop)
        elsewhere = limber.Environment("elsewhere", [], environment.goal)
        with self.assertRaisesRegex(
                limber.InputError, "a ClosedLoop for environment 'elsewhere' .* the run's is 'a wall'"):
            run(limber.ClosedLoop(arm, self.model, elsewhere))

    def test_of_an_arm_that_is_lost_nothing_is_known(self):
        class LostArm(limber.ArmDriver):
            """Nothing tracks it after half a second."""

            def __init__(self, arm):
                super().__init__()
                self.arm = limber.VirtualArm(arm)

            def state(self):
                state = self.arm.state()
                lost = state.time_s > 0.5
                return limber.ArmState(time_s=state.time_s, pressure_kpa=state.pressure_kpa,
                                       backbone=None if lost else state.backbone)

            def command(self, setpoint_kpa):
                self.arm.command(setpoint_kpa)
                return self.state()

            def vent(self):
                self.arm.vent()

        plan = limber.make_planner().plan(
            self.problem, limber.PlannerLimits(iterations=300), 1).plan
        seen = limber.execute(self.chain.arm, self.chain.environment, plan,
                              limber.VirtualArm(self.chain.arm))
        self.assertEqual((type(seen.goal_reached), type(seen.collided)), (bool, bool))
        self.assertEqual(seen.frames_not_seen, 0)
        lost = limber.execute(self.chain.arm, self.chain.environment, plan, LostArm(self.chain.arm))
        self.assertEqual(lost.status, limber.ExecutionStatus.done)
        for known in ("goal_reached", "collided", "goal_error", "final_backbone", "closest"):
            self.assertIsNone(getattr(lost, known), known)
        self.assertEqual(lost.frames_not_seen, lost.frames - 10)
        self.assertIn("not seen at the end", lost.message)


if __name__ == "__main__":
    unittest.main()
