#!/usr/bin/env python3
"""Measures the table of accuracy in docs/training.md, row by row.

    tools/accuracy_figures.py --limber build/release/bin/limber --out out/accuracy
    tools/accuracy_figures.py --out out/accuracy --rows best_2h paper   some rows alone
    tools/accuracy_figures.py --out out/accuracy --print                the table of what is there

Recordings, models and results that are there already are not made again. OUT/figures.json holds
every number; tools/error_over_hours draws error over arm time from it.
"""

import argparse
import json
import pathlib
import subprocess
import sys

# Recordings to learn from: arm, seed, flags of `limber collect`.
SHORT = ["--schedule", "random", "--hold-s", "2", "--hold-min-s", "0.2", "--count", "60"]
STRAIGHT = ["--schedule", "random", "--approach", "straight", "--hold-s", "1.5"]
STRAIGHT += ["--hold-min-s", "0.05", "--count", "50"]
RECORDINGS = {
    "transitions": ("three_segment", 11, ["--schedule", "transitions"]),
    "short_24min": ("three_segment", 25, [*SHORT, "--episodes", "21"]),
    "short_1.4h": ("three_segment", 21, [*SHORT, "--episodes", "76"]),
    "random_2h": ("three_segment", 12, ["--schedule", "random", "--count", "60", "--episodes", "40"]),
    "straight_46min": ("three_segment", 13, [*STRAIGHT, "--episodes", "30"]),
    "short_5h": ("three_segment", 24, [*SHORT, "--episodes", "284"]),
    "two_transitions": ("two_segment", 11, ["--schedule", "transitions"]),
    "two_short": ("two_segment", 21, [*SHORT, "--episodes", "50"]),
    "five_transitions": ("five_segment", 11, ["--schedule", "transitions", "--count", "243"]),
    "five_short": ("five_segment", 21, [*SHORT, "--episodes", "44"]),
}
# Chooses the epoch in rows that learn from more than the transitions; never tested on.
VALIDATION = ["--schedule", "random", "--count", "60", "--seed", "992"]
TEST = ["--schedule", "random", "--count", "100"]

TWO_HOURS = ["transitions", "short_1.4h"]
FIVE_HOURS = [*TWO_HOURS, "random_2h", "straight_46min"]
# Rows: flags of `limber train`, arm, recordings, epochs (None: the preset's), seeds, whether it is on
# the curve. Epochs and windows were chosen by a recording that is neither learnt from nor tested on.
BEST = ["--preset", "best"]
WINDOWS_OF_32 = [*BEST, "--windows", "32"]
ROWS = {
    "paper": (["--preset", "paper"], "three_segment", ["transitions"], None, [1], False),
    "best_0.6h": (BEST, "three_segment", ["transitions"], 100, [1, 2, 3], False),
    "best_2h": (BEST, "three_segment", TWO_HOURS, 1000, [1, 2, 3], True),
    "best_10h": (BEST, "three_segment", [*FIVE_HOURS, "short_5h"], 300, [1, 2, 3], True),
    "windows32_0.6h": (WINDOWS_OF_32, "three_segment", ["transitions"], 100, [1, 2, 3], True),
    "best_1h": (BEST, "three_segment", ["transitions", "short_24min"], 500, [1], True),
    "best_5h": (BEST, "three_segment", FIVE_HOURS, 400, [1], True),
    "two_segment": (BEST, "two_segment", ["two_transitions", "two_short"], 300, [1], False),
    "five_segment": (BEST, "five_segment", ["five_transitions", "five_short"], 300, [1], False),
}
FIRST_TEST_SEED = 90_000  # of seed 1; drawn for this table and opened for nothing else


