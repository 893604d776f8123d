#!/usr/bin/env python3
"""What the default preset learns from logs of arms in space (docs/space.md), on virtual stand-ins of public ones.

    tools/space_stand_ins.py --limber build/release/bin/limber --out OUT

Three kinds, each of as many arms as asked, drawn by seed:

    trunk    three sections, 20 Hz, plates at their ends with quaternions; 41 minutes, of which the last fifth
             tests; another run, and one with a load at the tip, on which nothing is trained
    modules  two modules, 5 Hz, Euler angles; two of three runs (random, plateaus, ramps) train, the third tests
    tip      three sections of which the tip alone is tracked, with stamps of its own; its last fifth tests

Logs are as real ones: set points alone, 0.2 s of dead time and a lag behind them, friction, creep, noise,
quaternions that change sign, bodies that flip, rows that repeat the one before, clocks that are nominal. Then
come the steps of docs/space.md: import, characterize, train with the default preset, evaluate.

Before the network is looked at, the logs have to be as hard as real ones: errors over 32 frames of a linear
step and of constant curvature with a linear residual, over those of constant curvature (part "ratios").

All seeds derive from --hash. Every part lies in OUT; parts that are finished are not run again.
"""

import argparse
import csv
import json
import pathlib
import random
import re

import h5py
import numpy as np

from kept_parts import KeptParts, seed_of
from space_residual_model import Episode, ResidualModel, matrices

ROOT = pathlib.Path(__file__).resolve().parents[1]
DEAD_TIME_S, LAG_S = (0.15, 0.2), (0.04, 0.12)
FRICTION, HYSTERESIS, CREEP = (1.3, 1.7), (1.3, 1.7), (0.02, 0.06)  # the first two times the shipped arm's
LIMIT_SCALE = {"trunk": 0.5, "modules": 0.8, "tip": 0.5}
NOISE_M, FLIP_SHARE, REPEAT_SHARE = 0.0004, 0.004, 0.02
LOAD_KG = 0.2
# Minutes, seconds that set points stand, and how they get there, of each run.
RUNS = {"random": (12.0, 0.2, 2.0, "step"), "plateau": (12.0, 2.0, 5.0, "step"),
        "ramps": (12.0, 0.05, 0.3, "straight")}
KINDS = {"trunk": ("hanging_3x3", 20), "modules": ("hanging_3x2", 5), "tip": ("hanging_3x3", 10)}
# Real logs' errors of plates (tip) over 32 frames, in those of constant curvature.
REAL = {"linear": (6.4 / 5.5, 13.0 / 8.8), "residual": (4.5 / 5.5, 7.7 / 8.8)}


def true_arm(shipped, rate_hz, draw):
    """The arm as it is, and what was drawn."""
    text = (ROOT / "arms" / f"{shipped}.yaml").read_text(encoding="utf-8")
    lag_s = round(draw.uniform(*LAG_S), 3)
    drawn = {"valve_dead_time_s": round(draw.uniform(*DEAD_TIME_S), 3), "inflate_time_constant_s": lag_s,
             "vent_time_constant_s": lag_s, "strength_seed": draw.randrange(1, 10_000),
             "creep_fraction": round(draw.uniform(*CREEP), 3)}
    for key, factors in {"joint_friction_n_m": FRICTION, "hysteresis_fraction": HYSTERESIS}.items():
        usual = float(re.search(rf"\n  {key}: (\S+)", text).group(1))
        drawn[key] = round(usual * draw.uniform(*factors), 4)
    for key, value in drawn.items():
        text = re.sub(rf"\n  {key}: [^\n]*", "", text) + f"  {key}: {value}\n"
    return re.sub(r"frame_rate_hz: \S+", f"frame_rate_hz: {rate_hz}", text), drawn


