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
import subprocess
import sys

import h5py
import numpy as np

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


def seed_of(commit, *names):
    """A seed that depends on the commit and on what it is for."""
    return random.Random(":".join([commit, *map(str, names)])).randrange(1, 2**31)


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


def matrices(q):
    """Rotations [n x 3 x 3] of quaternions x, y, z, w [n x 4]."""
    x, y, z, w = q.T
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                     2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                     2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=-1).reshape(-1, 3, 3)


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


class Episode:
    """What an imported recording holds: pressures or set points behind a lag, and gaps' coordinates."""

    def __init__(self, group):
        self.asked = group["setpoint_kpa"][()]
        poses = group["backbone"][()]
        valid = np.all(np.isfinite(poses.reshape(len(poses), -1)), axis=1)
        self.valid = valid if "tracked" not in group else valid & group["tracked"][()].astype(bool)
        self.poses = poses

    def gaps(self):
        """(d, omega) of every gap [n x gaps x 6]."""
        found = []
        for i in range(1, self.poses.shape[1]):
            r0, r1 = matrices(self.poses[:, i - 1, 3:]), matrices(self.poses[:, i, 3:])
            d = np.einsum("nji,nj->ni", r0, self.poses[:, i, :3] - self.poses[:, i - 1, :3])
            found.append(np.hstack([d, logarithm(np.einsum("nji,njk->nik", r0, r1))]))
        return np.stack(found, axis=1)


def logarithm(r):
    """Rotation vectors [n x 3]."""
    cosine = ((np.trace(r, axis1=1, axis2=2) - 1.0) / 2.0).clip(-1.0, 1.0)
    angle = np.arccos(cosine)
    axis = np.stack([r[:, 2, 1] - r[:, 1, 2], r[:, 0, 2] - r[:, 2, 0], r[:, 1, 0] - r[:, 0, 1]], axis=1)
    return axis * (0.5 / np.sinc(angle / np.pi))[:, None]


def exponential(omega):
    """Rotations, and the matrices that turn a length along x into a chord."""
    angle = np.linalg.norm(omega, axis=1)[:, None, None]
    k = np.zeros((len(omega), 3, 3))
    k[:, 2, 1], k[:, 0, 2], k[:, 1, 0] = omega.T
    k = k - np.swapaxes(k, 1, 2)
    safe = np.maximum(angle, 1e-6)
    a, b = (1 - np.cos(safe)) / safe**2, (safe - np.sin(safe)) / safe**3
    return np.eye(3) + np.sinc(angle / np.pi) * k + a * k @ k, np.eye(3) + a * k + b * k @ k


def places(gaps):
    """Plates [n x gaps x 3] of gaps' coordinates."""
    rotation, place, found = np.tile(np.eye(3), (len(gaps), 1, 1)), np.zeros((len(gaps), 3)), []
    for i in range(gaps.shape[1]):
        place = place + np.einsum("nij,nj->ni", rotation, gaps[:, i, :3])
        rotation = rotation @ exponential(gaps[:, i, 3:])[0]
        found.append(place)
    return np.stack(found, axis=1)


