#!/usr/bin/env python3
"""How much arm time plans take to end where they are predicted: random motions against `limber improve`.

    tools/arm_time.py --limber build/release/bin/limber --out OUT

A way is START:SHARE. It begins with --start-h of motions: `random` ones, as `collect --schedule random`
makes them, or `straight` ones, each from rest. Then it adds arm time up to about each of --hours; SHARE
of that are plans, the rest random motions, so random:0 is plain collection. Arm time is what is
recorded, and every venting. At each point a new network is trained from the start on all of it
(`improve --from-start`), for as many epoch-hours either way, and plans 100 random environments, the same
for all. The error is how far the tip ends from where the plan has it, executed open loop.

With START:SHARE:prior networks are not trained from the start, but go on from --prior, for as many
epochs at the same rate. docs/improving.md says how such a network is made.

Every part lies in OUT; parts that are finished are not run again.
"""

import argparse
import hashlib
import json
import math
import pathlib
import statistics
import typing

from kept_parts import KeptParts

ENVIRONMENT_SEED = 2_100_001  # used for nothing else
FIRST_SEED = 2_100_002
HOURS = [0.2, 0.4, 0.6, 2.0]
EPOCH_HOURS = 150  # of each training
MIN_EPOCHS = 150
MAX_EPOCHS = 1000
VENTING_S = 1.55  # from a plan's end until the vented arm lies still: median of 60 plans
MOTION_S = 3.0
STRAIGHT_MOTION_S = 2.0  # from rest, with its hold, in the mean
MOTIONS_BETWEEN_VENTINGS = 10  # of random motions, as `improve` makes them, and of straight ones
CHAIN_S = 30.0  # that many motions, or plans
GOAL_CM = 1.0
LEARNING_RATE = 3e-3  # of networks that are trained from the start
ROOM = ("--margin-m", 0.01, "--goal-margin-m", 0, "--goal-margin-rad", 0)
QUERIES = ("--max-queries", 20_000)


def epochs(hours):
    return min(MAX_EPOCHS, max(MIN_EPOCHS, round(EPOCH_HOURS / hours)))


def hours_of(recorded_s, ventings):
    return (recorded_s + VENTING_S * ventings) / 3600


def recorded_min(hours):
    """Of so much arm time, where the arm is vented after each chain."""
    return 60 * hours * CHAIN_S / (CHAIN_S + VENTING_S)


def first_motions(kind, hours):
    """What `collect` is asked for."""
    straight = kind == "straight"
    recorded_s = 60 * recorded_min(hours)
    motions = recorded_s / (STRAIGHT_MOTION_S if straight else MOTION_S)
    return (*(("--approach", "straight", "--hold-s", 1) if straight else ()),
            "--count", MOTIONS_BETWEEN_VENTINGS, "--episodes", round(motions / MOTIONS_BETWEEN_VENTINGS))


class Way(typing.NamedTuple):
    start: str
    share: float
    has_prior: bool = False

    def __str__(self):
        return f"{self.start}:{self.share:g}" + (":prior" if self.has_prior else "")


def way_of(text):
    start, share, *prior = text.split(":") if ":" in text else (text, "-1")
    if start not in ("random", "straight") or not 0.0 <= float(share) <= 1.0 or prior not in ([], ["prior"]):
        raise argparse.ArgumentTypeError(
            f"{text}: expected random:SHARE or straight:SHARE, as straight:1, and perhaps :prior")
    return Way(start, float(share), bool(prior))


