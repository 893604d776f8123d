#!/usr/bin/env python3
"""What the default preset learns from other people's logs (docs/training.md), on virtual stand-ins.

    PYTHONPATH=build/release/python tools/stand_in_figures.py --limber build/release/bin/limber --out OUT

Eight arms are drawn by seed: three to five segments, friction 0.025 to 0.045, valve lags 0.3 to 0.6 s. Each
is logged for 40 trials of 30 s, 10 to 16 rows per second: rest, then a few slow moves in closed loop. No two
trials are alike: what a sensor says is another gain, offset and drift than what the bladders get, and the
segments' lengths creep. Noise is not white. In one trial the pressures are those of another. Eight more
trials are for testing. Then come the steps of docs/tutorial.md: import, characterize, train with the default
preset, evaluate. Asked of the network: 45 % less error over 32 frames than a grey box, and 25 % less over
whole trials.

How hard the logs are is measured like a real arm's: errors of simple models over what holding the pose errs
by in one step (part "ratios" of an arm; the real arm's in REAL).

At last, plans of each arm's first network that stay within what was recorded (--stay-recorded): how far from
a plan's end the networks of all other trainings end, when they get the plan's pressures.

All seeds derive from --hash (by default this commit's). Every part lies in OUT; parts that are finished
are not run again. --arms and --trainings N run a part: the first N trainings of each arm.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys

import numpy as np

import limber
from grey_box import GreyBox
from kept_parts import KeptParts, seed_of

ROOT = pathlib.Path(__file__).resolve().parents[1]
ARMS, TRAININGS = 8, 10
TRIALS, TEST_TRIALS, TRIAL_S = 40, 8, 30.0
ARM_LENGTH_M, GAPS, LIMIT_KPA = 0.7, 4, 90.0
GUESS_PER_KPA = 0.002  # contraction; of an owner without a bench test
LEVEL_KPA = 75.0  # of slow targets, at most
REST_S, MOVE_S, PAUSE_S = (1.0, 3.0), (4.0, 11.0), (0.0, 1.0)
CORRECTION_PER_S, CORRECTION_KPA = 0.4, 15.0  # of the closed loop
# How trials differ: the sensors' gain and offset, their drift in a root of a second, lengths, and how fast.
GAIN_SPREAD, OFFSET_KPA, DRIFT_KPA, CREEP, CREEP_S = 0.03, 3.0, 0.4, 0.01, 20.0
KPA_PER_PSI = 6.894757
NOISE_MM, NOISE_MEMORY, NOISE_PSI = 0.6, 0.4, 0.05
PLANS, ENVIRONMENTS, PLAN_QUERIES = 13, 30, 200_000  # of an arm: so many plans at most, of so many tries
END_CM, END_SHARE = 1.5, 0.95  # as near do the networks end to a plan's end, in this share of plans
HORIZONS = ("one_step", "window_32", "open_loop")
BARS = {"window_32": 45.0, "open_loop": 25.0}  # less than the grey box [%]
# Errors of the tip on a real planar arm [mm]: one step, 32 frames, whole trials.
REAL = {"hold": (2.1, 28.7, 110.0), "linear_one_step": (2.4, 21.3, 45.4), "grey_box": (5.0, 17.6, 19.5),
        "network": (2.7, 12.3, 17.1), "constant_velocity": (0.9, None, None)}


def arm_text(name, rate_hz, segments, rest=""):
    lines = ["schema: limber/arm/1", f"name: {name}", f"frame_rate_hz: {rate_hz:g}",
             "pressure_rate_limit_kpa_per_s: 60", "actuator_radius_m: 0.006", "segments:"]
    lines += [f"  - {{length_m: {length_m:.4f}, width_m: {width_m:.4f}, gaps: {GAPS}, "
              f"pressure_limit_kpa: {LIMIT_KPA:g}, strain_polynomial: [{GUESS_PER_KPA}, 0, 0, 0]}}"
              for length_m, width_m in segments]
    return "\n".join(lines) + "\n" + rest


def draw_arm(draw, number):
    """An arm as its owner describes it, as it is, and what was drawn."""
    count = 3 + number % 3
    widths = [0.05]
    while len(widths) < count:
        widths.append(max(0.0172, widths[-1] * draw.uniform(0.65, 0.95)))
    told = [(ARM_LENGTH_M / max(count, 4), width_m) for width_m in widths]
    true = [(length_m * draw.uniform(0.9, 1.1), width_m) for length_m, width_m in told]
    drawn = {"segments": count, "rate_hz": round(draw.uniform(10.0, 16.0), 2),
             "friction": round(draw.uniform(0.025, 0.045), 3), "lag_s": round(draw.uniform(0.3, 0.6), 3)}
    text = (ROOT / "arms" / "three_segment.yaml").read_text(encoding="utf-8")
    physics = text[text.index("virtual_arm:"):]
    for key, value in {"friction_coefficient": drawn["friction"],
                       "strength_seed": draw.randrange(1, 10_000),
                       "inflate_time_constant_s": drawn["lag_s"],
                       "vent_time_constant_s": 1.2 * drawn["lag_s"]}.items():
        physics, found = re.subn(rf"(\n  {key}:) \S+", rf"\1 {value:.6g}", physics)
        assert found == 1, key
    name = f"stand_in_{number}"
    return (arm_text(name, math.floor(drawn["rate_hz"]), told),
            arm_text(name, drawn["rate_hz"], true, physics), drawn)


class SlowTarget:
    """One segment's target [kPa]: rest, then smooth moves from level to level, with pauses."""

    def __init__(self, draw):
        self.draw = draw
        self.begin_s = 0.0
        self.end_s = self.next_s = draw.uniform(*REST_S)
        self.before = self.after = 0.0

    def at(self, time_s):
        if time_s >= self.next_s:
            self.before, self.after = self.after, self.draw.uniform(-LEVEL_KPA, LEVEL_KPA)
            self.begin_s, self.end_s = time_s, time_s + self.draw.uniform(*MOVE_S)
            self.next_s = self.end_s + self.draw.uniform(*PAUSE_S)
        part = min(1.0, (time_s - self.begin_s) / (self.end_s - self.begin_s))
        smooth = part**3 * (10.0 - 15.0 * part + 6.0 * part**2)
        return self.before + smooth * (self.after - self.before)


