"""Python's threads: models are shared, calls run beside each other, and what takes one caller at a
time says so."""

import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import limber
from chain import chain
from test_arrays import batch


class Threads(unittest.TestCase):
    def setUp(self):
        self.chain = chain()
        self.forward = limber.ForwardModel(self.chain.arm, limber.read_model(self.chain.model))
        self.problem = limber.PlanningProblem(
            self.chain.arm, limber.MotionModel(self.forward), self.chain.environment)

    def planned(self, seed):
        return limber.make_planner("default", jobs=1).plan(
            self.problem, limber.PlannerLimits(queries=20000), seed)

    def test_plans_beside_each_other_are_those_alone(self):
        seeds = [1, 2, 3, 4]
        alone = [self.planned(seed) for seed in seeds]
        with ThreadPoolExecutor(4) as pool:
            together = list(pool.map(self.planned, seeds))
        for one, other in zip(alone, together):
            self.assertEqual(one.statistics.nodes, other.statistics.nodes)
            self.assertEqual(bool(one.plan), bool(other.plan))
            if one.plan:
                np.testing.assert_array_equal(one.plan.setpoint_kpa, other.plan.setpoint_kpa)

    def test_a_model_is_shared(self):
        batches = [batch(self.chain.arm, 500, seed) for seed in range(8)]
        alone = [self.forward.step_batch(*queries) for queries in batches]
        with ThreadPoolExecutor(4) as pool:
            together = list(pool.map(lambda queries: self.forward.step_batch(*queries), batches))
        for one, other in zip(alone, together):
            np.testing.assert_array_equal(one, other)

    def test_other_threads_run_while_a_plan_is_made(self):
        ticks = []
        ended = threading.Event()

        def tick():
            while not ended.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)
        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.monotonic()
        limber.make_planner().plan(self.problem, limber.PlannerLimits(time_s=0.5), 1)
        end = time.monotonic()
        ended.set()
        ticker.join()
        during = [t for t in ticks if begin <= t <= end]
        self.assertGreater(len(during), 20)  # of about 500, however busy the machine is

    def test_two_arms_in_one_program(self):
        three = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
        arms = [limber.VirtualArm(self.chain.arm), limber.VirtualArm(three)]
        alone = limber.VirtualArm(three).settle([30.0, -20.0, 10.0], 0.5).backbone

        def settle(index):
            return arms[index].settle([30.0, -20.0, 10.0][:2 + index], 0.5).backbone
        with ThreadPoolExecutor(2) as pool:
            both = list(pool.map(settle, [0, 1]))
        np.testing.assert_array_equal(both[1], alone)

    def test_a_planner_takes_one_caller_at_a_time(self):
        planner = limber.make_planner()
        refused = []

        def callback(progress):
            try:
                planner.plan(self.problem, limber.PlannerLimits(iterations=1), 1)
            except limber.InputError as error:
                refused.append(str(error))
            return False
        planner.plan(self.problem, limber.PlannerLimits(time_s=20.0), 1, callback)
        self.assertIn("make one for each thread", refused[0])

    def test_problems_keep_their_parts_alive(self):
        def problem():
            arm = limber.load_arm(self.chain.folder / "arm.yaml")
            model = limber.MotionModel(limber.ForwardModel(arm))
            tip = limber.tip_pose(limber.NoLoadModel(arm).backbone([-20.0, -35.0]))
            return limber.PlanningProblem(arm, model, limber.Environment(
                "free", [], limber.PoseGoal(x_m=tip.x_m, y_m=tip.y_m)))
        limber.write_arm(self.chain.folder / "arm.yaml", self.chain.arm)
        kept = problem()
        result = limber.make_planner().plan(kept, limber.PlannerLimits(iterations=200), 1)
        self.assertEqual(result.plan.environment_name, "free")


if __name__ == "__main__":
    unittest.main()