class Runner:
    def __init__(self, options):
        self.limber = options.limber
        self.out = pathlib.Path(options.out)
        self.jobs = ["--jobs", str(options.jobs)]
        self.out.mkdir(parents=True, exist_ok=True)

    def json_of(self, verb, *flags):
        command = [self.limber, verb, *map(str, flags), *self.jobs, "--json"]
        print("+", *command, file=sys.stderr)
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{verb} ended with {done.returncode}: {done.stdout}")
        return json.loads(done.stdout)

    def recording(self, name, arm, flags, seed=None):
        path = self.out / f"{name}.h5"
        if not path.exists():
            chance = [] if seed is None else ["--seed", seed]
            resume = ["--resume"] if pathlib.Path(f"{path}.parts").exists() else []
            self.json_of("collect", "--arm", arm, *flags, *chance, "--out", path, *resume)
        return path

    def duration_h(self, path):
        return self.json_of("inspect", path)["duration_s"] / 3600

    def row(self, name, seed):
        preset_flags, arm, recordings, epochs, _, curve = ROWS[name]
        label = f"{name}_seed{seed}"
        result = self.out / f"{label}.json"
        if result.exists():
            return json.loads(result.read_text())
        paths = []
        for recording in recordings:
            of_arm, collect_seed, flags = RECORDINGS[recording]
            paths.append(self.recording(recording, of_arm, flags, collect_seed))
        model = self.out / f"{label}.safetensors"
        flags = ["--arm", arm, *preset_flags, "--seed", seed, "--out", model]
        for path in paths:
            flags += ["--data", path]
        if epochs is not None:
            flags += ["--epochs", epochs]
        if len(recordings) > 1:  # with the transitions alone, some of them are held back
            flags += ["--validation", self.recording(f"{arm}_validation", arm, VALIDATION)]
        if pathlib.Path(f"{model}.checkpoint").exists():
            flags += ["--resume"]
        trained = self.json_of("train", *flags, "--force")
        test = self.recording(f"{arm}_test{seed}", arm, TEST, FIRST_TEST_SEED + seed)
        found = self.json_of("evaluate", "--arm", arm, "--model", model, "--data", test)
        found.update(
            row=name,
            seed=seed,
            arm=arm,
            curve=curve,
            hours=round(sum(self.duration_h(path) for path in paths), 2),
            epochs=trained["epochs"],
            training_s=trained["wall_time_s"],
        )
        result.write_text(json.dumps(found, indent=1) + "\n")
        return found


def table(rows):
    lines = [
        "| row | seed | hours | epochs | one step (moving) | 32 frames | per motion | open loop "
        "| 95 % below, worst motion | 20 000 frames | training |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        network = row["network"]

        def both(kind, digits=2):
            error = network[kind]
            position = error["position_error_cm"]["mean"]
            return f"{position:.{digits}f} cm, {error['orientation_error_rad']['mean']:.3f} rad"

        tail = network["open_loop"]["position_error_cm"]
        moving = network["one_step_moving"]["position_error_cm"]["mean"]
        lines.append(
            f"| {row['row']} | {row['seed']} | {row['hours']:.1f} | {row['epochs']} "
            f"| {both('one_step')} ({moving:.2f} cm) | {both('window_32')} | {both('per_motion')} "
            f"| {both('open_loop')} | {tail['p95']:.1f}, {tail['worst_motion']:.1f} cm "
            f"| {'bounded' if row['long_rollout']['bounded'] else 'not bounded'} "
            f"| {row['training_s']:.0f} s |"
        )
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", default="build/release/bin/limber")
    parser.add_argument("--out", default="out/accuracy")
    parser.add_argument("--rows", nargs="*", choices=ROWS, default=list(ROWS))
    parser.add_argument("--seeds", nargs="*", type=int, help="of those that a row has")
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("--print", action="store_true", help="only what is there already")
    options = parser.parse_args()
    runner = Runner(options)
    rows = []
    for name in options.rows:
        for seed in ROWS[name][4]:
            if options.seeds and seed not in options.seeds:
                continue
            if options.print and not (runner.out / f"{name}_seed{seed}.json").exists():
                continue
            rows.append(runner.row(name, seed))
    (runner.out / "figures.json").write_text(json.dumps({"rows": rows}, indent=1) + "\n")
    print(table(rows))


main()
