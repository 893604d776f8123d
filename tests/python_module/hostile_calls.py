"""Draws calls of everything public in limber with arguments that are wrong: other types, shapes,
sizes, arms and units, NaN, half-made objects. Prints what was taken that no function may take, what
did not end, and which exceptions were none of limber's or Python's own for wrong arguments.

    python3 hostile_calls.py --seed 1 --calls 500      exit 1 where anything was found
"""

import argparse
import copy
import inspect
import itertools
import os
import pathlib
import random
import re
import signal
import sys
import tempfile

import numpy as np

import limber
from chain import ROOT, TWO_SEGMENT, chain

LONGEST_S = 100.0  # of a call: none has much to do, but the machine may have
REFUSALS = (limber.InputError, TypeError, ValueError, OverflowError, AttributeError, IndexError,
            limber.SystemFault, limber.Interrupted, KeyError, RuntimeError, MemoryError)
RAW = re.compile(r"std::|basic_string|bad_alloc|json\.exception|yaml-cpp|map::at|vector::|H5[A-Z]")


class TooLong(BaseException):
    """A call that did not end."""


def with_values(episode, **changed):
    fields = {name: getattr(episode, name) for name in
              ("time_s", "pressure_kpa", "setpoint_kpa", "backbone", "motion_index", "tracked")}
    return limber.Episode(**{**fields, **changed})


def finer_arm(folder):
    """The two-segment arm, with more plates."""
    text = TWO_SEGMENT.read_text(encoding="utf-8")
    path = folder / "finer.yaml"
    path.write_text(text.replace("name: two_segment", "name: finer").replace("gaps: 5", "gaps: 9"), encoding="utf-8")
    return limber.load_arm(path)