def with_lengths(plates, factors):
    """The backbone [m x 3] of segments whose lengths are so many times as large."""
    steps = np.diff(plates[:, :2], axis=0) * np.repeat(factors, GAPS)[:, None]
    return np.column_stack([np.vstack([plates[:1, :2], plates[0, :2] + np.cumsum(steps, axis=0)]),
                            plates[:, 2]])


def slow_trial(arm, told_gains, draw):
    """Times, pressures as sensors tell them [kPa] and plates; set points follow targets in closed loop."""
    virtual, count = limber.VirtualArm(arm), len(told_gains)
    targets = [SlowTarget(draw) for _ in told_gains]
    gain = np.array([draw.gauss(1.0, GAIN_SPREAD) for _ in told_gains])
    offset_kpa = np.array([draw.gauss(0.0, OFFSET_KPA) for _ in told_gains])
    creep_to = np.array([draw.gauss(0.0, CREEP) for _ in told_gains])
    corrections, creep = np.zeros(count), np.zeros(count)
    state, rows = virtual.state(), []
    period_s = 1.0 / arm.frame_rate_hz
    for frame in range(round(TRIAL_S * arm.frame_rate_hz)):
        heading = state.backbone[::GAPS, 2]
        seen = (heading[:-1] - heading[1:]) / told_gains  # positive bends right
        wanted = np.array([target.at(frame * period_s) for target in targets])
        corrections += CORRECTION_PER_S * period_s * (wanted - seen)
        corrections = corrections.clip(-CORRECTION_KPA, CORRECTION_KPA)
        offset_kpa += [draw.gauss(0.0, DRIFT_KPA * math.sqrt(period_s)) for _ in told_gains]
        setpoints = (gain * (wanted + corrections) + offset_kpa).clip(-LIMIT_KPA, LIMIT_KPA)
        state = virtual.command(setpoints.tolist())
        creep += period_s / CREEP_S * (creep_to - creep)
        rows.append(((frame + 1) * period_s, (np.array(state.pressure_kpa) - offset_kpa) / gain,
                     with_lengths(np.array(state.backbone, dtype=float), 1.0 + creep)))
    return rows