def told_arm(true_text, kind, rate_hz):
    """The arm as its owner describes it: plates that are tracked, chambers that do what is not known."""
    lengths = [float(x) for x in re.findall(r"length_m: ([\d.]+)", true_text)]
    count = len(re.findall(r"angle_deg: ", true_text))
    if kind == "tip":
        lengths = [sum(lengths)]
    lines = ["schema: limber/arm/1", f"name: stand_in_{kind}", "dimension: 3", f"frame_rate_hz: {rate_hz}",
             "pressure_rate_limit_kpa_per_s: 400", "actuator_radius_m: 0.006", "gravity: [1, 0, 0]",
             "no_load: straight", "segments:"]
    for length_m in lengths:
        lines += [f"  - length_m: {length_m:.4f}", "    width_m: 0.05", "    gaps: 1", "    chambers:"]
        lines += ["      - {pressure_limit_kpa: [0, 100]}"] * (count // len(lengths))
    return "\n".join(lines) + "\n"


def mapping_text(kind, rate_hz, plates, chambers):
    """The log hangs along -z of the laboratory."""
    rows = {"trunk": "qx: qx{0}, qy: qy{0}, qz: qz{0}, qw: qw{0}",
            "modules": "euler: [r{0}, s{0}, t{0}]"}.get(kind, "")
    points = [f"    - {{plate: {i + 1}, x: x{i}, y: y{i}, z: z{i}{', ' + rows.format(i) if rows else ''}}}"
              for i in range(plates)]
    lines = ["schema: limber/import/1", "time: {column: t}" if kind == "tip" else f"time: {{rate_hz: {rate_hz}}}",
             "pressures:", f"  setpoints: [{', '.join(f'u{k}' for k in range(chambers))}]", "backbone:"]
    lines += ["  euler: {order: zyx, unit: deg}"] if kind == "modules" else []
    lines += ["  points:", *points, "alignment: {position_m: [0, 0, 0.9], x_axis: [0, 0, -1], y_axis: [0, 1, 0]}"]
    return "\n".join(lines) + "\n"


# The laboratory's axes in limber's columns: limber's x hangs along -z, its y is the laboratory's.
TO_LABORATORY = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])


def product(a, b):
    """Quaternions a * b, both [n x 4] or [4]."""
    ax, ay, az, aw = np.moveaxis(a, -1, 0)
    bx, by, bz, bw = np.moveaxis(b, -1, 0)
    return np.stack([aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                     aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz], axis=-1)


def write_log(path, kind, recording, seen, noise):
    """An episode as a laboratory logs it."""
    with h5py.File(recording) as file:
        group = file["episodes"]["000000"]
        time_s, poses, asked = (group[k][()] for k in ("time_s", "backbone", "setpoint_kpa"))
    turn = np.array([0.0, np.sin(np.pi / 4), 0.0, np.cos(np.pi / 4)])  # TO_LABORATORY
    back = turn * np.array([-1.0, -1.0, -1.0, 1.0])
    random_rows = np.random.default_rng(noise)
    columns, header = [], []
    stamp = time_s + random_rows.uniform(0.0, 0.004, len(time_s))
    for i, plate in enumerate(seen):
        place = poses[:, plate, :3] @ TO_LABORATORY.T + [0.0, 0.0, 0.9]
        columns.append(place + random_rows.normal(0.0, NOISE_M, place.shape))
        header += [f"{axis}{i}" for axis in "xyz"]
        turned = product(product(turn, poses[:, plate, 3:]), back)
        if kind == "trunk":
            flipped = random_rows.random(len(turned)) < FLIP_SHARE
            turned[flipped] = product(turned[flipped], np.array([1.0, 0.0, 0.0, 0.0]))  # half a turn
            columns.append(turned * np.sign(random_rows.random((len(turned), 1)) - 0.3))
            header += [f"q{axis}{i}" for axis in "xyzw"]
        elif kind == "modules":
            r = matrices(turned)
            angles = [np.arctan2(r[:, 1, 0], r[:, 0, 0]), -np.arcsin(r[:, 2, 0].clip(-1, 1)),
                      np.arctan2(r[:, 2, 1], r[:, 2, 2])]
            columns.append(np.degrees(np.stack(angles, axis=1)))
            header += [f"{name}{i}" for name in "rst"]
    table = np.hstack([stamp[:, None], asked, *columns])
    header = ["t", *[f"u{k}" for k in range(asked.shape[1])], *header]
    repeated = 1 + np.flatnonzero(random_rows.random(len(table) - 1) < REPEAT_SHARE)
    if kind == "trunk":  # the tracker hangs for a row
        table[repeated, 1 + asked.shape[1]:] = table[repeated - 1, 1 + asked.shape[1]:]
    with open(path, "w", encoding="utf-8", newline="") as file:
        out = csv.writer(file)
        out.writerow(header)
        out.writerows([[f"{value:.6g}" for value in row] for row in table])