class ArmTime(KeptParts):
    def __init__(self, options):
        super().__init__(options.limber, options.out)
        self.options = options
        self.prior = hashlib.sha256(options.prior.read_bytes()).hexdigest()[:8] if options.prior else ""
        self.environments = self.random_environments(ENVIRONMENT_SEED, options.count)

    def suffix(self, way):
        """What tells networks that went on from this prior from others, in names of parts."""
        return f"_prior_{self.prior}" if way.has_prior else ""

    def first_network(self, way, seed):
        """The first recording, the network that learns from it, and its arm time."""
        data = self.out / f"start_{way.start}_{seed}.h5"
        model = self.out / f"start_{way.start}_{seed}{self.suffix(way)}.safetensors"
        collected = self.kept(data.stem, lambda: self.limber(
            "collect", "--json", "--force", "--schedule", "random", "--seed", seed,
            *first_motions(way.start, self.options.start_h), "--out", data))
        if not model.exists():
            before = ("--from", self.options.prior, "--learning-rate", LEARNING_RATE) if way.has_prior else ()
            self.limber("train", "--json", "--force", "--data", data, *before, "--windows", 32,
                        "--epochs", epochs(self.options.start_h), "--seed", seed, "--out", model)
        return data, model, hours_of(collected["arm_time_s"], collected["episodes"])

    def judged(self, name, model):
        """Executed plans: the tip's errors at their ends, and how many arrive."""
        folder = self.out / f"{name}_plans"
        trials = self.trials(folder, "--model", model, "--network-only", "--trials", 1, "--seed", 1,
                             "--environments", self.environments, *QUERIES, *ROOM)
        runs = [trial["execution"] for trial in trials if trial["execution"]]
        errors = sorted(run["prediction_error_cm"]["final"] for run in runs)
        return {"environments": len(trials), "executed": len(runs),
                "collided": sum(run["collided"] for run in runs),
                "median_cm": statistics.median(errors), "mean_cm": statistics.fmean(errors),
                "p95_cm": errors[math.ceil(0.95 * len(errors)) - 1]}

    def curve(self, seed, way):
        """Points in time, each with its arm time, and what plans are then off by."""
        data, model, hours = self.first_network(way, seed)
        recordings, first = [data], model
        points = [{"hours": hours, **self.kept(f"{first.stem}_judged", lambda: self.judged(first.stem, first))}]
        training = ("--prior", self.options.prior) if way.has_prior else ("--from-start",)
        for until in self.options.hours:
            name = f"{way.start}_{way.share:g}{self.suffix(way)}_chain_{self.options.chain}_seed_{seed}_{until:g}h"
            folder = self.out / name
            if not (folder / "summary.json").exists():
                self.limber("improve", "--json", *training, "--model", model, "--data", *recordings,
                            "--rounds", 1, "--round-min", recorded_min(max(until - hours, 0.001)),
                            "--plan-share", way.share, "--chain", self.options.chain,
                            "--selection", 2, "--reported", 2, "--epochs", epochs(until), *QUERIES, *ROOM,
                            "--seed", seed + round(1000 * until), "--out", folder, "--resume")
            round_1 = folder / "round_1"
            model = round_1 / "model.safetensors"
            figures = json.loads((round_1 / "round.json").read_text(encoding="utf-8"))
            hours += hours_of(60 * figures["learning_arm_time_min"], figures["learning_ventings"])
            recordings += [path for path in (round_1 / "plans.h5", round_1 / "exploration.h5")
                           if path.exists()]
            judged = self.kept(f"{name}_judged", lambda: self.judged(name, model))
            points.append({"hours": hours, **judged})
        return points


def hours_to_goal(points):
    """Where the median error falls to GOAL_CM, between two points on logarithmic axes; None: never."""
    if points[0]["median_cm"] <= GOAL_CM:
        return points[0]["hours"]
    for left, right in zip(points, points[1:]):
        if left["median_cm"] > GOAL_CM >= right["median_cm"]:
            part = math.log(left["median_cm"] / GOAL_CM) / math.log(left["median_cm"] / right["median_cm"])
            return left["hours"] * (right["hours"] / left["hours"]) ** part
    return None


def means(curves):
    """The mean of several curves, point by point."""
    return [{key: statistics.fmean(point[key] for point in same) for key in ("hours", "median_cm", "p95_cm")}
            for same in zip(*curves)]


def text(points, reached):
    return ", ".join(f"{point['hours']:.3g} h {point['median_cm']:.2f} cm ({point['p95_cm']:.2f})"
                     for point in points) + (
        f"; {GOAL_CM:g} cm after " + (f"{reached:.2f} h" if reached else "more"))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--ways", type=way_of, nargs="+", metavar="START:SHARE[:prior]",
                        default=[Way("random", 0.0), Way("random", 1.0), Way("straight", 1.0)])
    parser.add_argument("--prior", type=pathlib.Path, help="network that ways with :prior go on from")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--start-h", type=float, default=0.1)
    parser.add_argument("--hours", type=float, nargs="+", default=HOURS)
    parser.add_argument("--count", type=int, default=100, help="of environments")
    parser.add_argument("--chain", type=int, default=10, help="plans between two ventings")
    options = parser.parse_args()
    if options.prior is None and any(way.has_prior for way in options.ways):
        parser.error("--prior: missing, for a way with :prior")
    run = ArmTime(options)
    curves = {way: [] for way in options.ways}
    for seed in range(options.first_seed, options.first_seed + options.seeds):
        for way in options.ways:
            points = run.curve(seed, way)
            curves[way].append(points)
            print(f"{way}, seed {seed}: {text(points, hours_to_goal(points))}", flush=True)
    for way, of_way in curves.items():
        reached = [hours_to_goal(points) for points in of_way]
        print(f"{way}, mean: {text(means(of_way), statistics.fmean(reached) if all(reached) else None)}")


if __name__ == "__main__":
    main()
