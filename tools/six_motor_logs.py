#!/usr/bin/env python3
"""Makes up the logs of examples/six_motors: five trials of three discs on tendons, two motors for each.

    PYTHONPATH=build/release/python tools/six_motor_logs.py --out examples/six_motors

limber's virtual arm stands in: 30 kPa for a radian of a disc's command. The motors of a pair turn
against each other about an angle that keeps both tendons tight. What the motors are told is logged ten
times per second, with every plate in millimetres and 0.3 mm of noise. Same --seed, same logs.
"""

import argparse
import csv
import pathlib
import random
import tempfile

import limber
from stand_in_figures import ROOT, SlowTarget, arm_text

SEED, TRIALS, TRIAL_S, RATE_HZ = 6, 5, 20.0, 10.0
KPA_PER_RAD = 30.0
TIGHT_RAD = 0.4
NOISE_MM = 0.3
SEGMENTS = [(0.15, 0.040), (0.14, 0.030), (0.12, 0.024)]  # [m] length, width
GAPS = 2


def true_arm(folder):
    physics = (ROOT / "arms" / "three_segment.yaml").read_text(encoding="utf-8")
    text = arm_text("six_motors", RATE_HZ, SEGMENTS, physics[physics.index("virtual_arm:"):])
    path = pathlib.Path(folder) / "arm.yaml"
    path.write_text(text.replace("gaps: 4", f"gaps: {GAPS}"), encoding="utf-8")
    return limber.load_arm(path)


def motors_of(pressures_kpa):
    """A pair for each segment: its command is half of what one motor turns more than the other."""
    angles = []
    for pressure_kpa in pressures_kpa:
        command_rad = pressure_kpa / KPA_PER_RAD
        angles += [TIGHT_RAD + command_rad, TIGHT_RAD - command_rad]
    return angles


def write_trial(path, arm, draw):
    virtual = limber.VirtualArm(arm)
    targets = [SlowTarget(draw) for _ in arm.segments]
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["t"] + [f"motor_{k}" for k in range(2 * len(targets))]
                       + [f"{axis}{j}" for j in range(arm.point_count) for axis in "xy"])
        for frame in range(round(TRIAL_S * RATE_HZ)):
            setpoints = [target.at(frame / RATE_HZ) for target in targets]
            plates = virtual.state().backbone
            cells = [f"{frame / RATE_HZ:.1f}"] + [f"{angle:.3f}" for angle in motors_of(setpoints)]
            cells += [f"{1e3 * value + draw.gauss(0.0, NOISE_MM):.1f}"
                      for plate in plates for value in plate[:2]]
            table.writerow(cells)
            virtual.command(setpoints)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "examples/six_motors")
    parser.add_argument("--seed", type=int, default=SEED)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        arm = true_arm(folder)
    draw = random.Random(options.seed)
    for trial in range(TRIALS):
        write_trial(options.out / f"trial_{trial}.csv", arm, draw)


if __name__ == "__main__":
    main()