class StandIn(KeptParts):
    """One drawn arm of a kind in a folder of its own."""

    def __init__(self, options, kind, number):
        self.options, self.kind, self.number = options, kind, number
        self.folder = options.out / f"{kind}_{number}"
        super().__init__(options.limber.resolve(), self.folder, cwd=self.folder)
        shipped, self.rate_hz = KINDS[kind]
        true, self.drawn = true_arm(shipped, self.rate_hz, random.Random(seed_of(options.hash, kind, number)))
        told = told_arm(true, kind, self.rate_hz)
        (self.folder / "true.yaml").write_text(true, encoding="utf-8")
        (self.folder / "loaded.yaml").write_text(true + f"  tip_load_kg: {LOAD_KG}\n", encoding="utf-8")
        (self.folder / "arm.yaml").write_text(told, encoding="utf-8")
        gaps = [int(x) for x in re.findall(r"gaps: (\d+)", true)]
        self.seen = np.cumsum(gaps).tolist()[-1:] if kind == "tip" else np.cumsum(gaps).tolist()
        (self.folder / "mapping.yaml").write_text(
            mapping_text(kind, self.rate_hz, len(self.seen), len(re.findall(r"angle_deg: ", true))), encoding="utf-8")

    def limber(self, *arguments, codes=(0,)):
        return super().limber(*arguments, "--json", "--force", "--quiet", "--jobs", self.options.jobs, codes=codes)

    def log(self, name, minutes, hold_min_s, hold_s, approach, arm="true.yaml"):
        """A run of so many minutes, as a CSV log and imported."""
        motion_s = (hold_min_s + hold_s) / 2.0 + (0.03 if approach == "step" else 0.4)
        seed = seed_of(self.options.hash, self.kind, self.number, name)
        self.limber("collect", "--arm", arm, "--schedule", "random", "--count", max(2, round(60 * minutes * self.options.share / motion_s)),
                    "--hold-s", hold_s, "--hold-min-s", hold_min_s, "--approach", approach, "--limit-scale",
                    LIMIT_SCALE[self.kind], "--seed", seed, "--out", f"{name}_all.h5")
        write_log(self.folder / f"{name}.csv", self.kind, self.folder / f"{name}_all.h5", self.seen, seed)
        (self.folder / f"{name}_all.h5").unlink()

    def split(self, name):
        """The last fifth of a log is a log of its own."""
        rows = (self.folder / f"{name}.csv").read_text(encoding="utf-8").splitlines()
        cut = 1 + (len(rows) - 1) * 4 // 5
        (self.folder / f"{name}_first.csv").write_text("\n".join(rows[:cut]) + "\n", encoding="utf-8")
        (self.folder / f"{name}_last.csv").write_text("\n".join([rows[0], *rows[cut:]]) + "\n", encoding="utf-8")

    def make_logs(self):
        """What trains and tests: a list of (training logs, {test: log})."""
        if self.kind == "modules":
            for name, run in RUNS.items():
                self.log(name, *run)
            return [([other for other in RUNS if other != name], {name: name}) for name in RUNS]
        self.log("run", 41.0, 0.2, 2.0, "step")
        self.split("run")
        tests = {"last_fifth": "run_last"}
        if self.kind == "trunk":
            self.log("other", 5.0, 0.5, 2.0, "step")
            self.log("load", 5.0, 0.2, 2.0, "step", "loaded.yaml")
            tests |= {"another_run": "other", "load": "load"}
        return [(["run_first"], tests)]

    def import_logs(self):
        sets = self.kept("logs", self.make_logs)
        for i, (logs, tests) in enumerate(sets):
            for out, names in {f"train_{i}": logs, **{f"test_{i}_{test}": [log] for test, log in tests.items()}}.items():
                self.limber("import", "csv", *[f"{name}.csv" for name in names], "--mapping", "mapping.yaml", "--arm",
                            "arm.yaml", "--out", f"{out}.h5")
            self.limber("characterize", "--arm", "arm.yaml", "--recording", f"train_{i}.h5", "--out", f"fitted_{i}.yaml")
        return {"sets": len(sets)}

    def episodes(self, name):
        with h5py.File(self.folder / f"{name}.h5") as file:
            return [Episode(group) for group in file["episodes"].values()]

    def yardsticks(self):
        """Errors over 32 frames of plates and tip, of every test."""
        found = {}
        for i, (_, tests) in enumerate(self.kept("logs", None)):
            residual = ResidualModel(self.episodes(f"train_{i}"), self.rate_hz)
            for test in tests:
                errors = self.limber("evaluate", "--arm", "arm.yaml", "--data", f"test_{i}_{test}.h5", "--fit",
                                     f"train_{i}.h5")
                found[test] = {**{name: error["window_32"] and plates_and_tip(error["window_32"])
                                  for name, error in errors["baselines"].items()},
                               "residual": residual.errors_mm(self.episodes(f"test_{i}_{test}"))}
        return found

    def train(self, number):
        found = {}
        for i, (_, tests) in enumerate(self.kept("logs", None)):
            seed, model = seed_of(self.options.hash, "training", self.kind, self.number, number), f"model_{i}.safetensors"
            arm = f"fitted_{i}.yaml"
            trained = self.limber("train", "--arm", arm, "--data", f"train_{i}.h5", "--seed", seed,
                                  *self.options.train, "--out", model)
            for test in tests:
                errors = self.limber("evaluate", "--arm", arm, "--model", model, "--data",
                                     f"test_{i}_{test}.h5", "--fit", f"train_{i}.h5")
                found[test] = {"window_32": plates_and_tip(errors["network"]["window_32"]),
                               "open_loop": plates_and_tip(errors["network"]["open_loop"]),
                               "epochs": trained["epochs"], "wall_time_s": trained["wall_time_s"]}
        return found


