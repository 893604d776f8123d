#!/usr/bin/env python3
"""Measures the tables of docs/planning.md and of its log: ablation, paper mode, OMPL's planners, random environments.

    tools/planning_figures.py --limber build/release/bin/limber --model model.safetensors --out out/planning
    tools/planning_figures.py --model model.safetensors --out out/planning --rows default paper
    tools/planning_figures.py --out out/planning --print             the tables of what is there

Every row is a `limber experiment` in OUT/ROW; rows that are finished are not run again, and one that
was stopped goes on. Times mean something on an idle machine only. Planning seeds, and the seed of the
random environments, come from the commit's hash unless --seed gives one, so that nobody has chosen them.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

FIRST = ["--cost-threshold", "1000000"]  # stops at the first plan
BOTH_CORES = ["--jobs", "1", "--planner-jobs", "2"]  # one plan after another; else two at a time
BOTH_MODELS = "both models"  # the no-load model too, which elsewhere is left out
RANDOM = "random_environments"
EMPTY = "empty_environments"  # limber's own, without their obstacles: what a plan costs at least
OWN = pathlib.Path(__file__).resolve().parents[1] / "environments"
# Rows: planner, trials in each environment, seconds each, further flags.
ROWS = {
    "default": ("default", 5, 10, []),
    "both_cores": ("default", 5, 10, BOTH_CORES),
    "paper": ("paper", 5, 60, []),
    "first": ("default", 20, 10, [*FIRST, *BOTH_CORES]),
    "first_forest": ("default", 20, 10, [*FIRST, *BOTH_CORES, "--forest", "FOREST"]),
    "first_paper": ("paper", 20, 60, FIRST),
    "plain": ("default,goal_steering_share=0,improved_plans=0", 2, 10, []),
    "shots": ("default,improved_plans=0", 2, 10, []),
    "with_forest": ("default", 2, 10, ["--forest", "FOREST"]),
    "threads": ("default", 2, 10, ["--forest", "FOREST", *BOTH_CORES]),
    "empty": ("default", 2, 10, ["--environments", EMPTY]),
    "executed": ("default", 20, 1, [BOTH_MODELS]),
    "no_valves": ("default", 20, 1, ["--no-valves"]),
    "paper_valves": ("paper,valves=1", 5, 60, []),
    # Arrivals over planning time, with the room that the model asks for.
    "arrive_first": ("default", 20, 10, FIRST),
    "arrive_0.1s": ("default", 20, 0.1, []),
    "arrive_1s": ("default", 20, 1, []),
    "arrive_10s": ("default", 20, 10, []),
    "arrive_random_first": ("default", 1, 10, [*FIRST, "--environments", RANDOM]),
    "arrive_random_0.1s": ("default", 1, 0.1, ["--environments", RANDOM]),
    "arrive_random_1s": ("default", 1, 1, ["--environments", RANDOM]),
    "arrive_random_10s": ("default", 1, 10, ["--environments", RANDOM]),
    "random": ("default", 1, 60, [*FIRST, *BOTH_CORES, "--environments", RANDOM]),
    "random_paper": ("paper", 1, 60, [*FIRST, "--environments", RANDOM]),
}
# Settings of OMPL's planners that are tried, one trial an environment, before the best of each is
# measured.
OMPL = {
    "ompl:RRT": [f"frames={f},goal_bias={b}" for f, b in
                 [(5, 0.05), (10, 0.05), (20, 0.05), (10, 0.2), (20, 0.2), (10, 0.4)]],
    "ompl:EST": [f"frames={f},range={r}" for f, r in
                 [(5, 0.2), (10, 0.2), (20, 0.2), (10, 0.5), (10, 1.0)]],
    "ompl:KPIECE1": [f"frames={f},goal_bias={b}" for f, b in
                     [(5, 0.05), (10, 0.05), (20, 0.05), (10, 0.2), (20, 0.2)]],
    "ompl:PDST": [f"frames={f},goal_bias={b}" for f, b in
                  [(5, 0.05), (10, 0.05), (20, 0.05), (10, 0.2), (20, 0.2)]],
    "ompl:SST": [f"frames={f},selection_radius={s},pruning_radius={p}" for f, s, p in
                 [(5, 0.2, 0.1), (10, 0.2, 0.1), (20, 0.2, 0.1), (10, 0.1, 0.03), (20, 0.4, 0.2)]],
}
OMPL_TRIAL_S, OMPL_LIMIT_S, OMPL_TRIALS = 2, 10, 5


class Runner:
    def __init__(self, options):
        self.limber = options.limber
        self.model = options.model
        self.out = pathlib.Path(options.out)
        self.printing = options.print
        self.seed = options.seed
        self.valves = ["--valves", options.valves] if options.valves else []

    def experiment(self, name, planner, trials, time_s, flags):
        """The trials of a row, as `limber experiment` wrote them; none where there are none."""
        folder = self.out / name
        if not self.printing:
            places = {"FOREST": "forest", RANDOM: RANDOM, EMPTY: EMPTY}
            places = {word: str(self.out / name) for word, name in places.items()}
            flags = [places.get(flag, flag) for flag in flags]
            if places[RANDOM] in flags:
                self.draw_environments()
            if places[EMPTY] in flags:
                self.empty_environments()
            models = [] if BOTH_MODELS in flags else ["--network-only"]
            flags = [flag for flag in flags if flag != BOTH_MODELS]
            self.run("experiment", "--model", self.model, *models, "--planner", planner, "--trials", trials, "--time-limit-s", time_s, "--seed", self.seed,
                     *([] if "--no-valves" in flags else self.valves), *flags, "--out", folder, "--resume")
        return [json.loads(p.read_text()) for p in sorted((folder / "trials").glob("*.json"))]

    def run(self, *arguments):
        command = [self.limber, *map(str, arguments)]
        print("+", *command, file=sys.stderr)
        if subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode != 0:
            sys.exit(f"{command[1]} failed")

    def draw_environments(self):
        if not (self.out / RANDOM).exists():
            self.run("environment", "--random", "--count", 100, "--seed", self.seed, "--out",
                     self.out / RANDOM)

    def empty_environments(self):
        folder = self.out / EMPTY
        folder.mkdir(parents=True, exist_ok=True)
        for path in OWN.glob("*.yaml"):
            lines = path.read_text().splitlines()
            kept = [line for line in lines if not line.startswith("  - ")]
            text = "\n".join(kept).replace("obstacles:", "obstacles: []")
            (folder / path.name).write_text(text + "\n")

    def compare_ompl(self, only):
        for planner, settings in OMPL.items():
            if only and planner not in only:
                continue
            tried = {}
            for text in settings:
                name = f"{planner},{text}"
                folder = "tried_" + name.replace(":", "_").replace(",", "_").replace("=", "_")
                trials = self.experiment(folder, name, 1, OMPL_TRIAL_S, FIRST)
                if trials:
                    tried[name] = sum(first_s(t) or 2 * OMPL_TRIAL_S for t in trials)
            if not tried:
                continue
            best = min(tried, key=tried.get)
            folder = "ompl_" + planner.split(":")[1]
            trials = self.experiment(folder, best, OMPL_TRIALS, OMPL_LIMIT_S, [*FIRST, "--jobs", 1])
            print(line(f"{best} (best of {len(tried)})", trials))


def first_s(trial):
    return trial["first_solution"]["time_s"] if trial["status"] == "solved" else None


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def cost_after(trial, time_s):
    """Of the best plan known then."""
    costs = [e["best_cost_kpa"] for e in trial["events"] if e["time_s"] <= time_s]
    return costs[-1] if costs else None


def medians(trials, time_s):
    """Median cost in every environment where all its trials were solved by then."""
    costs = {}
    for trial in trials:
        costs.setdefault(trial["environment"], []).append(cost_after(trial, time_s))
    return {
        name: statistics.median(values) for name, values in costs.items() if None not in values
    }


def line(name, trials):
    solved = [t for t in trials if t["status"] == "solved"]
    if not solved:
        return f"| {name} | 0 of {len(trials)} | | | | | | |"
    times = [1e3 * first_s(t) for t in solved]
    queries = [t["first_solution"]["queries"] for t in solved]
    mean = statistics.mean(times)
    error = statistics.stdev(times) / len(times) ** 0.5 if len(times) > 1 else 0.0

    def cost(time_s):
        known = medians(trials, time_s)
        return f"{statistics.mean(known.values()):.0f} ({len(known)})" if known else "–"

    return (
        f"| {name} | {len(solved)} of {len(trials)} | {statistics.median(queries):.0f} "
        f"| {statistics.median(times):.2f}, {mean:.2f} ± {error:.2f}, {quantile(times, 0.95):.1f} ms "
        f"| {cost(0.1)} | {cost(1)} | {cost(10)} | {cost(60)} |"
    )


def ratios(rows):
    """Cost of the default planner, on both cores, over paper mode's after 60 s."""
    paper = medians(rows["paper"], 60)
    lines = ["", "| environment | paper, 60 s | default, 1 s | ratio | 10 s | ratio | no obstacles, 10 s |",
             "|---|---|---|---|---|---|---|"]
    one, ten = medians(rows["both_cores"], 1), medians(rows["both_cores"], 10)
    empty = medians(rows.get("empty", []), 10)
    for name, cost in paper.items():
        if name in one and name in ten:
            lines.append(f"| {name} | {cost:.0f} kPa | {one[name]:.0f} | {one[name] / cost:.2f} "
                         f"| {ten[name]:.0f} | {ten[name] / cost:.2f} | {empty.get(name, 0):.0f} |")
    return "\n".join(lines)


