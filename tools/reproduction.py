#!/usr/bin/env python3
"""The paper's tables and figures, run again: what docs/reproduction.md shows.

    PYTHONPATH=build/release/python tools/reproduction.py --limber build/release/bin/limber \\
        --model model.safetensors --out OUT [--parts readings queries figure_1 table_1 random_1]

--model is the network of Table I; the readings of the paper's training are trained here. Every part
lies in OUT; parts that are finished are not run again, and a table that was stopped goes on.
Table I takes trials x models x environments x seconds / jobs: 53 minutes on two cores.
"""

import argparse
import pathlib

import limber
import numpy as np
from kept_parts import KeptParts

TRANSITIONS_SEED = 11
TEST_SEED = 1_600_001  # used for nothing else
TABLE_SEED = 1_600_002
RANDOM_SEED = 1_600_003
RANDOM_ENVIRONMENTS = 40
NO_MARGINS = ("--margin-m", 0, "--goal-margin-m", 0, "--goal-margin-rad", 0)  # the paper keeps none
CM = 100.0
HORIZONS = {"one step": "one_step", "32 frames": "window_32", "per motion": "per_motion",
            "open loop": "open_loop"}


def as_published(settings):
    """Every number in a range of its own, plain SGD."""


def in_shared_units(settings):
    settings.scaling = limber.Scaling.shared_range


def with_adam(settings):
    settings.optimiser = limber.Optimiser.adam


def in_shared_units_with_adam(settings):
    in_shared_units(settings)
    with_adam(settings)


READINGS = {"published": as_published, "shared_units": in_shared_units, "adam": with_adam,
            "shared_units_adam": in_shared_units_with_adam}


class Reproduction(KeptParts):
    def __init__(self, options):
        super().__init__(options.limber, options.out)
        self.options = options
        self.arm = limber.load_arm(options.arm)

    def recording(self, name, *flags):
        path = self.out / f"{name}.h5"
        if not path.exists():
            self.limber("collect", "--json", "--arm", self.options.arm, *flags, "--out", path)
        return path

    def readings(self):
        """The paper's training on its 729 transitions, in four readings, and its Fig. 4."""
        transitions = self.recording("transitions", "--schedule", "transitions", "--seed", TRANSITIONS_SEED)
        test = self.recording("test", "--schedule", "random", "--count", 100, "--episodes", 4,
                              "--seed", TEST_SEED)
        return {name: self.kept(f"reading_{name}", lambda set_up=set_up, name=name: self.reading(
            name, set_up, transitions, test)) for name, set_up in READINGS.items()}

    def reading(self, name, set_up, transitions, test):
        settings = limber.paper_preset()
        settings.seed = 1
        set_up(settings)
        episodes = limber.read_recording(transitions).episodes
        held_back = max(1, len(episodes) // 10)
        data = limber.TrainingData(episodes[held_back:], episodes[:held_back])
        result = limber.train(self.arm, data, settings)
        model = self.out / f"{name}.safetensors"
        limber.write_model(model, result.model)
        found = self.limber("evaluate", "--json", "--arm", self.options.arm, "--model", model, "--data", test)
        return {"epochs": settings.epoch_count, "best_epoch": result.best_epoch,
                "no_load": found["no_load"], "network": found["network"]}

    def queries(self):
        return self.kept("queries", lambda: self.limber("bench", "--json", "--arm", self.options.arm))

    def figure_1(self):
        """All right sides inflated, then vented: where the arm stays, and where the no-load model has it."""
        def tip():
            arm = limber.VirtualArm(self.arm)
            full = np.asarray(self.arm.pressure_limits_kpa, np.float32)
            steps = int(round(float(full.max()) / self.arm.pressure_step_limit_kpa))
            for share in np.r_[np.linspace(0, 1, steps + 1), np.linspace(1, 0, steps + 1)]:
                arm.command(full * np.float32(share))
            arm.settle(np.zeros_like(full), 5.0)
            bent = arm.true_backbone().astype(np.float32)
            rest = np.zeros_like(full)
            straight = limber.ForwardModel(self.arm).no_load.backbone(rest)
            (self.out / "figure_1.svg").write_text(limber.arm_svg(self.arm, bent), encoding="utf-8")
            return {"tip_from_straight_cm": CM * float(np.linalg.norm((bent - straight)[-1, :2]))}
        return self.kept("figure_1", tip)

    def table(self, name, planner, *flags):
        """Table I: both models, planned and executed."""
        folder = self.out / name
        self.limber("experiment", "--json", "--arm", self.options.arm, "--model", self.options.model,
                    "--planner", planner, "--time-limit-s", self.options.seconds, "--seed", TABLE_SEED,
                    "--jobs", self.options.jobs, "--out", folder, "--resume", *NO_MARGINS, *flags)
        return folder / "table.md"

    def tables(self, part):
        planner = "paper,valves=1" if part.endswith("valves") else "paper"
        if part.startswith("table"):
            return self.table(part, planner, "--trials", self.options.trials)
        return self.table(part, planner, "--trials", 2, "--environments",
                          self.random_environments(RANDOM_SEED, RANDOM_ENVIRONMENTS))


def errors_of(found):
    """"16.5 ± 9.9 cm, 0.55 ± 0.36 rad"."""
    position, turn = found["position_error_cm"], found["orientation_error_rad"]
    return (f"{position['mean']:.1f} ± {position['std']:.1f} cm, "
            f"{turn['mean']:.2f} ± {turn['std']:.2f} rad")


def less_by(found, than):
    shares = [1.0 - found[key]["mean"] / than[key]["mean"]
              for key in ("position_error_cm", "orientation_error_rad")]
    return ", ".join(f"{100.0 * share:.0f} %" for share in shares)


def print_readings(readings):
    print("| reading | " + " | ".join(HORIZONS) + " | less than without network, open loop |")
    print("|---|---|---|---|---|---|")
    no_load = readings["published"]["no_load"]["open_loop"]
    print(f"| no network | | | | {errors_of(no_load)} | |")
    for name, reading in readings.items():
        network = reading["network"]
        cells = " | ".join(errors_of(network[key]) for key in HORIZONS.values())
        print(f"| {name} | {cells} | {less_by(network['open_loop'], no_load)}; per motion "
              f"{less_by(network['per_motion'], no_load)} |")


PARTS = ["readings", "queries", "figure_1", "table_1", "table_1_valves", "random_1", "random_1_valves"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--arm", default="arms/three_segment.yaml")
    parser.add_argument("--model", type=pathlib.Path, help="network of Table I")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--trials", type=int, default=20, help="of Table I, in each environment")
    parser.add_argument("--seconds", type=float, default=20, help="for each plan")
    parser.add_argument("--jobs", type=int, default=2, help="plans at once")
    options = parser.parse_args()
    if options.model is None and any("_1" in part and part != "figure_1" for part in options.parts):
        parser.error("--model is needed for Table I")
    run = Reproduction(options)
    for part in options.parts:
        if part == "readings":
            print_readings(run.readings())
        elif part == "queries":
            found = run.queries()
            for name in ("no_load", "network"):
                print(f"{name}: {found[name]['single']['queries_per_s']:.0f} queries per second, one at "
                      f"a time; {found[name]['batch']['queries_per_s']:.0f} in batches of "
                      f"{found[name]['batch']['size']}")
        elif part == "figure_1":
            print(f"tip {run.figure_1()['tip_from_straight_cm']:.1f} cm from straight")
        else:
            print(run.tables(part).read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