def plates_and_tip(error):
    return [10.0 * error["plates_error_cm"]["mean"], 10.0 * error["position_error_cm"]["mean"]]


def table(stand_in, trainings):
    """A line for each test."""
    for test, errors in stand_in.kept("yardsticks", stand_in.yardsticks).items():
        networks = [training[test]["window_32"] for training in trainings]
        simple = {name: value for name, value in errors.items() if value}
        best = min(value[0] for value in simple.values())
        curvature = simple["simple_model"]
        yield {"arm": f"{stand_in.kind}_{stand_in.number}", "test": test,
               **{name: np.round(value, 1).tolist() for name, value in simple.items()},
               "ratios": {name: np.round(np.array(simple[key]) / curvature, 2).tolist()
                          for name, key in {"linear": "linear_one_step", "residual": "residual"}.items()},
               "network": [np.round(value, 1).tolist() for value in networks],
               "network / best": [round(value[0] / best, 2) for value in networks],
               "train_s": [round(training[test]["wall_time_s"]) for training in trainings]}


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", type=pathlib.Path, default=ROOT / "build/release/bin/limber")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--hash", required=True, help="what all seeds derive from")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS))
    parser.add_argument("--arms", type=int, nargs="+", default=[0, 1], help="of each kind, by number")
    parser.add_argument("--trainings", type=int, default=5, help="of each arm")
    parser.add_argument("--share", type=float, default=1.0, help="of the logs' minutes, for a quick look")
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("train", nargs="*", help="after --: flags for train")
    return parser.parse_args()


def main():
    options = read_options()
    for kind in options.kinds:
        for number in options.arms:
            stand_in = StandIn(options, kind, number)
            stand_in.kept("logs", stand_in.make_logs)
            stand_in.kept("imported", stand_in.import_logs)
            stand_in.kept("yardsticks", stand_in.yardsticks)
            trainings = [stand_in.kept(f"training_{i}", lambda i=i: stand_in.train(i))
                         for i in range(options.trainings)]
            for line in table(stand_in, trainings):
                print(json.dumps(line), flush=True)


if __name__ == "__main__":
    main()
