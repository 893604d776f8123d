#!/usr/bin/env python3
"""Other valves end to end: recorded, identified, learnt, planned and executed (docs/valves.md, Figures).

    tools/valve_figures.py --limber build/release/bin/limber --out out/valves
    tools/valve_figures.py --out out/valves --rows slow late

An hour of random motions of each arm of tests/arms, a network from it, a plan in each of limber's own
environments, executed; then what the network predicts of those runs from their set points, over what it
predicts from their measured pressures. The seed comes from the commit's hash unless --seed gives one.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
ARMS = {
    "plain": (ROOT / "arms/three_segment.yaml", []),
    "noisy": (ROOT / "arms/three_segment.yaml", ["--noise-kpa", "0.5"]),
    "slow": (ROOT / "tests/arms/slow_valves.yaml", []),
    "late": (ROOT / "tests/arms/late_valves.yaml", []),
    "lopsided": (ROOT / "tests/arms/lopsided_valves.yaml", []),
}
# Half jumps, half straight lines at the arm's rate, cut short or held: 60 minutes in all.
RECORDINGS = [
    ["--schedule", "random", "--hold-s", "2", "--hold-min-s", "0.2", "--count", "60", "--episodes", "21"],
    ["--schedule", "random", "--approach", "straight", "--hold-s", "1.5", "--hold-min-s", "0.05",
     "--count", "50", "--episodes", "20"],
]
EPOCHS = 150
MARGIN_M = "0.005"


def seed_of_commit():
    commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True,
                            check=False).stdout
    return int(commit[:8], 16) if commit else 1


class Row:
    def __init__(self, name, options):
        self.limber = options.limber
        self.seed = options.seed
        self.arm, self.noise = ARMS[name]
        self.folder = pathlib.Path(options.out) / name
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, verb, *arguments, code=(0,)):
        command = [self.limber, verb, "--arm", self.arm, *arguments, "--seed", self.seed, "--json"]
        done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
        if done.returncode not in code:
            sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
        return json.loads(done.stdout)

    def file(self, name):
        return self.folder / name

    def learn(self):
        data = []
        for k, flags in enumerate(RECORDINGS):
            recording = self.file(f"train_{k}.h5")
            if not recording.exists():
                self.run("collect", *flags, *self.noise, "--out", recording)
            data += ["--data", recording]
        if not self.file("model.safetensors").exists():
            self.run("train", *data, "--epochs", EPOCHS, "--out", self.file("model.safetensors"))

    def execute(self):
        """Ratio and errors in cm of every environment's plan."""
        model = ["--model", self.file("model.safetensors")]
        runs = []
        for environment in sorted((ROOT / "environments").glob("*.yaml")):
            plan, run = (self.file(f"{environment.stem}{end}") for end in (".json", ".h5"))
            there = ["--environment", environment]
            found = self.run("plan", *model, *there, "--margin-m", MARGIN_M, "--time-limit-s", 1, "--out",
                             plan, "--force", code=(0, 1))
            if found["status"] != "solved":
                continue
            executed = self.run("execute", "--plan", plan, *there, "--out", run, "--force",
                                code=(0, 1))
            replayed = self.run("evaluate", *model, "--data", run)["network"]
            runs.append((executed, replayed))
        return runs


def line(name, runs):
    def mean(kind):
        return statistics.mean(replayed[kind]["position_error_cm"]["mean"] for _, replayed in runs)

    errors = [executed["prediction_error_cm"] for executed, _ in runs]
    ratio = mean("open_loop_from_setpoints") / mean("open_loop")
    return (f"| {name} | {len(runs)} of 8 | {statistics.mean(e['before_hold'] for e in errors):.2f} "
            f"| {mean('open_loop_from_setpoints'):.2f} | {mean('open_loop'):.2f} | {ratio:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", default=ROOT / "build/release/bin/limber")
    parser.add_argument("--out", default="out/valves")
    parser.add_argument("--rows", nargs="*", choices=ARMS, default=list(ARMS))
    parser.add_argument("--seed", type=int, help="default: the commit's hash")
    options = parser.parse_args()
    options.seed = seed_of_commit() if options.seed is None else options.seed
    print(f"seed {options.seed}; tip errors in cm, means over the runs\n")
    print("| valves | plans solved | predicted against executed, before the hold "
          "| replayed from set points | from measured pressures | ratio |\n|---|---|---|---|---|---|")
    for name in options.rows:
        row = Row(name, options)
        row.learn()
        print(line(name, row.execute()), flush=True)


main()