def executed(trials):
    """Where executed plans ended, runs that collided included, by model and environment."""
    lines = ["", "| executed | plans | collided | distance to goal: median, mean, 95 % | orientation: mean |",
             "|---|---|---|---|---|"]
    for model in ("network", "no_load"):
        of_model = [t for t in trials if t["model"] == model and t["execution"]]
        for name in ["all", *sorted({t["environment"] for t in of_model})]:
            runs = [t["execution"] for t in of_model if name in ("all", t["environment"])]
            ends = [r["distance_to_goal_cm"] for r in runs]
            turns = [r["orientation_to_goal_rad"] for r in runs if r["orientation_to_goal_rad"]]
            turn = f"{statistics.mean(turns):.2f} rad" if turns else "–"
            lines.append(
                f"| {model}, {name} | {len(runs)} | {sum(r['collided'] for r in runs)} "
                f"| {statistics.median(ends):.1f}, {statistics.mean(ends):.1f}, "
                f"{quantile(ends, 0.95):.1f} cm | {turn} |")
    return "\n".join(lines)


def predicted(name, trials):
    """Tip as planned against tip as executed: in motion, the largest, and at the end."""
    runs = [t["execution"]["prediction_error_cm"] for t in trials
            if t["model"] == "network" and t["execution"]]
    if not runs:
        return f"| {name} | 0 | | | |"
    return (f"| {name} | {len(runs)} | {statistics.mean(r['before_hold'] for r in runs):.2f} "
            f"| {statistics.mean(r['largest'] for r in runs):.2f} "
            f"| {statistics.median(r['final'] for r in runs):.2f} cm |")


