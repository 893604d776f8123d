#!/usr/bin/env python3
"""Measures import's check of columns and signs (docs/importing.md) on logs of virtual arms.

    tools/log_check_figures.py --limber build/release/bin/limber --logs 200 --seed 1

Each log is of an arm of its own, drawn by seed: 1 to 8 segments, friction 0.1 to 0.4, valve lags 0.1
to 0.5 s, lengths +-10 %; 45 to 180 s of motion, set points that jump or move slowly, and noise. It is
imported as it is, mirrored, with one segment mirrored, and (from two segments on) permuted. Right is: the good log is accepted; each other one is refused, and
the order and signs that the message names undo what was done; segments that hardly moved are named.
One line per log that went wrong, then the counts, as JSON on standard output. Exit code 1 where a good
log was refused or a bad one accepted.
"""

import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
POLYNOMIAL = "[0.001642865, 3.72381e-05, -5.072633e-07, 1.740553e-09]"
MOST_SEGMENTS = 8
ARM_LENGTH_M = 0.7
NOISE = ["--noise-m", "0.0005", "--noise-rad", "0.004", "--noise-kpa", "1"]


def drawn_arm(draw, segments):
    """An arm file: lengths, widths, friction, lags and strengths drawn."""
    lines = [
        "schema: limber/arm/1", "name: drawn", "frame_rate_hz: 20",
        "pressure_rate_limit_kpa_per_s: 100", "actuator_radius_m: 0.006", "segments:",
    ]
    width_m = 0.05
    for _ in range(segments):
        length_m = max(0.08, ARM_LENGTH_M / max(segments, 3)) * draw.uniform(0.9, 1.1)
        gaps = max(2, round(length_m / 0.047))
        lines.append(
            f"  - {{length_m: {length_m:.4f}, width_m: {width_m:.4f}, gaps: {gaps}, "
            f"pressure_limit_kpa: 100, strain_polynomial: {POLYNOMIAL}}}"
        )
        width_m = max(0.0172, width_m * draw.uniform(0.65, 0.95))
    text = (ROOT / "arms" / "three_segment.yaml").read_text(encoding="utf-8")
    physics = text[text.index("virtual_arm:"):]
    lag_s = draw.uniform(0.1, 0.5)
    for key, value in {
        "friction_coefficient": draw.uniform(0.1, 0.4),
        "strength_seed": draw.randrange(1, 10_000),
        "inflate_time_constant_s": lag_s,
        "vent_time_constant_s": 1.2 * lag_s,
    }.items():
        physics, count = re.subn(rf"(\n  {key}:) \S+", rf"\1 {value:.6g}", physics)
        assert count == 1, key
    return "\n".join(lines) + "\n" + physics


def columns_of(mapping):
    """The names in the mapping's line of pressure columns."""
    return re.search(r"\n  columns: \[(.*)\]", mapping).group(1).split(", ")


def with_columns(mapping, names):
    return re.sub(r"(\n  columns: )\[.*\]", rf"\1[{', '.join(names)}]", mapping, count=1)


class Log:
    """One drawn arm's log as CSV, and what import makes of it."""

    def __init__(self, limber, folder, seed):
        self.limber = limber
        self.folder = folder
        draw = random.Random(seed)
        self.segments = seed % MOST_SEGMENTS + 1
        (folder / "arm.yaml").write_text(drawn_arm(draw, self.segments), encoding="utf-8")
        slow = draw.random() < 0.5
        hold_s = draw.uniform(0.5, 2.0)
        count = round(draw.uniform(45, 180) / (hold_s + 1.5))
        motions = ["--hold-s", f"{hold_s:.2f}", "--hold-min-s", "0.2"]
        motions += ["--approach", "straight"] if slow else []
        self.run("collect", "--schedule", "random", "--count", count, "--seed", seed + 1, *motions,
                 *NOISE, "--out", "log.h5")
        self.run("export", "log.h5", "--csv", "log")
        self.mapping = (folder / "log" / "mapping.yaml").read_text(encoding="utf-8")
        self.columns = columns_of(self.mapping)
        self.order = list(range(self.segments))
        while self.segments > 1 and self.order == list(range(self.segments)):
            draw.shuffle(self.order)
        self.mirrored = draw.randrange(self.segments)

    def run(self, verb, *arguments):
        arm = [] if verb == "export" else ["--arm", "arm.yaml"]
        result = subprocess.run(
            [self.limber, verb, *map(str, arguments), *arm], cwd=self.folder, capture_output=True,
            encoding="utf-8", check=False,
        )
        if result.returncode not in (0, 2) or (result.returncode == 2 and verb != "import"):
            sys.exit(f"limber {verb}: {result.stderr}")
        return result

    def cases(self):
        """Names of the columns as a wrong mapping has them, by what is wrong with it."""
        names = self.columns
        one = [f"-{n}" if i == self.mirrored else n for i, n in enumerate(names)]
        cases = {"good": names, "mirrored": [f"-{name}" for name in names], "one mirrored": one}
        if self.segments > 1:
            cases["permuted"] = [names[i] for i in self.order]
        return cases

    def imported(self, names):
        """Import's JSON, or its message."""
        (self.folder / "map.yaml").write_text(with_columns(self.mapping, names), encoding="utf-8")
        result = self.run("import", "csv", "log/episode_000.csv", "--mapping", "map.yaml",
                          "--dry-run", "--json")
        if result.returncode == 0:
            return json.loads(result.stdout), None
        return None, result.stderr


def look(log, counts):
    """Faults of one log's cases, counted."""
    faults = []
    accepted, message = log.imported(log.columns)
    undecidable = set()
    if accepted is None:
        faults.append(f"good: refused: {message.strip()}")
    else:
        segments = accepted["columns"]
        undecidable = {i for i, segment in enumerate(segments) if segment["undecidable"]}
        counts["segments"] += len(segments)
        counts["undecidable_segments"] += len(undecidable)
        counts["weak_segments"] += sum(segment["follows_weakly"] for segment in segments)
    for case, names in log.cases().items():
        counts[case]["logs"] += 1
        if case == "good":
            counts[case]["refused"] += accepted is None
            continue
        touched = {i for i, name in enumerate(names) if name != log.columns[i]}
        again, message = log.imported(names)
        if again is None:
            counts[case]["refused"] += 1
            fits = re.search(r"'columns: \[(.*?)\]'", message)
            counts[case]["mended"] += bool(fits) and fits.group(1).split(", ") == log.columns
        elif touched <= undecidable:
            counts[case]["undecidable"] += 1
        else:
            faults.append(f"{case}: accepted ({sorted(touched)}, undecidable {sorted(undecidable)})")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--limber", type=pathlib.Path, default=ROOT / "build/release/bin/limber")
    parser.add_argument("--logs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    counts = {"segments": 0, "undecidable_segments": 0, "weak_segments": 0}
    for case in ("good", "mirrored", "one mirrored", "permuted"):
        counts[case] = {"logs": 0, "refused": 0}
        if case != "good":
            counts[case].update({"undecidable": 0, "mended": 0})
    wrong = 0
    for number in range(options.logs):
        seed = options.seed * 100_003 + number
        with tempfile.TemporaryDirectory(prefix="limber_logs_") as folder:
            log = Log(options.limber.resolve(), pathlib.Path(folder), seed)
            for fault in look(log, counts):
                wrong += 1
                print(f"seed {seed}, {log.segments} segments: {fault}", file=sys.stderr)
    print(json.dumps(counts, indent=1))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