def write_log(path, rows, pressures, place, noise):
    """A trial as the laboratory logs it: psi by sides, markers in mm in the laboratory's frame."""
    count, seen = len(rows[0][1]), range(0, len(rows[0][2]), GAPS // 2)
    turn_rad, shift_x, shift_y = place
    cosine, sine = math.cos(turn_rad), math.sin(turn_rad)
    header = ["t"] + [f"{side}{i}" for i in range(count) for side in ("right", "left")]
    header += [f"{axis}{j}" for j in seen for axis in "xy"]
    new_mm = NOISE_MM * math.sqrt(1.0 - NOISE_MEMORY**2)
    off_mm = [noise.gauss(0.0, NOISE_MM) for _ in range(2 * len(seen))]
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file)
        table.writerow(header)
        for (time_s, _, plates), (_, told, _) in zip(rows, pressures):
            cells = [f"{time_s:.3f}"]
            for pressure_kpa in told:
                psi = pressure_kpa / KPA_PER_PSI
                cells += [f"{max(0.0, side) + noise.gauss(0.0, NOISE_PSI):.2f}" for side in (psi, -psi)]
            off_mm = [NOISE_MEMORY * off + noise.gauss(0.0, new_mm) for off in off_mm]
            for k, j in enumerate(seen):
                x, y = 1e3 * plates[j][0], 1e3 * plates[j][1]
                cells += [f"{cosine * x - sine * y + shift_x + off_mm[2 * k]:.1f}",
                          f"{sine * x + cosine * y + shift_y + off_mm[2 * k + 1]:.1f}"]
            table.writerow(cells)