class ResidualModel:
    """Constant curvature behind dead time and lag, and a linear step of what it misses."""

    def __init__(self, episodes, rate_hz):
        self.rate_hz = rate_hz
        tries = [(self.fit_shapes(episodes, dead, share), dead, share)
                 for dead in range(0, 1 + round(0.4 * rate_hz)) for share in (0.15, 0.3, 0.5, 0.75, 1.0)]
        (_, self.shapes), self.dead, self.share = min(tries, key=lambda found: found[0][0])
        steps, answers = [], []
        for episode in episodes:
            residual, lagged = self.residual(episode)
            both = episode.valid[1:] & episode.valid[:-1]
            steps.append(self.terms(residual[:-1], lagged[1:], lagged[:-1])[both])
            answers.append(residual[1:][both])
        steps, answers = np.vstack(steps), np.vstack(answers)
        self.step = np.linalg.solve(steps.T @ steps + 1e-3 * np.eye(steps.shape[1]), steps.T @ answers)

    @staticmethod
    def terms(residual, now, before):
        return np.hstack([residual, now / 100.0, (now - before) / 10.0, np.ones((len(now), 1))])

    def lagged(self, asked, dead, share):
        late = np.vstack([np.repeat(asked[:1], dead, axis=0), asked])[:len(asked)]
        for t in range(1, len(late)):
            late[t] = late[t - 1] + share * (late[t] - late[t - 1])
        return late

    def fit_shapes(self, episodes, dead, share):
        terms, answers = [], []
        for episode in episodes:
            lagged = self.lagged(episode.asked, dead, share)[episode.valid]
            terms.append(np.hstack([lagged / 100.0, np.ones((len(lagged), 1))]))
            gaps = episode.gaps()[episode.valid]
            length = np.linalg.norm(gaps[:, :, :3], axis=2, keepdims=True)
            answers.append(np.concatenate([gaps[:, :, 4:], length], axis=2).reshape(len(gaps), -1))
        terms, answers = np.vstack(terms), np.vstack(answers)
        found = np.linalg.lstsq(terms, answers, rcond=None)[0]
        return np.square(terms @ found - answers).mean(), found

    def simple(self, lagged):
        """Gaps' coordinates [n x gaps x 6]."""
        shape = (np.hstack([lagged / 100.0, np.ones((len(lagged), 1))]) @ self.shapes).reshape(len(lagged), -1, 3)
        gaps = np.zeros((*shape.shape[:2], 6))
        gaps[:, :, 4:] = shape[:, :, :2]
        for i in range(shape.shape[1]):
            chord = exponential(gaps[:, i, 3:])[1][:, :, 0]
            gaps[:, i, :3] = chord * (shape[:, i, 2] / np.linalg.norm(chord, axis=1))[:, None]
        return gaps

    def residual(self, episode):
        lagged = self.lagged(episode.asked, self.dead, self.share)
        return (episode.gaps() - self.simple(lagged)).reshape(len(lagged), -1), lagged

    def errors_mm(self, episodes, frames=32):
        """Mean over plates and at the tip, over windows of so many frames that are never corrected."""
        plates, tips = [], []
        for episode in episodes:
            residual, lagged = self.residual(episode)
            simple = self.simple(lagged)
            for first in range(0, len(lagged) - frames - 1, frames):
                if not episode.valid[first]:
                    continue
                now, predicted = residual[first:first + 1], []
                for t in range(first + 1, first + 1 + frames):
                    now = self.terms(now, lagged[t:t + 1], lagged[t - 1:t]) @ self.step
                    predicted.append(now.reshape(-1, 6))
                span = slice(first + 1, first + 1 + frames)
                apart = places(simple[span] + np.array(predicted)) - episode.poses[span, 1:, :3]
                apart = 1e3 * np.linalg.norm(apart, axis=2)[episode.valid[span]]
                plates += apart.mean(axis=1).tolist()
                tips += apart[:, -1].tolist()
        return float(np.mean(plates)), float(np.mean(tips))


class StandIn:
    """One drawn arm of a kind in a folder of its own."""

    def __init__(self, options, kind, number):
        self.options, self.kind, self.number = options, kind, number
        self.folder = options.out / f"{kind}_{number}"
        self.folder.mkdir(parents=True, exist_ok=True)
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

    def limber(self, *arguments):
        command = [self.options.limber.resolve(), *map(str, arguments), "--json", "--force"]
        command += ["--jobs", str(self.options.jobs)]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, encoding="utf-8", check=False)
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}")
        return json.loads(done.stdout)

    def kept(self, name, make):
        """A part's JSON: read if it is there, else made and written."""
        path = self.folder / f"{name}.json"
        if not path.exists():
            found = make()
            path.write_text(json.dumps(found, indent=1), encoding="utf-8")
        return json.loads(path.read_text(encoding="utf-8"))

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
