#!/usr/bin/env python3
"""The figures of docs/tube.md: a whole calibration, its audit, and coverage beside what is promised.

    tools/tube_figures.py --limber build/release/bin/limber --model model.safetensors --out OUT

Every part lies in OUT; parts that are finished are not run again, and a calibration that was stopped
goes on where it was. --share 0.01 runs a hundredth of it, with levels that so few runs can show.
"""

import argparse
import pathlib
import sys

from kept_parts import KeptParts

SEED = 2_000_001  # used for nothing else
CHECK_SEED = 2_000_002
EXPERIMENT_SEED = 2_000_003
RANDOM_SEED = 2_000_004
DISTURBANCES = {
    "as calibrated": [],
    "friction x 0.7": ["--friction-factor", "0.7"],
    "friction x 1.3": ["--friction-factor", "1.3"],
    "5 g more on every plate": ["--load-kg", "0.005"],
    "actuators 5 % weaker": ["--actuator-factor", "0.95"],
}


class Campaign(KeptParts):
    def __init__(self, options):
        super().__init__(options.limber, options.out)
        self.options = options
        self.model = options.out / "calibrated.safetensors"

    def scaled(self, runs, least):
        return str(max(least, round(runs * self.options.share)))

    def calibrate(self):
        whole = self.options.share >= 1.0
        levels = ["0.9", "0.95"] if whole else ["0.5", "0.6"]
        return self.limber(
            "calibrate", "--json", "--model", self.options.model, "--out", self.model, "--seed", SEED,
            "--levels", *levels,
            "--shape-runs", self.scaled(500, 20), "--screen-runs", self.scaled(500, 20),
            "--test-runs", self.scaled(4000, 20), "--audit-runs", self.scaled(4000, 20),
            "--resume", codes=(0, 1))

    def check(self, *flags):
        return self.limber("calibrate", "--json", "--model", self.model, "--check",
                           self.scaled(200, 5), "--seed", CHECK_SEED, *flags)

    def experiment(self, name, *flags):
        trials = self.trials(self.out / name, "--model", self.model, "--network-only",
                             "--time-limit-s", 1, "--jobs", 1, *flags)
        solved = [trial for trial in trials if trial["execution"]]
        first = sorted(trial["first_solution"]["time_s"] for trial in solved)
        return {"trials": len(trials), "solved": len(solved),
                "arrived": sum(t["execution"]["goal_reached"] and not t["execution"]["collided"]
                               for t in solved),
                "collided": sum(t["execution"]["collided"] for t in solved),
                "first_certified_ms": 1e3 * first[len(first) // 2] if first else None}


def percent(coverage):
    return (f"{100 * coverage['share']:.2f} % ({100 * coverage['low']:.2f} to "
            f"{100 * coverage['high']:.2f} %)")


def write_page(calibration, checks, experiments, out):
    lines = ["| level | factor | tip | end | test | audit |", "|---|---|---|---|---|---|"]
    for level in calibration.get("tube", {"levels": []})["levels"]:
        lines.append(f"| {level['level']} | {level['factor']:.3f} | {level['tip_radius_cm']:.2f} cm "
                     f"| {level['end_radius_cm']:.2f} cm | {level['outside']} of {level['runs']} "
                     f"outside | {level['audit_outside']} of {level['audit_runs']} outside |")
    lines += ["", "| phase | factor | tip, mean over frames | coverage | solved | cost | collided | arrived |",
              "|---|---|---|---|---|---|---|---|"]
    for phase in calibration["phases"]:
        if "coverage" in phase:
            lines.append(f"| {phase['phase']} | {phase['factor']:.3f} | "
                         f"{phase['mean_tip_radius_cm']:.2f} cm | {percent(phase['coverage'])} "
                         f"| {phase['solved']} of {phase['environments']} | {phase['cost']:.0f} "
                         f"| {phase['collided']} | {phase['reached']} of {phase['runs']} |")
    lines += ["", "| 200 runs, level 0.95 | coverage | solved | collided | arrived |",
              "|---|---|---|---|---|"]
    for name, check in checks.items():
        lines.append(f"| {name} | {percent(check['coverage'])} | {check['solved']} of "
                     f"{check['environments']} | {check['collided']} | {check['reached']} |")
    lines += ["", "| 1 s per plan, tube 0.95 | solved | arrived | collided | first certified plan |",
              "|---|---|---|---|---|"]
    for name, found in experiments.items():
        lines.append(f"| {name} | {found['solved']} of {found['trials']} | {found['arrived']} | "
                     f"{found['collided']} | {found['first_certified_ms']:.1f} ms |")
    text = "\n".join(lines) + "\n"
    (out / "figures.md").write_text(text, encoding="utf-8")
    print(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--model", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--share", type=float, default=1.0, help="of all numbers of runs")
    campaign = Campaign(parser.parse_args())
    calibration = campaign.kept("calibration", campaign.calibrate)
    if "tube" not in calibration:
        sys.exit("no level held: " + "; ".join(calibration["failures"]))
    checks = {name: campaign.kept(f"check_{number}", lambda flags=flags: campaign.check(*flags))
              for number, (name, flags) in enumerate(DISTURBANCES.items())}
    checks["1 s plans"] = campaign.kept(
        "check_1s", lambda: campaign.check("--time-limit-s", 1, "--jobs", 1))
    trials = campaign.scaled(20, 1)
    experiments = {
        "eight environments": campaign.kept("experiment_eight", lambda: campaign.experiment(
            "eight", "--trials", trials, "--seed", EXPERIMENT_SEED)),
        "random environments": campaign.kept("experiment_random", lambda: campaign.experiment(
            "hundred", "--trials", 1, "--seed", EXPERIMENT_SEED, "--environments",
            campaign.random_environments(RANDOM_SEED, campaign.scaled(100, 3)))),
    }
    write_page(calibration, checks, experiments, campaign.out)


if __name__ == "__main__":
    main()
