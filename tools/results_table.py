#!/usr/bin/env python3
"""Sets the figures of a demo run beside the paper's, as the README's table.

    tools/results_table.py out/summary.json                    prints the table
    tools/results_table.py out/summary.json --write README.md  replaces the one there
"""

import argparse
import json
import pathlib
import re

BEGIN, END = "<!-- results:begin", "<!-- results:end -->"


def spread(errors):
    position, orientation = errors["position_error_cm"], errors["orientation_error_rad"]
    return (
        f"{position['mean']:.1f} ± {position['std']:.1f} cm,"
        f" {orientation['mean']:.2f} ± {orientation['std']:.2f} rad"
    )


def distances(executions, model):
    runs = [run for run in executions if run["model"] == model]
    ends = [run["distance_to_goal_cm"] for run in runs]
    collided = sum(run["collided"] for run in runs)
    arrived = sum(run["goal_reached"] and not run["collided"] for run in runs)
    if not ends:
        return "none executed"
    return (
        f"{arrived} of {len(ends)} arrive, {collided} collided;"
        f" {min(ends):.1f}–{max(ends):.1f} cm, mean {sum(ends) / len(ends):.1f}"
    )


def rows(summary):
    evaluation, bench = summary["evaluation"], summary["bench"]
    network, reduction = evaluation["network"], evaluation["reduction_percent"]

    def speed(model):
        single = round(bench[model]["single"]["queries_per_s"], -3)
        batch = round(bench[model]["batch"]["queries_per_s"], -3)
        return f"{single:_.0f} one by one, {batch:_.0f} in batches".replace("_", " ")

    return [
        ("executed no-load plans: arrivals, distance to the goal", "3.3–14.9 cm, one collided",
         distances(summary["executions"], "no_load")),
        ("executed network plans", "1.0–6.4 cm, none collided",
         distances(summary["executions"], "network")),
        ("no-load model, end-effector error on 100 random motions",
         "16.2 ± 8.8 cm, 0.61 ± 0.48 rad", spread(evaluation["no_load"]["open_loop"])),
        ("network model, open loop", "5.8 ± 4.7 cm, 0.16 ± 0.13 rad", spread(network["open_loop"])),
        ("network model, corrected at every motion's start", "",
         spread(network["per_motion"])),
        ("reduction by the network, open loop", "62 %, 73 %",
         f"{reduction['position']:.0f} %, {reduction['orientation']:.0f} %"),
        ("queries per second, no-load model", "978", speed("no_load")),
        ("queries per second, network model", "510", speed("network")),
    ]


def table(summary):
    lines = ["| | the paper, its hardware arm | limber, its virtual arm |", "|---|---|---|"]
    return "\n".join(lines + [f"| {' | '.join(row)} |" for row in rows(summary)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("summary", type=pathlib.Path, help="summary.json of a demo run")
    parser.add_argument("--write", type=pathlib.Path, metavar="README", help="file to change")
    arguments = parser.parse_args()
    text = table(json.loads(arguments.summary.read_text(encoding="utf-8")))
    if arguments.write is None:
        print(text)
        return
    page = arguments.write.read_text(encoding="utf-8")
    pattern = re.compile(rf"({re.escape(BEGIN)}[^\n]*\n).*?({re.escape(END)})", flags=re.S)
    changed, count = pattern.subn(lambda match: f"{match[1]}{text}\n{match[2]}", page)
    if count != 1:
        parser.error(f"{arguments.write}: {count} sections '{BEGIN}…'; expected one")
    arguments.write.write_text(changed, encoding="utf-8")


if __name__ == "__main__":
    main()
