"""What can't use arms in space yet says so by name, and what can."""

import re
import unittest

import numpy as np

import limber
from chain import chain, space


class Refusals(unittest.TestCase):
    """By name, with what works instead."""

    def test_whatever_takes_an_arm_can_use_it_or_says_so(self):
        arm, plane = space().arm, chain()
        forward, model = limber.ForwardModel(arm, limber.read_model(space().model)), plane.model
        environment, goal = plane.environment, plane.environment.goal
        motion = limber.MotionModel(limber.ForwardModel(plane.arm, limber.read_model(model)))
        planned = limber.plan(plane.arm, limber.MotionModel(limber.ForwardModel(plane.arm)),
                              environment, limber.PlannerLimits(iterations=2000))
        plan, rest = planned.plan, forward.no_load.backbone(np.zeros(6))
        valves = limber.ValveParameters()
        of_arms = {
            "plan": lambda: limber.plan(arm, str(space().model), environment),
            "PlanningProblem": lambda: limber.PlanningProblem(arm, motion, environment),
            "ClosedLoop": lambda: limber.ClosedLoop(arm, motion, environment),
            "execute": lambda: limber.execute(arm, environment, plan, limber.VirtualArm(arm)),
            "Certifier": lambda: limber.Certifier(arm, None, valves, environment),
            "certify": lambda: limber.certify(plan, arm, None, valves, environment),
            "CollisionChecker": lambda: limber.CollisionChecker(arm, environment),
            "start_state": lambda: limber.start_state(environment, arm),
            "load_environment": lambda: limber.load_environment(plane.environment_file, arm),
            "ProcessDriver": lambda: limber.ProcessDriver(arm, "exec:true"),
            "fit_simple_model": lambda: limber.fit_simple_model(arm, space().episodes),
            "characterise": lambda: limber.characterise(arm, [[], []]),
            "read_bench_csv": lambda: limber.read_bench_csv("none.csv", arm),
            "arm_svg": lambda: limber.arm_svg(arm, rest),
            "environment_picture": lambda: limber.environment_picture(arm, environment),
            "plan_picture": lambda: limber.plan_picture(arm, environment, planned),
            "plan_animation": lambda: limber.plan_animation(arm, environment, plan),
            "pressure_picture": lambda: limber.pressure_picture(arm, plan),
            "problem_with_room": lambda: limber.problem_with_room(
                arm, motion, environment, limber.error_room(motion.forward)),
        }
        for name, call in of_arms.items():
            with self.subTest(name), self.assertRaisesRegex(
                    limber.InputError, rf"^limber\.{name}\b.* can't use an arm in space yet, and "
                    "'hanging_3x2' is one. collect, import, .*train, family, adapt, evaluate, export and bench can"):
                call()
        of_models = {
            "limber.MotionModel": lambda: limber.MotionModel(forward),
            "limber.error_room": lambda: limber.error_room(forward),
            "limber.learnt_region_of": lambda: limber.learnt_region_of(
                limber.TrainingData(space().episodes)),
            "limber.solve_inverse_kinematics": lambda: limber.solve_inverse_kinematics(
                forward.no_load, goal, limber.InverseKinematicsSettings(), limber.RandomStream(1)),
            "NoLoadModel.segment_shape": lambda: forward.no_load.segment_shape(0, 1),
        }
        for name, call in of_models.items():
            with self.subTest(name), self.assertRaisesRegex(
                    limber.InputError, rf"^{re.escape(name)} can't use the model of an arm in space "
                    "yet. ForwardModel.step, step_batch and rollout, predict and evaluate can"):
                call()
        self.assertIsNone(arm._repr_svg_())
        with self.assertRaisesRegex(limber.InputError, "a network of base poses"):
            limber.train(arm, limber.TrainingData(space().episodes), limber.paper_preset())


if __name__ == "__main__":
    unittest.main()