def arrivals(name, trials):
    runs = [t["execution"] for t in trials if t["model"] == "network" and t["execution"]]
    arrived = sum(r["goal_reached"] and not r["collided"] for r in runs)
    ends = [r["distance_to_goal_cm"] for r in runs]
    error = statistics.stdev(ends) / len(ends) ** 0.5 if len(ends) > 1 else 0.0
    distance = f"{statistics.mean(ends):.2f} ± {error:.2f}, {quantile(ends, 0.95):.2f} cm" if ends else "–"
    solved = [t for t in trials if t["status"] == "solved"]
    parts = ["–"] if not solved else [
        f"{1e3 * statistics.median(times):.1f}" for times in (
            [first_s(t) for t in solved], [t["first_candidate_s"] for t in solved],
            [t["first_certificate_s"] for t in solved])]
    cost = f"{statistics.mean(t['cost_kpa'] for t in solved):.0f} kPa" if solved else "–"
    return (f"| {name} | {len(trials)} | {len(runs)} | {arrived} "
            f"| {sum(r['collided'] for r in runs)} | {distance} | {' = '.join(parts[:1])} ms "
            f"({' + '.join(parts[1:])}) | {cost} |")


def seed_of_commit():
    """The first 32 bits of the commit's hash."""
    commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=OWN, capture_output=True, text=True,
                            check=False).stdout
    return int(commit[:8], 16) if commit else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", default="build/release/bin/limber")
    parser.add_argument("--model")
    parser.add_argument("--out", default="out/planning")
    parser.add_argument("--rows", nargs="*", choices=[*ROWS, *OMPL])
    parser.add_argument("--valves", help="valve model, where the model itself knows none")
    parser.add_argument("--seed", type=int, help="default: the commit's hash")
    parser.add_argument("--print", action="store_true", help="only what is there already")
    options = parser.parse_args()
    options.seed = seed_of_commit() if options.seed is None else options.seed
    if not options.model and not options.print:
        parser.error("--model is required")
    runner = Runner(options)
    print("| row | solved | queries to the first plan | time to it: median, mean, 95 % | cost after "
          "0.1 s | 1 s | 10 s | 60 s |")
    print("|---|---|---|---|---|---|---|---|")
    rows = {}
    for name, (planner, trials, time_s, flags) in ROWS.items():
        if options.rows and name not in options.rows:
            continue
        found = runner.experiment(name, planner, trials, time_s, flags)
        if found:
            rows[name] = found
            print(line(name, found), flush=True)
    if not options.rows or set(options.rows) & set(OMPL):
        runner.compare_ompl(options.rows)
    arriving = [name for name in rows if name.startswith("arrive_")]
    if arriving:
        print("\n| | trials | solved | arrive | collide | distance: mean, 95 % | first certified plan "
              "(candidate + certificate), medians | cost |\n|---|---|---|---|---|---|---|---|")
        print("\n".join(arrivals(name, rows[name]) for name in arriving))
    moved = [name for name in ("executed", "no_valves") if name in rows]
    if moved:
        print(f"\nseed {options.seed}\n\n| tip, predicted against executed | runs | mean before the hold "
              "| largest, mean over runs | end, median |\n|---|---|---|---|---|")
        print("\n".join(predicted(name, rows[name]) for name in moved))
        print("\n| | trials | executed | arrived, not collided | collided | distance | first plan "
              "| cost |\n|---|---|---|---|---|---|---|---|")
        print("\n".join(arrivals(name, [t for t in rows[name] if t["model"] == "network"])
                        for name in moved))
    if "executed" in rows:
        print(executed(rows["executed"]))
    if "paper" in rows and "both_cores" in rows:
        print(ratios(rows))


main()
