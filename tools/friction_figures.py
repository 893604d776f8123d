#!/usr/bin/env python3
"""Friction that helps? Dither while holding, and approaching from one side, on the virtual arm (docs/friction.md).

    PYTHONPATH=build/release/python tools/friction_figures.py scatter --seed 1
    PYTHONPATH=build/release/python tools/friction_figures.py plans --model model.safetensors --ways "from 20 kPa above"
    PYTHONPATH=build/release/python tools/friction_figures.py plans --model model.safetensors --seed 1

`scatter`: where the tip comes to rest at one set point, after different histories. `plans`: where it comes to rest
after plans, and where the model says it does; each way to finish is part of the motion, in the model's prediction
as on the arm.
"""

import argparse
import math
import multiprocessing
import pathlib

import numpy as np

import limber

ROOT = pathlib.Path(__file__).resolve().parents[1]
HOLD_S = 1.0
SHARE_OF_LIMIT = 0.8  # of every segment's limit, for random set points
HISTORY_MOTIONS = 4
HISTORY_HOLD_S = 0.3
NEAR_M = 0.01
CM = 100.0


def plain(_):
    return []


def dither(amplitude_kpa, cycles, decays):
    """Up and down together at the arm's rate, every segment by the same amount; the last one ends at the set point."""

    def offsets(segments):
        for cycle in range(cycles):
            now = amplitude_kpa * (1.0 - cycle / cycles if decays else 1.0)
            yield now * np.ones(segments)
            yield -now * np.ones(segments)

    return lambda segments: list(offsets(segments))


def from_above(overshoot_kpa):
    return lambda segments: [overshoot_kpa * np.ones(segments)]


WAYS = {
    "plain": plain,
    "dither 5 kPa, 5 times": dither(5.0, 5, False),
    "dither 5 kPa, 5 times, fading": dither(5.0, 5, True),
    "dither 10 kPa, 5 times, fading": dither(10.0, 5, True),
    "dither 20 kPa, 5 times, fading": dither(20.0, 5, True),
    "dither 40 kPa, 5 times, fading": dither(40.0, 5, True),
    "from 10 kPa above": from_above(10.0),
    "from 20 kPa above": from_above(20.0),
    "from 40 kPa above": from_above(40.0),
    "from 80 kPa above": from_above(80.0),
    "from the upper limit": from_above(1000.0),
}


class Motion:
    """Set points, straight at the arm's rate from one to the next."""

    def __init__(self, arm):
        self.arm = arm
        self.limits = np.asarray(arm.pressure_limits_kpa, float)
        self.at = np.zeros(arm.segment_count)
        self.rows = []

    def to(self, point):
        point = np.clip(point, -self.limits, self.limits)
        frames = max(1, math.ceil(np.max(np.abs(point - self.at)) / self.arm.pressure_step_limit_kpa - 1e-6))
        self.rows += [self.at + (point - self.at) * k / frames for k in range(1, frames + 1)]
        self.at = point
        return self

    def hold(self, seconds):
        self.rows += [self.at] * self.arm.frames_in(seconds)
        return self

    def finish(self, point, way):
        """To the set point, there as `way` has it, then the hold."""
        self.to(point)
        for offset in way(self.arm.segment_count):
            self.to(point + offset)
        return self.to(point).hold(HOLD_S)

    def on_the_arm(self):
        arm = limber.VirtualArm(self.arm)
        for row in self.rows:
            arm.command(row)
        return arm.true_backbone()

    def predicted(self, model):
        rest = model.forward.no_load.backbone(np.zeros(self.arm.segment_count, np.float32))
        state = model.settled_state(np.zeros(self.arm.segment_count, np.float32), rest)
        for row in self.rows:
            model.step(row.astype(np.float32), state)
        return state.backbone


def scatter_of_point(job):
    """Tips after each way and history, of one set point."""
    arm_name, seed, index, histories = job
    arm = limber.load_arm(arm_name)
    random = np.random.default_rng([seed, index])
    limits = SHARE_OF_LIMIT * np.asarray(arm.pressure_limits_kpa, float)
    point = random.uniform(-limits, limits)
    starts = [random.uniform(-limits, limits, (HISTORY_MOTIONS, arm.segment_count)) for _ in range(histories)]
    result = {}
    for name, way in WAYS.items():
        tips = []
        for start in starts:
            motion = Motion(arm)
            for before in start:
                motion.to(before).hold(HISTORY_HOLD_S)
            tips.append(motion.finish(point, way).on_the_arm()[-1, :2])
        tips = np.array(tips)
        around = np.linalg.norm(tips - tips.mean(axis=0), axis=1)
        apart = np.linalg.norm(tips[:, None] - tips[None, :], axis=2).max()
        result[name] = (np.sqrt(np.mean(around**2)), apart)
    return result


