#!/usr/bin/env python3
"""The paper's tables and figures, run again: what docs/reproduction.md shows.

    PYTHONPATH=build/release/python tools/reproduction.py --limber build/release/bin/limber \\
        --model model.safetensors --out OUT [--parts queries figure_1 table_1 random_1 ...]

--model is the network of Table I. Readings of the paper's training, and its Fig. 4, are in
tools/reproduction_readings.py. Every part lies in OUT; parts that are finished are not run again, and a table that was
stopped goes on. Table I takes some five minutes of one core, so often as it is made.
"""

import argparse
import pathlib
import re

import limber
import numpy as np
from kept_parts import KeptParts

TABLE_SEED = 1_600_002
RANDOM_SEED = 1_600_003
RANDOM_ENVIRONMENTS = 40
NO_MARGINS = ("--margin-m", 0, "--goal-margin-m", 0, "--goal-margin-rad", 0)  # the paper keeps none
CM = 100.0
MODELS = ("no_load", "network")
KPA_PER_PSI = 6.894757
QUERIES = 510 * 600  # what the paper's ten minutes allowed its network


class Reproduction(KeptParts):
    def __init__(self, options):
        super().__init__(options.limber, options.out)
        self.options = options
        self.arm = limber.load_arm(options.arm)

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

    def table(self, name):
        """Table I: both models, planned and executed, in limber's own environments or in random ones."""
        planner = "paper,valves=1" if name.endswith("valves") else "paper"
        where = (("--trials", self.options.trials) if name.startswith("table") else
                 ("--trials", 2, "--environments", self.random_environments(RANDOM_SEED, RANDOM_ENVIRONMENTS)))
        environments = {}
        for trial in self.trials(self.out / name, "--arm", self.options.arm, "--model", self.options.model,
                                 "--planner", planner, "--max-queries", self.options.queries, "--seed", TABLE_SEED,
                                 "--jobs", self.options.jobs, *NO_MARGINS, *where):
            run = trial["execution"]
            of = environments.setdefault(trial["environment"], {model: [] for model in MODELS})
            of[trial["model"]].append(run and {
                "arrived": run["goal_reached"] and not run["collided"], "collided": run["collided"],
                "distance_cm": run["distance_to_goal_cm"], "cost_kpa": trial["cost_kpa"]})
        return {"queries": self.options.queries, "environments": dict(sorted(environments.items()))}


def table_rows(results):
    """A line for each environment, and for all: solved, arrive, collide, distance and cost of both models."""
    environments = results["environments"]
    whole = {model: [trial for of in environments.values() for trial in of[model]] for model in MODELS}
    for name, of in {**environments, "all": whole}.items():
        cells = [name]
        for model in MODELS:
            trials = of[model]
            runs = [trial for trial in trials if trial is not None]
            cells.append(f"{len(runs)}" + (f" of {len(trials)}" if name == "all" else ""))
            if runs:
                ends = np.array([run["distance_cm"] for run in runs])
                cells += [str(sum(run["arrived"] for run in runs)), str(sum(run["collided"] for run in runs)),
                          f"{ends.mean():.1f}", f"{np.mean([run['cost_kpa'] for run in runs]) / KPA_PER_PSI:.1f}"]
            else:
                cells += ["–"] * 4
        yield cells


def print_table(results, whole):
    """Of each environment, or their sum alone."""
    head = "solved | arrive | collide | distance, cm | cost, psi"
    print(f"| environment | no-load model: {head} | network: {head} |")
    print("|---" * 11 + "|")
    for cells in table_rows(results):
        if whole or cells[0] == "all":
            print("| " + " | ".join(cells) + " |")


def draw_figure_5(path, folder, columns=4):
    """The paper's Fig. 5: where the first plans of both models bring the arm, an environment beside the other."""
    pictures = [file.read_text(encoding="utf-8") for file in sorted(folder.glob("*.svg")) if not file.stem.endswith("_all")]
    sizes = [[float(number) for number in re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', text).groups()] for text in pictures]
    width, height = (max(size[k] for size in sizes) for k in (0, 1))
    placed = [text.replace("<svg ", f'<svg x="{width * (k % columns):g}" y="{height * (k // columns):g}" ', 1)
              for k, text in enumerate(pictures)]
    box = f"0 0 {width * columns:g} {height * -(-len(pictures) // columns):g}"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">\n{"".join(placed)}</svg>\n', encoding="utf-8")


PARTS = ["queries", "figure_1", "table_1", "table_1_valves", "random_1", "random_1_valves"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--arm", default="arms/three_segment.yaml")
    parser.add_argument("--model", type=pathlib.Path, help="network of Table I")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--trials", type=int, default=20, help="of Table I, in each environment")
    parser.add_argument("--queries", type=int, default=QUERIES, help="of the model, for each plan")
    parser.add_argument("--whole", action="store_true", help="of random environments each, not their sum alone")
    parser.add_argument("--print", action="store_true", help="only what is there already")
    parser.add_argument("--jobs", type=int, default=2, help="plans at once")
    parser.add_argument("--picture", type=pathlib.Path, help="Fig. 5 as SVG, of part table_1")
    options = parser.parse_args()
    if not options.print and options.model is None and any("_1" in part and part != "figure_1" for part in options.parts):
        parser.error("--model is needed for Table I")
    run = Reproduction(options)
    for part in options.parts:
        if options.print and not run.has(part):
            continue
        if part == "queries":
            found = run.queries()
            for name in ("no_load", "network"):
                print(f"{name}: {found[name]['single']['queries_per_s']:.0f} queries per second, one at "
                      f"a time; {found[name]['batch']['queries_per_s']:.0f} in batches of "
                      f"{found[name]['batch']['size']}")
        elif part == "figure_1":
            print(f"tip {run.figure_1()['tip_from_straight_cm']:.1f} cm from straight")
        else:
            print(f"\n{part}:\n")
            print_table(run.kept(part, lambda part=part: run.table(part)), options.whole or part.startswith("table"))
    if options.picture:
        draw_figure_5(options.picture, options.out / "table_1" / "figures")


if __name__ == "__main__":
    main()
