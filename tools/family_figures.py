#!/usr/bin/env python3
"""Figures of docs/families.md: what a minute of motion makes of a family, on arms it has not seen.

    PYTHONPATH=build/release/python tools/family_figures.py --family F.safetensors --out OUT

Parts, each kept in OUT and not measured twice:
  open    virtual arms of --vary-physics 1.5 and wide: mean tip error over the next 100 s, open loop, after
          0, 20 and 60 s, and of a network trained on the same minute from nothing
  arms    the nominal arm, friction 30 % more and less, 50 g at the tip, a side 20 % weaker: the same, and
          plans in limber's own eight environments, executed open loop
  unseen  plans on unseen arms, each in random environments that the arm itself has moved through: executed open
          loop, and in closed loop
  traits  what a minute tells of an arm's physics beside what it is: friction, load, the table's fall, …
  tube    coverage of the family's tube on unseen arms, ten plans each in random environments
  stranger  arms that no family holds, as another simulator has them: other tension curves, strengths, friction
          and valves; 60 s and five minutes
"""

import argparse
import json
import pathlib
import re
import sys

import numpy as np

import limber
from kept_parts import KeptParts

MOTIONS_OF_100_S = 30
# A seed gives arm and motions alike. By so many motions the minute's random numbers are spent: only what
# comes after goes to set points that the minute has not been at.
SPENT_MOTIONS = 54
# The same in space, where `identify` has more motions.
SPACE_SPENT_MOTIONS = 90
FRAME_RATE_HZ = 20
RAD_PER_M = 10  # of a tracker's noise
NAMED_ARMS = {
    "nominal": {},
    "friction +30 %": {"friction_coefficient": 0.325},
    "friction -30 %": {"friction_coefficient": 0.175},
    "50 g at the tip": {"tip_load_kg": 0.05},
    "a side 20 % weaker": {"weak_side_loss": 0.2, "weak_side": 1},
}
# Beyond what `wide` draws in at least two of these: bladders of another kind, worn, on another table.
STRANGERS = [
    {"actuator_threshold_kpa": "[-520, -300, 9000, 52000]", "actuator_gain": 0.85, "strength_spread": 0.15,
     "strength_seed": 11, "friction_coefficient": 0.35, "inflate_time_constant_s": 0.22,
     "vent_time_constant_s": 0.08},
    {"actuator_threshold_kpa": "[-330, -1500, 4000, 30000]", "actuator_gain": 1.2, "strength_spread": 0.2,
     "strength_seed": 12, "friction_coefficient": 0.18, "inflate_time_constant_s": 0.06,
     "vent_time_constant_s": 0.3},
    {"actuator_strain_offset": 0.45, "actuator_gain": 1.3, "actuator_extension_n": "[90, 600, 60000, 0]",
     "strength_spread": 0.15, "strength_seed": 13, "friction_coefficient": 0.5,
     "inflate_time_constant_s": 0.15, "vent_time_constant_s": 0.15},
]
MINUTES_OF_A_STRANGER = 5
PLANS_OF_A_TUBE = 10
MOTION_QUERIES = 2500  # of a closed loop's search in mid-motion: 20 ms of a core


def arm_text(text, physics):
    """An arm file with other physics."""
    for key, value in physics.items():
        line = f"  {key}: {value}"
        text, count = re.subn(rf"^  {key}:.*$", line, text, flags=re.MULTILINE)
        if count == 0:
            text = re.sub(r"^virtual_arm:.*$", lambda found, line=line: found[0] + "\n" + line, text,
                          flags=re.MULTILINE)
    return text


def piece(episode, first, last):
    last = min(last, len(episode.time_s))
    return limber.Episode(episode.time_s[first:last] - episode.time_s[first],
                          episode.pressure_kpa[first:last], episode.setpoint_kpa[first:last],
                          episode.backbone[first:last],
                          episode.motion_index[first:last] - episode.motion_index[first],
                          episode.tracked[first:last], lifted=episode.lifted)


def physics_of(episode):
    """By the names of traits, as far as the recording says it: not the sides' strengths, which a seed draws."""
    physics = json.loads(episode.physics)
    if "table_tilt_rad" in physics:
        tilt, downhill = physics["table_tilt_rad"], physics["table_downhill_rad"]
        physics |= {"table_fall_x_rad": tilt * np.cos(downhill), "table_fall_y_rad": tilt * np.sin(downhill)}
    return physics