def scatter(options, pool):
    jobs = [(options.arm, options.seed, index, options.histories) for index in range(options.points)]
    rows = pool.map(scatter_of_point, jobs, chunksize=1)
    print(f"{options.points} set points, {options.histories} histories each, arm {pathlib.Path(options.arm).stem}, seed {options.seed}\n")
    print("| | scatter of the tip (root mean square) | farthest two histories, mean | largest |")
    print("|---|---|---|---|")
    for name in WAYS:
        squares = np.mean([row[name][0] ** 2 for row in rows])
        apart = [row[name][1] for row in rows]
        print(f"| {name} | {CM * math.sqrt(squares):.2f} cm | {CM * np.mean(apart):.2f} cm | {CM * max(apart):.2f} cm |")


def errors_of_plan(job):
    """What the tip is off its prediction after each way to finish one plan, and how far the way moves the prediction."""
    arm_name, model_file, environment_name, seed, queries = job
    arm = limber.load_arm(arm_name)
    compensation = limber.read_model(model_file)
    model = limber.MotionModel(limber.ForwardModel(arm, compensation), limber.ValveModel(arm, compensation.valves))
    environment = limber.load_environment(environment_name, arm)
    problem = limber.PlanningProblem(arm, model, environment)
    limits = limber.PlannerLimits(queries=queries)
    plan = limber.make_planner("default", 1).plan(problem, limits, seed).plan
    if plan is None:
        return None
    result = {}
    for name, way in WAYS.items():
        motion = Motion(arm)
        points = np.asarray(plan.waypoints_kpa, float)
        for point in points[1:-1]:
            motion.to(point)
        motion.finish(points[-1], way)
        predicted, found = motion.predicted(model)[-1, :2], motion.on_the_arm()[-1, :2]
        result[name] = (np.linalg.norm(predicted - found), predicted)
    return {name: (error, np.linalg.norm(predicted - result["plain"][1]))
            for name, (error, predicted) in result.items()}


def plans(options, pool):
    names = sorted(map(str, (ROOT / "environments").glob("*.yaml")))
    jobs = [(options.arm, options.model, name, options.seed + 1000 * k, options.queries)
            for k in range(options.trials) for name in names]
    rows = [row for row in pool.map(errors_of_plan, jobs, chunksize=1) if row is not None]
    print(f"{len(rows)} plans of {len(jobs)}, {pathlib.Path(options.model).name}, seed {options.seed}\n")
    print("| | tip off its prediction: mean | median | 95 % | within 1 cm | nearer than plain | end moved by, mean |")
    print("|---|---|---|---|---|---|---|")
    for name in WAYS:
        errors = np.array([row[name][0] for row in rows])
        base = np.array([row["plain"][0] for row in rows])
        moved = np.mean([row[name][1] for row in rows])
        stderr = np.std(errors, ddof=1) / math.sqrt(len(errors))
        print(f"| {name} | {CM * errors.mean():.2f} ± {CM * stderr:.2f} cm | {CM * np.median(errors):.2f} cm "
              f"| {CM * np.quantile(errors, 0.95):.2f} cm | {np.sum(errors <= NEAR_M)} | {np.sum(errors < base)} | {CM * moved:.2f} cm |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("scatter", "plans"))
    parser.add_argument("--arm", default=str(ROOT / "arms" / "three_segment.yaml"))
    parser.add_argument("--model", help="network, for plans")
    parser.add_argument("--ways", nargs="+", choices=sorted(WAYS), help="beside plain; all by default")
    parser.add_argument("--points", type=int, default=16)
    parser.add_argument("--histories", type=int, default=12)
    parser.add_argument("--trials", type=int, default=4, help="plans in each of limber's own environments")
    parser.add_argument("--queries", type=int, default=20000, help="of each plan")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    if options.what == "plans" and not options.model:
        parser.error("plans: give --model MODEL.safetensors")
    for name in set(WAYS) - {"plain", *(options.ways or WAYS)}:
        del WAYS[name]  # before the pool's processes are forked
    with multiprocessing.Pool(options.jobs) as pool:
        (scatter if options.what == "scatter" else plans)(options, pool)


if __name__ == "__main__":
    main()
