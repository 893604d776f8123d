#!/usr/bin/env python3
"""Searches gains for `limber experiment --controller jacobian`.

The search runs on seeds that no table uses: gains are drawn on a logarithmic scale, then
in shrinking ranges around the best. A run's score is its distance to the goal at the end, or 10 cm
more if it collided; a set of gains is as good as the mean over all environments, disturbances and
trials. The best belong into src/run/tracking/jacobian_gains.cpp, as defaults.

    tools/tune_baselines.py --limber build/release/bin/limber --model model.safetensors
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import tempfile

RANGES = {
    "proportional": (0.02, 2.0),
    "integral": (0.1, 10.0),
    "damping": (0.0002, 0.02),
}
GAINS = {"jacobian": ("proportional", "integral", "damping")}
DISTURBANCES = ("none", "noise", "lost_tracking", "weak_actuator", "friction", "tip_load")
COLLISION_CM = 10.0


def draw(drawn, gains, best, width):
    """Gains on a logarithmic scale: anywhere (best is None), or within `width` of the range."""
    result = {}
    for name in gains:
        low, high = (math.log(end) for end in RANGES[name])
        if best is None:
            value = drawn.uniform(low, high)
        else:
            value = math.log(best[name]) + drawn.uniform(-width, width) * (high - low)
        result[name] = float(f"{math.exp(min(max(value, low), high)):.3g}")
    return result


def text(controller, gains):
    return controller + "".join(f",{name}={value:g}" for name, value in gains.items())


def scores(arguments, controllers, folder):
    """One score for each of `controllers`; all execute the same plans."""
    command = [arguments.limber, "experiment", "--model", arguments.model, "--network-only",
               "--trials", arguments.trials, "--max-queries", arguments.max_queries,
               "--seed", arguments.seed, "--out", folder, "--resume", "--quiet"]
    for controller in controllers:
        command += ["--controller", controller]
    for disturbance in arguments.disturbance or DISTURBANCES:
        command += ["--disturbance", disturbance]
    if arguments.environments:
        command += ["--environments", arguments.environments]
    subprocess.run([*map(str, command)], check=True, stdout=subprocess.DEVNULL)
    found = {}
    rows = json.loads((pathlib.Path(folder) / "table.json").read_text(encoding="utf-8"))
    for row in rows:
        if row["executed"]:
            total = (row["executed"] * row["distance_to_goal_cm"]["mean"]
                     + COLLISION_CM * row["collided"])
            runs, sum_cm = found.get(row["controller"], (0, 0.0))
            found[row["controller"]] = (runs + row["executed"], sum_cm + total)
    return {name: sum_cm / runs for name, (runs, sum_cm) in found.items()}


def search(arguments, controller, folder):
    drawn = random.Random(arguments.seed)
    gains = GAINS[controller]
    tried = {}
    best = None
    for width in (None, 0.2, 0.08):
        candidates = [draw(drawn, gains, None if width is None else best, width)
                      for _ in range(arguments.candidates)]
        names = {text(controller, candidate): candidate for candidate in candidates}
        for name, score in scores(arguments, list(names), folder).items():
            if name in names:
                tried[name] = (score, names[name])
        score, best = min(tried.values(), key=lambda pair: pair[0])
        print(f"{text(controller, best)}: {score:.3f} cm, of {len(tried)} tried", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", default="build/release/bin/limber")
    parser.add_argument("--model", required=True)
    parser.add_argument("--environments", help="folder; limber's own by default")
    parser.add_argument("--trials", type=int, default=2)
    parser.add_argument("--candidates", type=int, default=12, help="in each of three rounds")
    parser.add_argument("--max-queries", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=7001, help="of plans and gains; not a table's")
    parser.add_argument("--controller", choices=tuple(GAINS), action="append")
    parser.add_argument("--disturbance", action="append",
                        help=f"may be repeated; {', '.join(DISTURBANCES)} by default")
    arguments = parser.parse_args()
    for controller in arguments.controller or tuple(GAINS):
        with tempfile.TemporaryDirectory() as folder:
            search(arguments, controller, pathlib.Path(folder) / "tuning")


if __name__ == "__main__":
    main()
