#!/usr/bin/env python3
"""How far planners overrun their time limit: limber's own environments, and 100 polygons of 1000 corners each.

    tools/limit_overruns.py --limber build/release/bin/limber
    tools/limit_overruns.py --limits 0.3 1 3 --planners default ompl:SST --model model.safetensors
    tools/limit_overruns.py --max-ms 50           exit code 1 if any run overran its limit by more

Without --model the no-load model plans. `time_s` of `limber plan --json` is compared with the limit: what reading
files takes is not part of it. The polygons are stars; in "crowded" they leave ways free, in "walled" they surround
the goal, so that nothing can be found and every limit is used up. Overruns mean something on an idle machine only.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

CORNERS = 1000
POLYGONS = 100
PLANNERS = ["default", "paper", "ompl:RRT", "ompl:EST", "ompl:KPIECE1", "ompl:PDST", "ompl:SST"]
OWN = ["01_pillar", "06_overshoot", "07_clutter", "08_overshoot_in_clutter"]
GOAL = {"x_m": 0.30, "y_m": 0.40, "position_tolerance_m": 0.02}
BASE_ROOM_M = 0.12  # free of polygons, about the base
GOAL_ROOM_M = 0.09  # about the goal, in "crowded"


def star(x_m, y_m, radius_m):
    corners = []
    for k in range(CORNERS):
        angle = 2.0 * math.pi * k / CORNERS
        r = radius_m * (1.0 if k % 2 else 0.8)
        corners.append([round(x_m + r * math.cos(angle), 6), round(y_m + r * math.sin(angle), 6)])
    return {"polygon": corners}


def crowded():
    """On a grid outside of where the arm starts, and away from the goal."""
    stars = []
    for k in range(400):
        x, y = -0.55 + 0.06 * (k % 20), -0.55 + 0.06 * (k // 20)
        from_arm = math.hypot(max(abs(y) - 0.0, 0.0), 0.0 if -0.05 < x < 0.62 else 1.0)
        far_from_goal = math.hypot(x - GOAL["x_m"], y - GOAL["y_m"]) > GOAL_ROOM_M
        if from_arm > BASE_ROOM_M and far_from_goal and math.hypot(x, y) > 0.3:
            stars.append(star(x, y, 0.008))
    return stars[:POLYGONS]


def walled():
    """A ring about the goal, closed, that the arm's tip cannot pass."""
    return [star(GOAL["x_m"] + 0.05 * math.cos(a), GOAL["y_m"] + 0.05 * math.sin(a), 0.008)
            for a in (2.0 * math.pi * k / POLYGONS for k in range(POLYGONS))]


def write_environment(folder, name, stars):
    path = folder / f"{name}.yaml"
    path.write_text(json.dumps({"schema": "limber/environment/1", "name": name, "obstacles": stars, "start": "rest",
                                "goal": GOAL}), encoding="utf-8")
    return path


def overrun_ms(options, environment, planner, limit_s):
    model = ["--model", options.model] if options.model else ["--no-load", "--margin-m", "0.002"]
    command = [options.limber, "plan", *model, "--environment", str(environment), "--planner", planner,
               "--time-limit-s", str(limit_s), "--jobs", "1", "--seed", str(options.seed), "--json", "--quiet"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        sys.exit(f"{' '.join(command)}: {run.stderr}")
    found = json.loads(run.stdout)
    return 1e3 * (found["time_s"] - limit_s), found["status"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", default="build/release/bin/limber")
    parser.add_argument("--model")
    parser.add_argument("--planners", nargs="+", default=PLANNERS)
    parser.add_argument("--limits", nargs="+", type=float, default=[0.3, 1.0])
    parser.add_argument("--environments", nargs="+", default=["crowded", "walled", *OWN])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--max-ms", type=float)
    options = parser.parse_args()
    worst_ms = -math.inf
    with tempfile.TemporaryDirectory() as name:
        made = {key: write_environment(pathlib.Path(name), key, stars)
                for key, stars in (("crowded", crowded()), ("walled", walled()))}
        print("| planner | " + " | ".join(options.environments) + " |\n|---|" + "---|" * len(options.environments))
        for planner in options.planners:
            cells = []
            for environment in options.environments:
                runs = [overrun_ms(options, made.get(environment, environment), planner, limit_s)
                        for limit_s in options.limits]
                worst_ms = max(worst_ms, *(ms for ms, _ in runs))
                cells.append(", ".join(f"{ms:+.0f} ms {status}" for ms, status in runs))
            print(f"| {planner} | " + " | ".join(cells) + " |", flush=True)
    print(f"\nworst overrun: {worst_ms:.1f} ms")
    return 1 if options.max_ms is not None and worst_ms > options.max_ms else 0


sys.exit(main())
