#!/usr/bin/env python3
"""What the goals of limber's environments cost where nothing is in the way: the cheapest motions of a forest
(docs/planning.md) that end in them, and in discs twice as wide. A dense forest is grown by

    limber plan --model M --environment 01_pillar --time-limit-s 1 --forest F --forest-nodes 2000000 --out P.json

    tools/cheapest_motions.py F
"""

import json
import pathlib
import re
import struct
import sys

import numpy as np

ENVIRONMENTS = pathlib.Path(__file__).resolve().parents[1] / "environments"


def read_tensors(path, names):
    content = pathlib.Path(path).read_bytes()
    length = struct.unpack("<Q", content[:8])[0]
    header = json.loads(content[8 : 8 + length])
    for name in names:
        if name not in header or header[name]["dtype"] != "F32":
            sys.exit(f"{path}: no forest: tensor {name} is missing, or not of 32-bit floats")
        begin, end = header[name]["data_offsets"]
        data = content[8 + length + begin : 8 + length + end]
        yield np.frombuffer(data, "<f4").reshape(header[name]["shape"])


def costs_kpa(parents, pressures):
    """(2) of the way from the start to every node; a node comes after its parent."""
    edges = np.abs(pressures - pressures[np.maximum(parents, 0)]).sum(axis=1, dtype=np.float64)
    costs = np.zeros(len(parents))
    for node in range(1, len(parents)):
        costs[node] = costs[parents[node]] + edges[node]
    return costs


def goal_of(path):
    found = re.search(r"^goal: \{(.*)\}", path.read_text(), re.MULTILINE)
    if not found:
        sys.exit(f"{path}: no line 'goal: {{...}}'")
    return {key: float(value) for key, value in re.findall(r"(\w+): ([-\d.]+)", found.group(1))}


def ends_in(goal, tips, widening):
    near = np.hypot(tips[:, 0] - goal["x_m"], tips[:, 1] - goal["y_m"])
    inside = near <= widening * goal["position_tolerance_m"]
    if "theta_rad" in goal:
        turn = np.abs((tips[:, 2] - goal["theta_rad"] + np.pi) % (2 * np.pi) - np.pi)
        inside &= turn <= goal["orientation_tolerance_rad"]
    return inside


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    parents, pressures, tips = read_tensors(sys.argv[1], ["parents", "pressures_kpa", "held_tips"])
    costs = costs_kpa(parents.astype(int), pressures)
    print(f"| environment | of {len(costs)} motions in the goal | cheapest | in a disc twice as wide | cheapest |")
    print("|---|---|---|---|---|")
    for path in sorted(ENVIRONMENTS.glob("*.yaml")):
        goal = goal_of(path)
        cells = []
        for widening in (1, 2):
            found = costs[ends_in(goal, tips, widening)]
            cells.append(f"{len(found)} | {found.min():.0f} kPa" if len(found) else "0 | none")
        print(f"| {path.stem} | {' | '.join(cells)} |")


main()