class Family:
    def __init__(self, options):
        self.options = options
        self.arm_file = limber.data_folder() / "arms" / f"{options.arm}.yaml"
        self.arm = limber.load_arm(self.arm_file)
        self.in_space = self.arm.dimension == 3
        self.family = limber.read_model(options.family)
        self.parts = KeptParts(options.limber, options.out)
        self.identify = ("--schedule", "identify", "--noise-m", options.noise_m, "--noise-rad",
                         RAD_PER_M * options.noise_m)

    def error_cm(self, model, episode):
        predicted = limber.predict(limber.ForwardModel(self.arm, model), episode,
                                   limber.Restart.at_the_start_only)
        numbers = 3 if self.in_space else 2
        off = np.asarray(predicted)[1:, -1, :numbers] - np.asarray(episode.backbone)[1:, -1, :numbers]
        return float(100 * np.linalg.norm(off, axis=1).mean())

    def from_nothing(self, minute):
        """The default network, trained on the minute alone."""
        split = int(0.8 * len(minute.time_s))
        data = limber.TrainingData([piece(minute, 0, split)], [piece(minute, split, len(minute.time_s))])
        return limber.train(self.arm, data, limber.best_preset()).model

    def errors(self, minute, test):
        """Of one arm."""
        found = {"0 s": self.error_cm(self.family, test)}
        for seconds in (20, 60):
            done = limber.adapt(self.arm, self.family, [piece(minute, 0, FRAME_RATE_HZ * seconds)])
            found[f"{seconds} s"] = self.error_cm(done.model, test)
            found[f"weights {seconds} s"] = done.has_trained_weights
        if not self.options.no_training:
            found["from nothing"] = self.error_cm(self.from_nothing(minute), test)
        return found

    def record(self, name, seed, *arguments):
        path = self.options.out / name
        if not path.exists():
            self.parts.limber("collect", "--json", "--seed", seed, "--out", path, *arguments)
        return [piece(episode, 0, 10**9) for episode in limber.read_recording(path).episodes]

    def minute_and_test(self, name, seed, count, *arguments):
        spent = SPACE_SPENT_MOTIONS if self.in_space else SPENT_MOTIONS
        minutes = self.record(f"{name}_minute.h5", seed, *self.identify, "--episodes", count, *arguments)
        tests = self.record(f"{name}_test.h5", seed, "--schedule", "random", "--hold-s", 3, "--count",
                            spent + MOTIONS_OF_100_S, "--episodes", count, *arguments)
        tests = [piece(test, int(np.argmax(np.asarray(test.motion_index) >= spent)), 10**9)
                 for test in tests]
        return zip(minutes, tests, strict=True)

    def traits(self):
        print("| arms | quantity | spread of the arms | error, root mean square | told deviation | beyond two of it |\n"
              "|---|---|---|---|---|---|")
        for variation in ("1.5", "wide"):
            rows = self.parts.kept(f"traits_{variation}", lambda variation=variation: self.told_of(variation))
            for name in rows[0]:
                true, told, deviation = np.transpose([row[name] for row in rows])
                off = told - true
                print(f"| {variation} | {name} | {true.std():.3g} | {np.sqrt((off**2).mean()):.3g} | {deviation.mean():.3g}"
                      f" | {int((abs(off) > 2 * deviation).sum())} of {len(off)} |", flush=True)

    def told_of(self, variation):
        """Of each arm: truth, what its minute tells, and how surely."""
        name = f"open_{variation}_minute.h5"
        minutes = self.record(name, self.options.seed, *self.identify, "--episodes", self.options.arms,
                              "--arm", self.options.arm, "--vary-physics", variation)
        rows = []
        for minute, whole in zip(minutes, limber.read_recording(self.options.out / name).episodes, strict=True):
            true = physics_of(whole)
            told = limber.adapt(self.arm, self.family, [piece(minute, 0, 60 * FRAME_RATE_HZ)]).traits
            rows.append({trait.name: (true[trait.name], trait.value, trait.deviation) for trait in told
                         if trait.name in true})
        return rows

    def open(self):
        print("| arms | 0 s | 20 s | 60 s | the same minute, from nothing |\n|---|---|---|---|---|")
        for variation in ("1.5", "wide"):
            rows = self.parts.kept(f"open_{variation}", lambda variation=variation: [
                self.errors(minute, piece(test, 0, 2000)) for minute, test in self.minute_and_test(
                    f"open_{variation}", self.options.seed, self.options.arms, "--arm", self.options.arm,
                    "--vary-physics", variation)])
            cells = [both([row[key] for row in rows]) if key in rows[0] else "–"
                     for key in ("0 s", "20 s", "60 s", "from nothing")]
            print(f"| {variation} | " + " | ".join(cells) + " |", flush=True)

    def adapted(self, name, arm_file, seed):
        """Recorded and adapted by the program, as a user would."""
        minute = self.options.out / f"{name}.h5"
        model = self.options.out / f"{name}.safetensors"
        if not model.exists():
            if not minute.exists():
                self.parts.limber("collect", "--json", "--arm", arm_file, *self.identify, "--seed", seed,
                                  "--out", minute)
            self.parts.limber("adapt", "--json", "--arm", arm_file, "--model", self.options.family,
                              "--recording", minute, "--out", model)
        return model

    def plans(self, folder, arm_file, model, trials, *arguments):
        rows = self.parts.trials(self.options.out / folder, "--arm", arm_file, "--model", model, "--network-only",
                                 "--trials", trials, "--max-queries", self.options.max_queries,
                                 "--seed", self.options.seed, *arguments)
        runs = [row["execution"] for row in rows if row.get("execution")]
        return {"plans": len(rows), "solved": len(runs),
                "arrived": sum(bool(run["goal_reached"]) and not run["collided"] for run in runs),
                "collided": sum(run["collided"] for run in runs)}

    def write_arm(self, name, physics):
        path = self.options.out / name / f"{self.options.arm}.yaml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(arm_text(self.arm_file.read_text(encoding="utf-8"), physics), encoding="utf-8")
        return path

    def arms_named(self):
        print("| arm | 0 s | 20 s | 60 s | from nothing | solved | arrive | collide |\n|---|---|---|---|---|---|---|---|")
        for number, (name, physics) in enumerate(NAMED_ARMS.items()):
            folder = f"arm_{number}"
            arm_file = self.write_arm(folder, physics)
            seed = self.options.seed + number
            row = self.parts.kept(f"errors_{number}", lambda f=folder, a=arm_file, s=seed: [
                self.errors(minute, piece(test, 0, 2000))
                for minute, test in self.minute_and_test(f, s, 1, "--arm", a)])[0]
            model = self.adapted(f"{folder}/mine", arm_file, seed)
            done = self.plans(f"{folder}/plans", arm_file, model, self.options.trials)
            cells = [f"{row[key]:.2f}" if key in row else "–" for key in ("0 s", "20 s", "60 s", "from nothing")]
            print(f"| {name} | {' | '.join(cells)} | {done['solved']} of {done['plans']} | {done['arrived']} "
                  f"| {done['collided']} |", flush=True)

    def stranger_errors(self, minutes, test):
        first = piece(minutes[0], 0, 10**9)
        found = {"0 s": self.error_cm(self.family, test)}
        for name, minutes_known, weights in (("60 s, e alone", [first], False), ("60 s", [first], True),
                                             ("5 min", minutes, True)):
            done = limber.adapt(self.arm, self.family, minutes_known, train_weights=weights)
            found[name] = self.error_cm(done.model, test)
            found[name + ", weights"] = done.has_trained_weights
        if not self.options.no_training:
            found["from nothing"] = self.error_cm(self.from_nothing(first), test)
            found["5 min from nothing"] = self.error_cm(limber.train(
                self.arm, limber.TrainingData(minutes[:-1], minutes[-1:]), limber.best_preset()).model, test)
        return found

    def strangers(self):
        rows = []
        for number, physics in enumerate(STRANGERS):
            arm_file = self.write_arm(f"stranger_{number}", physics)
            seed = self.options.seed + 100 + number
            minutes = self.record(f"stranger_{number}_minutes.h5", seed, *self.identify, "--episodes",
                                  MINUTES_OF_A_STRANGER, "--arm", arm_file)
            _, test = next(iter(self.minute_and_test(f"stranger_{number}", seed, 1, "--arm", arm_file)))
            rows.append(self.parts.kept(f"stranger_{number}", lambda m=minutes, t=test: [
                self.stranger_errors(m, piece(t, 0, 2000))])[0])
            print(number, " ".join(f"{key} {value:.2f}" if isinstance(value, float) else f"{key} {value}"
                                   for key, value in rows[-1].items()), flush=True)
        for key in ("0 s", "60 s, e alone", "60 s", "5 min"):
            print(f"{key}: mean {np.mean([row[key] for row in rows]):.2f}")

    def unseen_arms(self, name, seed, count):
        """Of as many arms: a folder, the arm file, a seed, the model that a minute makes."""
        self.record(f"{name}_physics.h5", seed, "--schedule", "identify", "--count", 1, "--episodes", count,
                    "--arm", self.options.arm, "--vary-physics", self.options.vary_physics)
        for number, episode in enumerate(limber.read_recording(self.options.out / f"{name}_physics.h5").episodes):
            folder = f"{name}_{number}"
            arm_file = self.write_arm(folder, json.loads(episode.physics))
            own_seed = seed + 999 + number
            yield folder, arm_file, own_seed, self.adapted(f"{folder}/mine", arm_file, own_seed)

    def tube(self):
        rows, without = [], 0
        for folder, arm_file, seed, model in self.unseen_arms("tube", self.options.seed + 2, self.options.arms):
            if not self.parts.limber("inspect", "--json", model).get("tube"):  # `adapt` trained its weights
                without += 1
                continue
            rows.append(self.parts.kept(f"{folder}/check", lambda a=arm_file, m=model, s=seed: self.parts.limber(
                "calibrate", "--json", "--arm", a, "--model", m, "--seed", s, "--check", PLANS_OF_A_TUBE)))
            print(folder, {key: rows[-1][key] for key in ("environments", "runs", "outside", "reached", "collided",
                                                          "mean_tip_radius_cm")}, flush=True)
        runs, outside = (sum(row[key] for row in rows) for key in ("runs", "outside"))
        worst = sum(row["outside"] > 0.2 * row["runs"] for row in rows)
        print(f"coverage {100 * (1 - outside / runs):.1f} % of {runs}; {worst} of {len(rows)} arms below 8 of 10; "
              f"radius at the tip, median over arms {np.median([row['mean_tip_radius_cm'] for row in rows]):.2f} cm; "
              f"{without} arms have no tube, since their weights were trained")

    def unseen(self):
        total = {"open": {}, "replan": {}}
        for number, (folder, arm_file, seed, model) in enumerate(
                self.unseen_arms("unseen", self.options.seed + 1, self.options.unseen)):
            environments = self.parts.random_environments(seed, 5, f"{folder}/environments", arm=arm_file)
            for controller, so_far in total.items():
                done = self.plans(f"{folder}/plans_{controller}", arm_file, model, 1, "--environments", environments,
                                  "--controller", controller, "--motion-queries", MOTION_QUERIES)
                total[controller] = {key: so_far.get(key, 0) + value for key, value in done.items()}
                print(number, controller, done, flush=True)
        print("all", total, flush=True)