def mapping_text(count):
    sides = {side: ", ".join(f"{side}{i}" for i in range(count)) for side in ("right", "left")}
    points = [f"    - {{plate: {j}, x: x{j}, y: y{j}}}" for j in range(0, GAPS * count + 1, GAPS // 2)]
    return "\n".join(["schema: limber/import/1", "time: {column: t, unit: s}",
                      "pressures:", "  unit: psi", f"  right: [{sides['right']}]",
                      f"  left: [{sides['left']}]",
                      "backbone:", "  unit: mm", "  points:", *points]) + "\n"


class StandIn(KeptParts):
    """One drawn arm in a folder of its own."""

    def __init__(self, options, number):
        self.options, self.number = options, number
        self.folder = options.out / f"arm_{number}"
        super().__init__(options.limber.resolve(), self.folder, cwd=self.folder)
        told, true, self.drawn = draw_arm(random.Random(seed_of(options.hash, "arm", number)), number)
        (self.folder / "arm.yaml").write_text(told, encoding="utf-8")
        (self.folder / "true.yaml").write_text(true, encoding="utf-8")
        (self.folder / "mapping.yaml").write_text(mapping_text(self.drawn["segments"]), encoding="utf-8")

    def limber(self, *arguments, codes=(0,)):
        return super().limber(*arguments, "--json", "--force", "--quiet", "--jobs", self.options.jobs, codes=codes)

    def write_logs(self):
        """Trials to learn from, of which one is broken, then those to test on."""
        arm = limber.load_arm(self.folder / "true.yaml")
        told = limber.load_arm(self.folder / "arm.yaml")
        gains = np.array([GUESS_PER_KPA * segment.length_m / segment.width_m
                          for segment in told.segments])
        (self.folder / "logs").mkdir(exist_ok=True)
        draw = random.Random(seed_of(self.options.hash, "logs", self.number))
        place = (draw.uniform(-3.0, 3.0), draw.uniform(-500.0, 500.0), draw.uniform(-500.0, 500.0))
        broken = draw.randrange(1, TRIALS)
        before = None
        for trial in range(TRIALS + TEST_TRIALS):
            rows = slow_trial(arm, gains, draw)
            path = self.folder / "logs" / f"trial_{trial:02}.csv"
            write_log(path, rows, before if trial == broken else rows, place, draw)
            before = rows
        return {**self.drawn, "broken": broken}

    def import_logs(self):
        """train.h5 and test.h5; what import named as broken."""
        logs = [f"logs/trial_{trial:02}.csv" for trial in range(TRIALS + TEST_TRIALS)]
        flags = ["--mapping", "mapping.yaml", "--arm", "arm.yaml"]
        named = self.limber("import", "csv", *logs[:TRIALS], *flags, "--out", "train.h5")
        self.limber("import", "csv", *logs[TRIALS:], *flags, "--out", "test.h5")
        self.limber("characterize", "--arm", "arm.yaml", "--recording", "train.h5", "--out",
                    "fitted.yaml")
        return {"named_broken": named["episode_errors"]["outliers"]}

    def grey_box(self):
        train, test = (limber.read_recording(self.folder / name).episodes for name in ("train.h5", "test.h5"))
        broken = self.kept("imported", self.import_logs)["named_broken"]
        return GreyBox([e for i, e in enumerate(train) if i not in broken], GAPS).errors_cm(test)

    def true_arm(self):
        """The arm itself without valves, which gets the pressures that the sensors told: what no model of
        a whole trial beats, since a trial's offsets, gains and lengths are not known."""
        text = (self.folder / "true.yaml").read_text(encoding="utf-8")
        told = limber.load_arm(self.folder / "arm.yaml")
        for key, value in {"inflate_time_constant_s": 1e-3, "vent_time_constant_s": 1e-3,
                           "frame_rate_hz": told.frame_rate_hz, "pressure_rate_limit_kpa_per_s": 2000}.items():
            text = re.sub(rf"(\b{key}:) \S+", rf"\1 {value:g}", text)
        path = self.folder / "without_valves.yaml"
        path.write_text(text, encoding="utf-8")
        arm, apart = limber.load_arm(path), []
        for episode in limber.read_recording(self.folder / "test.h5").episodes:
            virtual = limber.VirtualArm(arm)
            tips = [virtual.command(row.clip(-LIMIT_KPA, LIMIT_KPA).tolist()).backbone[-1][:2]
                    for row in np.asarray(episode.pressure_kpa, dtype=float)]
            apart += np.hypot(*(np.array(tips) - episode.backbone[:, -1, :2])[1:].T).tolist()
        return {"open_loop": {"position_error_cm": {"mean": 100.0 * float(np.mean(apart))}}}

    def train(self, number):
        """A training, and its errors on the test beside those of the yardsticks."""
        model = f"model_{number}.safetensors"
        seed = seed_of(self.options.hash, "training", self.number, number)
        trained = self.limber("train", "--arm", "fitted.yaml", "--data", "train.h5", "--seed", seed,
                              *self.options.train, "--out", model)
        errors = self.limber("evaluate", "--arm", "fitted.yaml", "--model", model, "--data", "test.h5",
                             "--fit", "train.h5")
        rollouts = [trained["long_rollout"], errors["long_rollout"]]
        found = {"seed": seed, "epochs": trained["epochs"], "best_epoch": trained["best_epoch"],
                 "passed_over_epochs": trained["passed_over_epochs"],
                 "wall_time_s": trained["wall_time_s"], "novel_frames": errors["novel_frames"],
                 "bounded": all(rollout["bounded"] for rollout in rollouts),
                 "held_share": max(rollout["held_share"] for rollout in rollouts)}
        models = {"network": errors["network"], "no_load": errors["no_load"], **errors["baselines"],
                  "grey_box": self.kept("grey_box", self.grey_box),
                  "true_arm": self.kept("true_arm", self.true_arm)}
        for name, by_horizon in models.items():
            found[name] = {horizon: error["position_error_cm"]["mean"]
                           for horizon, error in by_horizon.items() if error}
        return found

    def ends_cm(self, trainings):
        """Of each plan of the first network: how far from its end the farthest of the others ends."""
        if trainings < 2:
            return []
        of_first = ["--arm", "fitted.yaml", "--model", "model_0.safetensors"]
        self.limber("environment", "--random", "--witness", "model", *of_first, "--count", ENVIRONMENTS, "--seed",
                    seed_of(self.options.hash, "environments", self.number), "--out", "environments")
        arm = limber.load_arm(self.folder / "fitted.yaml")
        others = [limber.ForwardModel(arm, limber.read_model(self.folder / f"model_{number}.safetensors"))
                  for number in range(1, trainings)]
        found = []
        for path in sorted((self.folder / "environments").glob("*.yaml")):
            if len(found) == PLANS:
                break
            done = self.limber("plan", *of_first, "--no-valves", "--stay-recorded", "--environment", path,
                               "--max-queries", PLAN_QUERIES, "--out", "plan.json", codes=(0, 1, 2))
            if done["status"] == "solved":
                plan = limber.read_plan(self.folder / "plan.json")
                ends = [other.rollout(plan.pressure_kpa, plan.backbone[0])[-1, -1, :2] for other in others]
                found.append(100.0 * max(float(math.dist(end, plan.backbone[-1, -1, :2])) for end in ends))
        return found


def less_than_grey_box(trained, horizon):
    """By how much the network's error is smaller [%]."""
    return 100.0 * (1.0 - trained["network"][horizon] / trained["grey_box"][horizon])


def ratios(trained):
    """Errors over what holding the pose errs by in one step: this arm's and, mean over all, the real arm's."""
    unit = trained["hold"]["one_step"]
    return {name: [round(trained[name][horizon] / unit, 2) for horizon in HORIZONS if trained[name].get(horizon)]
            for name in REAL}


def summary(arm, trainings):
    """One arm's line: errors, and how many trainings pass each bar."""
    line = {"arm": arm.number, **arm.kept("logs", arm.write_logs),
            **arm.kept("imported", arm.import_logs), "trainings": len(trainings),
            "runaways": sum(not trained["bounded"] for trained in trainings), "ratios": ratios(trainings[0])}
    for horizon in HORIZONS:
        line[f"{horizon} mm, network"] = [round(10 * t["network"][horizon], 2) for t in trainings]
        line[f"{horizon} mm, grey box"] = round(10 * trainings[0]["grey_box"][horizon], 2)
    line["open_loop mm, the arm itself"] = round(10 * trainings[0]["true_arm"]["open_loop"], 2)
    for horizon, bar in BARS.items():
        gains = [less_than_grey_box(trained, horizon) for trained in trainings]
        line[f"{horizon}: less than the grey box [%]"] = [round(gain, 1) for gain in gains]
        line[f"pass {bar:g} %"] = sum(gain >= bar for gain in gains)
    ends_cm = arm.kept(f"ends_{len(trainings)}", lambda: arm.ends_cm(len(trainings)))
    line["ends of plans, cm"] = [round(end_cm, 2) for end_cm in ends_cm]
    return line


def mean_ratios(lines):
    """Over all arms, beside the real arm's."""
    return {name: {"here": np.round(np.mean([line["ratios"][name] for line in lines], axis=0), 2).tolist(),
                   "real": [value and round(value / REAL["hold"][0], 2) for value in values]}
            for name, values in REAL.items()}


def same_hash(options):
    """Seeds of parts that lie there already are those of this run, or the run is refused."""
    options.out.mkdir(parents=True, exist_ok=True)
    path = options.out / "hash.txt"
    if path.exists() and path.read_text(encoding="utf-8") != options.hash:
        sys.exit(f"{path}: parts were drawn by {path.read_text(encoding='utf-8')}; give it as --hash")
    path.write_text(options.hash, encoding="utf-8")


def read_options():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", type=pathlib.Path, default=ROOT / "build/release/bin/limber")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--hash", help="what all seeds derive from; this commit's where left out")
    parser.add_argument("--arms", type=int, nargs="+", default=list(range(ARMS)))
    parser.add_argument("--trainings", type=int, default=TRAININGS, help="of each arm")
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("train", nargs="*", help="after --: flags for train")
    options = parser.parse_args()
    if not options.hash:
        options.hash = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, check=True,
                                      capture_output=True, encoding="utf-8").stdout.strip()
    return options