class Arguments:
    """Good ones by the name of a parameter, wrong ones by what they stand for."""

    def __init__(self, folder, rnd):
        # For root, a call that is given /dev/null itself could replace it.
        (folder / "null").symlink_to("/dev/null")
        self.rnd = rnd
        self.folder = folder
        own = chain()
        self.arm = own.arm
        self.other_arm = limber.load_arm(ROOT / "arms" / "three_segment.yaml")
        episodes = limber.read_recording(own.recording).episodes
        model = limber.read_model(own.model)
        forward = limber.ForwardModel(self.arm, model)
        motion = limber.MotionModel(forward)
        problem = limber.PlanningProblem(self.arm, motion, own.environment)
        planned = limber.make_planner().plan(problem, limber.PlannerLimits(iterations=200), 5)
        other = limber.make_recording(self.other_arm, [self.episode_of(self.other_arm)])
        quick = limber.best_preset()
        quick.hidden_units = [4]
        limber.set_epoch_count(quick, 3)
        first = episodes[0]
        n, m = first.pressure_kpa.shape[1], first.backbone.shape[1]
        self.good = {
            "arm": self.arm, "no_load": limber.ForwardModel(self.arm), "network": forward,
            "model": forward, "compensation": model, "forward": forward, "start": model,
            "episodes": episodes, "unseen": episodes, "training": episodes, "episode": first,
            "data": limber.hold_back_validation(episodes, 0.3, 1),
            "recording": limber.read_recording(own.recording), "environment": own.environment,
            "problem": problem, "plan": planned.plan, "result": planned, "settings": quick,
            "limits": limber.PlannerLimits(iterations=20), "seed": 1, "jobs": 1,
            "waypoints_kpa": np.zeros((2, n), np.float32), "planner": "own",
            "path": str(folder / "written"), "folder": str(folder / "exported"), "name": "default",
            "goal": limber.PoseGoal(x_m=0.3, y_m=0.1, position_tolerance_m=0.05),
            "pose": limber.Pose(), "random": limber.RandomStream(1), "fraction": 0.2,
            "previous_kpa": np.zeros(n, np.float32), "current_kpa": np.zeros(n, np.float32),
            "previous": limber.start_state(own.environment, self.arm).backbone,
            "first": limber.start_state(own.environment, self.arm).backbone,
            "backbone": limber.start_state(own.environment, self.arm).backbone,
            "pressures_kpa": np.zeros((5, n), np.float32), "epochs": 5, "restart":
            limber.Restart.every_frame, "fit": limber.fit_simple_model(self.arm, episodes),
            "driver": limber.VirtualArm(self.arm), "room": limber.error_room(forward),
            "valves": limber.ValveModel(self.arm), "learnt": model.learnt, "source": "a test"}
        far = np.array(first.backbone)
        far[3, -1, 0] = 1e30
        gone = np.array(first.backbone)
        gone[2, 1, 1] = np.nan
        # Of another arm, in another unit, or broken: refused by whatever takes it with an arm.
        self.wrong_episodes = {
            "another arm's": list(other.episodes),
            "one of another arm": [*episodes, *other.episodes],
            "millimetres": [with_values(e, backbone=np.multiply(e.backbone, [1e3, 1e3, 1]))
                            for e in episodes],
            "Pa": [with_values(e, pressure_kpa=1e3 * e.pressure_kpa) for e in episodes],
            "a plate at 1e30 m": [with_values(first, backbone=far), *episodes[1:]],
            "NaN": [with_values(first, backbone=gone), *episodes[1:]],
            "too few plates": [with_values(e, backbone=e.backbone[:, :m - 1]) for e in episodes],
            "too many segments": [with_values(
                e, pressure_kpa=np.hstack([e.pressure_kpa, e.pressure_kpa]),
                setpoint_kpa=np.hstack([e.setpoint_kpa, e.setpoint_kpa])) for e in episodes]}
        stopped = limber.train(self.arm, self.good["data"], quick, lambda _: False).model
        halves = [stopped, limber.TrainingData([]), limber.TrainingSettings()]
        finer = finer_arm(folder)
        of_finer = limber.ForwardModel(finer)
        self.odd = [
            None, True, 0, 1, -1, 2**31, 2**63, 2**64, -2**63, 1e308, float("nan"), float("inf"),
            -0.0, 1j, "", "x", "a\0b", "\ud800", b"x", [], [1], [None], {}, {"a": 1}, (),
            np.zeros(0), np.zeros(3), np.full(n, np.nan, np.float32), np.zeros((m, 3)),
            np.zeros((m, 3), np.float32)[::-1], np.zeros((3, m)).T, np.zeros((0, 3)),
            np.zeros((100000, 3), np.float32), np.array("x"), np.array([None] * 3),
            np.zeros(n, complex), np.ones((3, 3, 3, 3)), lambda *a: None, lambda *a: 1 / 0,
            object(), sys, int, str(folder / "none"), str(folder / "null"), str(folder), "x" * 5000,
            *halves, self.other_arm, limber.ForwardModel(self.other_arm), finer, of_finer,
            limber.MotionModel(of_finer), *self.of_space(),
            *self.good.values()]

    def of_space(self):
        """What no planar function may take, and what takes it may not mix with a plane."""
        arm = limber.load_arm(ROOT / "arms" / "hanging_3x2.yaml")
        forward = limber.ForwardModel(arm)
        episode = self.episode_of(arm)
        backbone = forward.no_load.backbone(np.zeros(arm.channel_count))
        return [arm, forward, forward.no_load, limber.VirtualArm(arm), backbone, episode,
                [episode], limber.make_recording(arm, [episode]), limber.TrainingData([episode]),
                limber.fit_space_model(arm, [episode] * 8)]

    def episode_of(self, arm):
        """A short one, of an arm that is commanded by hand."""
        driver = limber.VirtualArm(arm)
        states = [driver.state()]
        for k in range(40):
            states.append(driver.command(np.full(arm.channel_count, k % 20, np.float32)))
        kpa = np.array([s.pressure_kpa for s in states])
        return limber.Episode([s.time_s for s in states], kpa, kpa,
                              np.array([s.backbone for s in states]), [0] * len(states))


def parameters_of(function):
    """Names of parameters, by the first line of pybind11's documentation or Python's own."""
    match = re.match(r"\w+\((.*)\) -> ", (function.__doc__ or "").split("\n")[0])
    if match is None:
        try:
            return [p for p in inspect.signature(function).parameters if p != "self"]
        except (TypeError, ValueError):
            return []
    return [p for p in re.findall(r"(\w+): ", match.group(1)) if p != "self"]