def both(values):
    return f"{np.median(values):.2f}; {np.quantile(values, 0.9):.2f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--family", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--arm", default="three_segment")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--arms", type=int, default=40, help="unseen ones of parts open and tube")
    parser.add_argument("--unseen", type=int, default=20, help="unseen ones of part unseen")
    parser.add_argument("--vary-physics", default="wide", help="how arms of parts unseen and tube differ")
    parser.add_argument("--trials", type=int, default=20, help="of each environment, part arms")
    parser.add_argument("--max-queries", type=int, default=20000, help="of each plan")
    parser.add_argument("--noise-m", type=float, default=0.0,
                        help="of the minutes' positions, std deviation; of their headings 10 rad/m times that")
    parser.add_argument("--no-training", action="store_true", help="no networks from nothing")
    parser.add_argument("parts", nargs="*", default=["open", "arms", "unseen"])
    options = parser.parse_args()
    family = Family(options)
    parts = {"open": family.open, "arms": family.arms_named, "unseen": family.unseen,
             "stranger": family.strangers, "traits": family.traits, "tube": family.tube}
    if unknown := [part for part in options.parts if part not in parts]:
        sys.exit(f"{unknown[0]}: expected {', '.join(parts)}")
    for part in options.parts:
        parts[part]()


if __name__ == "__main__":
    main()