def main():
    options = read_options()
    same_hash(options)
    arms = [StandIn(options, number) for number in options.arms]
    for training in range(options.trainings):  # all arms once, then all of them again
        for arm in arms:
            arm.kept("logs", arm.write_logs)
            arm.kept("imported", arm.import_logs)
            arm.kept(f"training_{training}", lambda: arm.train(training))
            print(f"arm {arm.number}, training {training}", file=sys.stderr, flush=True)
    lines = [summary(arm, [arm.kept(f"training_{i}", None) for i in range(options.trainings)])
             for arm in arms]
    (options.out / "figures.json").write_text(json.dumps(lines, indent=1), encoding="utf-8")
    print(json.dumps(lines, indent=1))
    print(json.dumps(mean_ratios(lines), indent=1))
    ends_cm = sum((line["ends of plans, cm"] for line in lines), [])
    near = sum(end_cm <= END_CM for end_cm in ends_cm)
    print(f"ends of {len(ends_cm)} plans by {options.trainings} networks: {near} within {END_CM} cm")
    passed = all(line[f"pass {bar:g} %"] == line["trainings"] for line in lines for bar in BARS.values())
    passed &= not any(line["runaways"] for line in lines) and (options.trainings < 2 or bool(ends_cm))
    return 0 if passed and near >= END_SHARE * len(ends_cm) else 1


if __name__ == "__main__":
    sys.exit(main())
