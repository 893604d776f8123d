#!/usr/bin/env python3
"""The table of docs/experiments.md: controllers and disturbances, over limber's environments.

They are limber's own eight, in which the closed loop was tuned, and random ones, which the virtual
arm itself has moved through and no model has chosen (docs/environments.md). Every controller executes
the same plans. Parts that are in OUT are not run again. Seeds come from a commit, so that nobody
chose them: that of OUT, or the last one that changed a source file, unless said. Other flags go to
`limber experiment`. Arrivals are of all trials, whether a plan was found or not; the rest is of
executed plans.

    tools/closed_loop_table.py --model calibrated.safetensors --out closed_loop
    tools/closed_loop_table.py --model calibrated.safetensors --out closed_loop --in random --random 60 \\
        --controller open replan --disturbance friction tip_load obstacle
"""

import argparse
import itertools
import json
import pathlib
import subprocess

from kept_parts import KeptParts

CONTROLLERS = ("replan", "open", "jacobian")
DISTURBANCES = ("none", "sensor_noise", "noise", "lost_tracking", "obstacle", "weak_actuator", "friction",
                "tip_load")
HEADER = ("| environments | controller | disturbance | arrive | collide | stopped (clean) | "
          "distance: median, 95 % | time to the goal | replans |\n|---|---|---|---|---|---|---|---|---|")


def seed_of(commit):
    """Its first 24 bits."""
    return int(commit[:6], 16)


def last_commit():
    done = subprocess.run(["git", "log", "-1", "--format=%H", "--", "src", "apps"], check=True,
                          stdout=subprocess.PIPE, encoding="utf-8",
                          cwd=pathlib.Path(__file__).parent.parent)
    return done.stdout.strip()


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def shown(value):
    return "–" if value is None else f"{value:.2f}"


def line(kind, row, trials):
    distance = row["distance_to_goal_cm"]
    return (f"| {kind} | {row['controller']} | {row['disturbance'] or 'none'} | {row['reached']} of "
            f"{trials} | {row['collided']} | {row['stopped']} ({row['stopped_ahead']}) | "
            f"{shown(distance['median'])}, {shown(distance['p95'])} cm | "
            f"{shown(row['goal_time_over_plan']['median'])} | {shown(row['replans']['mean'])} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--model", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--commit", help="whose hash gives the seed")
    parser.add_argument("--arm", default="three_segment")
    parser.add_argument("--in", dest="kinds", nargs="+", default=("own", "random"),
                        choices=("own", "random"), help="limber's own environments, or random ones")
    parser.add_argument("--environments", type=pathlib.Path, help="folder in place of limber's own")
    parser.add_argument("--trials", type=int, default=20, help="in each of limber's own environments")
    parser.add_argument("--random", type=int, default=200,
                        help="random environments, with a trial in each; fewer are the first of them")
    parser.add_argument("--max-queries", type=int, default=100000, help="of each plan")
    parser.add_argument("--motion-queries", type=int, default=2000, help="of a search in motion")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--controller", nargs="+", default=CONTROLLERS, choices=CONTROLLERS)
    parser.add_argument("--disturbance", nargs="+", default=DISTURBANCES,
                        help="a kind, or several with commas between that act at once")
    options, others = parser.parse_known_args()
    parts = KeptParts(options.limber, options.out)
    commit = parts.kept("commit", lambda: options.commit or last_commit())
    print(f"seed {seed_of(commit)}, of commit {commit}\n\n{HEADER}", flush=True)
    for kind in options.kinds:
        suffix, trials, environments = "", options.trials, options.environments
        if kind == "random":
            suffix, trials = f"_random_{options.random}", 1
            environments = parts.random_environments(seed_of(commit), options.random, suffix[1:],
                                                     arm=options.arm)
        where = ("--arm", options.arm, *(("--environments", environments) if environments else ()))
        for controller, disturbance in itertools.product(options.controller, options.disturbance):
            folder = options.out / f"{controller}_{disturbance}{suffix}"
            parts.trials(
                folder, *where, "--trials", trials, "--model", options.model, "--network-only",
                "--max-queries", options.max_queries, "--motion-queries", options.motion_queries,
                "--seed", seed_of(commit), "--jobs", options.jobs, "--controller", controller,
                "--disturbance", disturbance, *others)
            (row,) = read(folder / "runs.json")
            run = sum(cell["trials"] for cell in read(folder / "table.json"))
            print(line(kind, row, run), flush=True)


if __name__ == "__main__":
    main()