class Campaign:
    def __init__(self, folder, seed):
        self.rnd = random.Random(seed)
        self.given = Arguments(folder, self.rnd)
        self.made = []  # objects that calls returned: their methods are called, too
        self.found = []
        self.calls = 0
        self.refused = 0

    def call(self, function, arguments, what, must_refuse):
        self.calls += 1
        print(what[:300], file=sys.stderr, flush=True)  # the last line says where it crashed
        signal.setitimer(signal.ITIMER_REAL, LONGEST_S)
        try:
            result = function(*arguments)
        except TooLong:
            self.found.append(f"did not end: {what}")
        except REFUSALS as error:
            self.refused += 1
            if RAW.search(str(error)) and "supported" not in str(error):
                self.found.append(f"raw message: {what}: {error}")
        except ZeroDivisionError:
            pass  # a function of ours that was called
        else:
            if must_refuse:
                self.found.append(f"took {must_refuse}: {what}")
            elif type(result).__module__.startswith("limber") and len(self.made) < 200:
                self.made.append(result)
                repr(result)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)

    def draw(self, names):
        """Arguments for these parameters; and what is wrong with them that nobody may take."""
        given = self.given
        arguments = [given.good.get(name, self.rnd.choice(given.odd)) for name in names]
        episodes = [k for k, name in enumerate(names)
                    if name in ("episodes", "unseen", "episode", "data")]
        has_arm = any(name in ("arm", "no_load", "model") for name in names)
        if episodes and has_arm and self.rnd.random() < 0.6:
            kind, wrong = self.rnd.choice(list(given.wrong_episodes.items()))
            k = episodes[0]
            arguments[k] = (limber.TrainingData(wrong, wrong[:1]) if names[k] == "data" else
                            wrong[-1 if "one of" in kind else 0] if names[k] == "episode" else wrong)
            return arguments, kind
        for _ in range(self.rnd.choice([1, 1, 2])):
            if arguments:
                arguments[self.rnd.randrange(len(arguments))] = self.rnd.choice(given.odd)
        if self.rnd.random() < 0.1:
            arguments = arguments[:-1]
        return arguments, ""

    def run(self, calls):
        functions = [name for name in limber.__all__ if callable(getattr(limber, name))]
        for name in itertools.cycle(functions):  # each of them, whatever the others add
            if self.calls >= calls:
                return
            function = getattr(limber, name)
            if not isinstance(function, type):
                arguments, wrong = self.draw(parameters_of(function))
                self.call(function, arguments, f"{name}({arguments!r:.250})", wrong)
                continue
            arguments, _ = self.draw(parameters_of(function.__init__))
            self.call(function, arguments, f"{name}({arguments!r:.250})", "")
            objects = [o for o in [*self.given.good.values(), *self.made] if type(o) is function]
            if objects:
                self.use(self.rnd.choice(objects), name)

    def use(self, one, name):
        """A method, an assignment, or what Python itself does with objects."""
        attribute = self.rnd.choice([a for a in dir(one) if not a.startswith("_")] or ["x"])
        what = f"{name}.{attribute}"
        kind = getattr(type(one), attribute, None)
        if isinstance(kind, property):
            wrong = self.rnd.choice(self.given.odd)
            try:
                changed = copy.deepcopy(one)  # the others go on with the good ones
            except TypeError:
                return
            self.call(lambda: setattr(changed, attribute, wrong), [], f"{what} = {wrong!r:.80}", "")
        elif callable(kind) and attribute != "close":
            arguments, _ = self.draw(parameters_of(kind))
            self.call(getattr(one, attribute), arguments, f"{what}({arguments!r:.200})", "")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--calls", type=int, default=500)
    asked = parser.parse_args()

    def too_long(*_):
        raise TooLong()
    signal.signal(signal.SIGALRM, too_long)
    with tempfile.TemporaryDirectory(prefix="limber_hostile_") as folder:
        os.chdir(folder)  # where calls write that are given "x"
        campaign = Campaign(pathlib.Path(folder), asked.seed)
        campaign.run(asked.calls)
    print(f"{campaign.calls} calls, {campaign.refused} refused, seed {asked.seed}")
    print("\n".join(campaign.found))
    return 1 if campaign.found else 0


if __name__ == "__main__":
    sys.exit(main())
