#!/usr/bin/env python3
"""Closed loop in real time beside the virtual arm: a table of docs/log/2026-11-26-experiments.md.

Plans and disturbances are those of closed_loop_table.py (its --out is --table here): of each row the
first runs, as many in every environment. The virtual arm is a program of its own behind the driver
protocol, whose frames take wall time. A run takes 5 to 30 s; what is in OUT is not run again. A
clean stop's distance does not count. Rows can be run side by side (--disturbance). Other flags go
to `limber execute`.

    tools/real_time_rows.py --model calibrated.safetensors --table closed_loop --out real_time
"""

import argparse
import json
import pathlib
import statistics

from closed_loop_table import DISTURBANCES
from kept_parts import KeptParts

SEARCH_MS = 20.0  # what a search in motion is given
HEADER = ("| disturbance | arrive (simulated time) | collide | stopped cleanly | distance: median | "
          "searches in motion | within 20 ms | the longest | late advice | set points late by: 99.9 %, most |\n"
          "|---|---|---|---|---|---|---|---|---|---|")


def first_trials(folder, runs):
    """The first trial of every environment, then the second of each, …"""
    trials = {}
    for path in (folder / "trials").glob("*.json"):
        number = int(path.stem.rsplit("_", 1)[1])
        trials[number, path.stem] = json.loads(path.read_text(encoding="utf-8"))
    return [(name, trials[number, name]) for number, name in sorted(trials)[:runs]]


def served(options, kind, plan, seed):
    """The command that is the disturbed arm."""
    command = [str(options.limber), "virtual-arm", "--serve", "--arm", str(options.arm),
               "--seed", str(seed)]
    if kind not in ("none", "obstacle"):
        command += ["--disturbance", kind]
    if kind == "lost_tracking":
        command += ["--plan", str(plan)]
    return "exec:" + " ".join(command)


def run(parts, options, kind, name, trial):
    plan = options.table / f"replan_{kind}" / "plans" / f"{name}.json"
    obstacle = ("--disturbance", "obstacle") if kind == "obstacle" else ()
    environment = trial["environment"]
    if options.environments:
        environment = options.environments / f"{environment}.yaml"
    return parts.limber(
        "execute", "--json", "--quiet", "--arm", options.arm, "--plan", plan,
        "--environment", environment, "--replan", "--model", options.model, "--seed", trial["seed"],
        *obstacle, *options.others, "--driver", served(options, kind, plan, trial["seed"]), "--force",
        "--out", options.out / f"{name}.h5", codes=(0, 1))


def has_arrived(run):
    return bool(run["goal_reached"]) and not run["collided"]


def line(kind, runs, trials):
    searches = [ms for one in runs for ms in one["searches_ms"]]
    within = sum(ms <= SEARCH_MS for ms in searches)
    simulated = sum(has_arrived(trial["execution"]) for _, trial in trials)
    share = f"{100 * within / len(searches):.1f} %" if searches else "–"
    late = [one["driver"]["late_ms"] for one in runs]
    distances = [one["distance_to_goal_cm"] for one in runs
                 if not one["stopped_ahead"] and one["distance_to_goal_cm"] is not None]
    return (f"| {kind} | {sum(map(has_arrived, runs))} of {len(runs)} ({simulated}) | "
            f"{sum(bool(one['collided']) for one in runs)} | "
            f"{sum(one['stopped_ahead'] and not one['collided'] for one in runs)} | "
            f"{statistics.median(distances):.2f} cm | "
            f"{len(searches)} | {share} | {max(searches, default=0.0):.1f} ms | "
            f"{sum(one['late_advice'] for one in runs)} of "
            f"{sum(one['advice_ms']['count'] for one in runs if one['advice_ms'])} | "
            f"{max(ms['p999'] for ms in late):.1f}, {max(ms['max'] for ms in late):.1f} ms |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--model", type=pathlib.Path, required=True)
    parser.add_argument("--table", type=pathlib.Path, required=True, help="of closed_loop_table.py")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--arm", default="three_segment", help="as in the table")
    parser.add_argument("--environments", type=pathlib.Path,
                        help="folder of the table's, where they are not limber's own")
    parser.add_argument("--runs", type=int, default=20, help="of each row")
    parser.add_argument("--disturbance", nargs="+", default=DISTURBANCES, choices=DISTURBANCES)
    options, options.others = parser.parse_known_args()
    parts = KeptParts(options.limber, options.out)
    print(HEADER, flush=True)
    for kind in options.disturbance:
        trials = first_trials(options.table / f"replan_{kind}", options.runs)
        runs = [parts.kept(name, lambda: run(parts, options, kind, name, trial))
                for name, trial in trials]
        print(line(kind, runs, trials), flush=True)


if __name__ == "__main__":
    main()
