#!/usr/bin/env python3
"""What became of plans made in pressures, had their set points come from the valves inverted (log of docs/planning.md).

    limber experiment --no-valves … --out EXPERIMENT
    tools/inverted_valves.py EXPERIMENT --inflate-s 0.094 --vent-s 0.115 --rate-kpa-per-s 100

Every plan's path is taken for the pressures wanted. Printed: how many plans need a set point beyond the limits, or a
step beyond the frame rule; and how far the pressures are off once set points are cut to both.
"""

import argparse
import json
import math
import pathlib
import statistics

FRAME_S = 0.05
ROUNDING_KPA = 1e-3
SUBSTEPS = 50  # of a frame


class Valves:
    def __init__(self, options):
        self.inflate_s, self.vent_s = options.inflate_s, options.vent_s
        self.rate, self.limit = options.rate_kpa_per_s, options.limit_kpa
        self.step = self.rate * FRAME_S

    def setpoint(self, before, after):
        """That brings a pressure from `before` to `after` in a frame, rate limit left out."""
        if before == after:
            return after
        constant = self.vent_s if abs(after) < abs(before) else self.inflate_s
        kept = math.exp(-FRAME_S / constant)
        return (after - before * kept) / (1.0 - kept)

    def pressure(self, before, setpoint):
        """After a frame at `setpoint`, in small steps."""
        for _ in range(SUBSTEPS):
            error = setpoint - before
            constant = self.vent_s if error * before < 0.0 else self.inflate_s
            before += max(-self.rate, min(self.rate, error / constant)) * FRAME_S / SUBSTEPS
        return before


def judge(valves, path):
    """Of one segment: largest set point and step needed, and errors of what can be commanded."""
    needed = [path[0]] + [valves.setpoint(a, b) for a, b in zip(path, path[1:])]
    steps = [abs(b - a) for a, b in zip(needed, needed[1:])]
    pressure = given = path[0]
    errors = []
    for wanted in path[1:]:
        asked = max(-valves.limit, min(valves.limit, valves.setpoint(pressure, wanted)))
        given = max(given - valves.step, min(given + valves.step, asked))
        pressure = valves.pressure(pressure, given)
        errors.append(abs(pressure - wanted))
    return max(map(abs, needed)), max(steps), errors


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("experiment", type=pathlib.Path)
    parser.add_argument("--inflate-s", type=float, default=0.094)
    parser.add_argument("--vent-s", type=float, default=0.115)
    parser.add_argument("--rate-kpa-per-s", type=float, default=100.0)
    parser.add_argument("--limit-kpa", type=float, default=100.0)
    options = parser.parse_args()
    valves = Valves(options)
    beyond_limit = beyond_rate = 0
    means, largest = [], []
    plans = sorted((options.experiment / "plans").glob("*.json"))
    for file in plans:
        frames = [frame["setpoint_kpa"] for frame in json.loads(file.read_text())["frames"]]
        found = [judge(valves, path) for path in zip(*frames)]
        beyond_limit += any(most > valves.limit + ROUNDING_KPA for most, _, _ in found)
        beyond_rate += any(step > valves.step + ROUNDING_KPA for _, step, _ in found)
        errors = [error for _, _, of_segment in found for error in of_segment]
        means.append(statistics.mean(errors))
        largest.append(max(errors))
    print(f"{len(plans)} plans; set points beyond the limits in {beyond_limit}, steps beyond the frame rule in "
          f"{beyond_rate}; cut to both, pressures are off by {statistics.mean(means):.2f} kPa on average, by "
          f"{statistics.mean(largest):.1f} kPa at most (mean over plans)")


main()
