"""Python's threads: models are shared, calls run beside each other, and what takes one caller at a
time says so."""

import pathlib
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import limber
from chain import TWO_SEGMENT, chain
from test_arrays import batch


LONG_CALL_S = 0.05  # from here on, it is asked how long the others were kept waiting
HELD_SHARE = 0.5  # of a long call, at most, without a break for others
PATIENCE_S = 5.0  # a busy machine may not wake the other thread within a short call for long


class Others:
    """A thread that counts whenever it gets Python's lock, which nobody takes from a running thread
    meanwhile: during a call it counts only if that lets go of the lock."""

    def __enter__(self):
        self.ticks = []
        self.ended = False
        self.interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)
        self.thread = threading.Thread(target=self.run)
        self.thread.start()
        return self

    def run(self):
        while not self.ended:
            self.ticks.append(time.monotonic())
            time.sleep(0.0002)

    def __exit__(self, *_):
        self.ended = True
        self.thread.join()
        sys.setswitchinterval(self.interval)

    def ever_run_during(self, call):
        """Whether one call of many let the thread run."""
        deadline = time.monotonic() + PATIENCE_S
        while not self.may_run_during(call):
            if time.monotonic() > deadline:
                return False
        return True

    def may_run_during(self, call):
        """Whether the thread counted during the call, and a long call never kept it waiting long."""
        before = len(self.ticks)
        begin = time.monotonic()
        call()
        end = time.monotonic()
        during = [tick for tick in self.ticks[before:] if begin < tick < end]
        if not during:
            return False
        if end - begin < LONG_CALL_S:
            return True
        breaks = [begin, *during, end]
        return max(b - a for a, b in zip(breaks, breaks[1:])) < HELD_SHARE * (end - begin)


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

    def long_calls(self, folder):
        """Calls that can take over a millisecond, by name."""
        arm, environment = self.chain.arm, self.chain.environment
        model = limber.read_model(self.chain.model)
        plan = self.planned(5).plan
        self.assertTrue(plan)
        run = limber.execute(arm, environment, plan, limber.VirtualArm(arm))
        limber.write_plan(folder / "plan.json", plan)
        episodes = limber.read_recording(self.chain.recording).episodes
        fit = limber.fit_simple_model(arm, episodes)
        many = episodes * 20
        queries = batch(arm, 20000)
        valves = limber.identify_valves(episodes, arm)
        (folder / "large").write_bytes(bytes(50_000_000))
        return {
            "fit_simple_model": lambda: limber.fit_simple_model(arm, episodes),
            "fitted_arm": lambda: limber.fitted_arm(arm, fit, episodes),
            "gap_bounds_of": lambda: limber.gap_bounds_of(many),
            "make_recording": lambda: limber.make_recording(arm, many),
            "with_setpoints_only": lambda: limber.with_setpoints_only(many),
            "TrainingData": lambda: limber.TrainingData(many),
            "read_model": lambda: limber.read_model(self.chain.model),
            "write_model": lambda: limber.write_model(folder / "m.safetensors", model),
            "read_plan": lambda: limber.read_plan(folder / "plan.json"),
            "write_plan": lambda: limber.write_plan(folder / "p.json", plan),
            "write_setpoints_csv": lambda: limber.write_setpoints_csv(folder / "s.csv", plan),
            "write_backbones_csv": lambda: limber.write_backbones_csv(folder / "b.csv", plan),
            "load_arm": lambda: limber.load_arm(TWO_SEGMENT),
            "write_arm": lambda: limber.write_arm(folder / "arm.yaml", arm),
            "load_environment": lambda: limber.load_environment(self.chain.environment_file),
            "write_environment": lambda: limber.write_environment(folder / "e.yaml", environment),
            "read_recording": lambda: limber.read_recording(self.chain.recording),
            "content_hash": lambda: limber.content_hash(folder / "large"),
            "VirtualArm": lambda: limber.VirtualArm(arm),
            "plan_animation": lambda: limber.plan_animation(arm, environment, plan),
            "pressure_picture": lambda: limber.pressure_picture(arm, plan),
            "execution_picture": lambda: limber.execution_picture(arm, environment, plan, run),
            "execution_animation": lambda: limber.execution_animation(arm, environment, plan, run),
            "Plan._repr_svg_": plan._repr_svg_,
            "ExecutionResult._repr_svg_": run._repr_svg_,
            "to_json": lambda: limber.to_json(run, environment),
            "evaluate": lambda: limber.evaluate(limber.ForwardModel(arm), self.forward, episodes),
            "identify_valves": lambda: limber.identify_valves(many, arm),
            "write_valves": lambda: limber.write_valves(folder / "v.yaml", valves),
            "step_batch": lambda: self.forward.step_batch(*queries),
            "NoLoadModel.backbone": lambda: limber.NoLoadModel(arm).backbone(queries[0]),
            "rollout": lambda: self.forward.rollout(queries[0], queries[2][0]),
            "certify": lambda: limber.certify(plan, arm, model, limber.ValveParameters(),
                                              environment),
        }

    def test_other_threads_run_during_every_long_call(self):
        with tempfile.TemporaryDirectory(prefix="limber_test_") as name:
            calls = self.long_calls(pathlib.Path(name))
            with Others() as others:
                for name, call in calls.items():
                    self.assertTrue(others.ever_run_during(call), name)

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
