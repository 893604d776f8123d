#!/usr/bin/env python3
"""Writes circles and eights as CSV files for `limber execute --track` (docs/tracking.md).

Centres are drawn by seed where the tip of arms/three_segment.yaml comes to every point around them
with at most 80 % of the limits: 0.55 to 0.60 m from the base, up to 0.6 rad to either side. A file
holds one lap that ends where it starts; run it with --laps.

    tools/track_paths.py --out paths --count 5 --seed 1
"""

import argparse
import math
import pathlib
import random

NEAREST_M, FARTHEST_M = 0.55, 0.60
WIDEST_RAD = 0.6
CIRCLE_RADIUS_M = 0.08
EIGHT_WIDTH_M = 0.16
LAPS_S = (30, 10)
RATE_HZ = 20


def circle(center, share):
    """A point of the circle, `share` of the lap after its nearest to the base."""
    angle = 2.0 * math.pi * share + math.pi
    return (center[0] + CIRCLE_RADIUS_M * math.cos(angle),
            center[1] + CIRCLE_RADIUS_M * math.sin(angle))


def eight(center, share):
    """The lemniscate of Gerono, lying along y, from its crossing."""
    angle = 2.0 * math.pi * share
    return (center[0] + 0.5 * EIGHT_WIDTH_M * math.sin(angle) * math.cos(angle),
            center[1] + 0.5 * EIGHT_WIDTH_M * math.sin(angle))


def centers(seed, count):
    drawn = random.Random(seed)
    for _ in range(count):
        distance = drawn.uniform(NEAREST_M, FARTHEST_M)
        angle = drawn.uniform(-WIDEST_RAD, WIDEST_RAD)
        yield distance * math.cos(angle), distance * math.sin(angle)


def rows(shape, center, lap_s):
    count = lap_s * RATE_HZ
    for k in range(count + 1):
        x, y = shape(center, k / count)
        yield f"{k / RATE_HZ:.3f},{x:.6f},{y:.6f}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("paths"))
    parser.add_argument("--count", type=int, default=5, help="centres")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for number, center in enumerate(centers(arguments.seed, arguments.count)):
        for name, shape in (("circle", circle), ("eight", eight)):
            for lap_s in LAPS_S:
                path = arguments.out / f"{name}_{number}_{lap_s}s.csv"
                path.write_text("time_s,x_m,y_m\n" + "".join(rows(shape, center, lap_s)),
                                encoding="utf-8")
                print(path)


if __name__ == "__main__":
    main()
