#!/usr/bin/env python3
"""Makes up the logs of docs/tutorial.md: nine trials of an arm of two segments, one of them broken.

    tools/tutorial_logs.py --limber build/release/bin/limber --out docs/tutorial/logs

The arm is limber's virtual one with other lengths, widths, friction and valves than its arm file in
docs/tutorial says. It is seen 12 times per second at five of its nine plates, in millimetres, with
0.5 mm of noise, somewhere in the laboratory's frame; pressures are logged in psi, one column a side.
In trial_6 (--broken) the pressures are those of another trial. Same --seed, same logs.
"""

import argparse
import csv
import math
import pathlib
import random
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
SEED = 14
TRIALS = 9
BROKEN = 6
PLATES = (0, 2, 4, 6, 8)
KPA_PER_PSI = 6.894757
TURN_RAD = 0.7  # of the arm in the laboratory
SHIFT_MM = (412.0, -95.0)
TRUE_SEGMENTS = """segments:
  - {length_m: 0.208, width_m: 0.0400, gaps: 4, pressure_limit_kpa: 90,
     strain_polynomial: [0.001638291, 3.810475e-05, -5.205297e-07, 1.797926e-09]}
  - {length_m: 0.196, width_m: 0.0250, gaps: 4, pressure_limit_kpa: 90,
     strain_polynomial: [0.001642865, 3.72381e-05, -5.072633e-07, 1.740553e-09]}
"""


def true_arm():
    text = (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8")
    text = text.replace("frame_rate_hz: 20", "frame_rate_hz: 24")
    text = re.sub(r"segments:\n(  - .*\n(     .*\n)?)+", TRUE_SEGMENTS, text, count=1)
    for key, value in {"friction_coefficient": 0.2, "inflate_time_constant_s": 0.2,
                       "vent_time_constant_s": 0.24, "strength_seed": 5}.items():
        text, count = re.subn(rf"(\n  {key}:) \S+", rf"\1 {value}", text)
        assert count == 1, key
    return text


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def in_laboratory(x_m, y_m, noise):
    x = 1e3 * (math.cos(TURN_RAD) * x_m - math.sin(TURN_RAD) * y_m) + SHIFT_MM[0]
    y = 1e3 * (math.sin(TURN_RAD) * x_m + math.cos(TURN_RAD) * y_m) + SHIFT_MM[1]
    return x + noise.gauss(0.0, 0.5), y + noise.gauss(0.0, 0.5)


def table(motion, pressures, noise):
    header = ["t"] + [f"{side}{i}_psi" for i in (1, 2) for side in ("right", "left")]
    header += [f"{axis}{i}" for i in range(len(PLATES)) for axis in "xy"]
    lines = [",".join(header)]
    for row, commanded in list(zip(motion, pressures))[::2]:  # 24 to 12 rows per second
        cells = [f"{float(row['time_s']):.3f}"]
        for name in [name for name in commanded if name.startswith("pressure_")]:
            pressure = float(commanded[name]) / KPA_PER_PSI
            cells += [f"{max(pressure, 0.0):.2f}", f"{max(-pressure, 0.0) + 0.0:.2f}"]
        for plate in PLATES:
            x, y = in_laboratory(float(row[f"x_{plate}_m"]), float(row[f"y_{plate}_m"]), noise)
            cells += [f"{x:.1f}", f"{y:.1f}"]
        lines.append(",".join(cells))
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", type=pathlib.Path, default=ROOT / "build/release/bin/limber")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/tutorial/logs")
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--broken", type=int, default=BROKEN, help="trial, 1 to 8")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "arm.yaml").write_text(true_arm(), encoding="utf-8")
        for command in (
            ["collect", "--arm", "arm.yaml", "--schedule", "random", "--approach", "straight",
             "--count", "22", "--hold-s", "1.2", "--hold-min-s", "0.2", "--episodes", str(TRIALS),
             "--seed", str(options.seed), "--out", "log.h5"],
            ["export", "log.h5", "--csv", "tables"],
        ):
            subprocess.run([options.limber.resolve(), *command], cwd=folder, check=True,
                           capture_output=True)
        tables = [rows_of(folder / "tables" / f"episode_{i:03}.csv") for i in range(TRIALS)]
        options.out.mkdir(parents=True, exist_ok=True)
        for i, motion in enumerate(tables):
            pressures = tables[i - 1] if i == options.broken else motion
            text = table(motion, pressures, random.Random(options.seed + i))
            (options.out / f"trial_{i}.csv").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
