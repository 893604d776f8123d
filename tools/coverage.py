#!/usr/bin/env python3
"""Tells which lines and branches of the library the tests reach.

    tools/coverage.py                         unit tests, by module
    tools/coverage.py --tests 'unit|system'   labels of ctest, as a regular expression
    tools/coverage.py --corpora               what the fuzz targets' own inputs reach of the readers, by file
    tools/coverage.py --uncovered world       after one of these: the lines of a module that nothing reached

Builds the preset `coverage` (clang 14, apt-get install clang-14 llvm-14 libclang-rt-14-dev). A process that is killed
counts nothing, nor does a child that ends without leaving main, so the figures are lower bounds. Branches are those
that the source names; clang counts none for exceptions.
"""

import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/coverage"
PROFILES = BUILD / "profiles"
PROFILE = BUILD / "all.profdata"
# What reads bytes from outside: the part of the library that the fuzz targets are there for.
READERS = tuple(
    f"src/{name}" for name in (
        "arm/arm_description.cpp", "arm/arm_commands.cpp", "arm/bench_csv.cpp", "arm/valve_file.cpp",
        "common/csv_reader.cpp", "common/json_reader.cpp", "common/safetensors.cpp", "common/yaml_reader.cpp",
        "data/checked_hdf5.cpp", "data/recording_reader.cpp", "driver/calibration/wire_calibration_file.cpp",
        "driver/driver_protocol.cpp", "driver/line_reader.cpp", "lab/campaign/campaign_file.cpp", "lab/trial_file.cpp",
        "logs/", "network/model_file.cpp", "planning/forest/forest_file.cpp", "planning/planner_name.cpp",
        "run/tracking/tip_path.cpp", "studio/connections.cpp", "studio/request_rules.cpp", "studio/scene_json.cpp",
        "training/checkpoint.cpp", "training/cross_validation_file.cpp", "world/environment_reader.cpp",
        "world/plan_file.cpp"))


def run(*command, environment=None, may_fail=False):
    done = subprocess.run(list(map(str, command)), cwd=ROOT, env=environment, check=False)
    if done.returncode != 0 and not may_fail:
        sys.exit(f"error: {' '.join(map(str, command))}: ended with {done.returncode}")


def objects():
    """Everything instrumented that was built, as llvm-cov wants it: one binary, the others as -object."""
    names = sorted(path for path in (BUILD / "bin").iterdir() if path.is_file() and os.access(path, os.X_OK))
    if not names:
        sys.exit(f"error: no program in {BUILD / 'bin'}: run tools/coverage.py without --uncovered first")
    return [names[0], *(word for name in names[1:] for word in ("-object", name))]


def measure(what):
    PROFILES.mkdir(parents=True, exist_ok=True)
    for old in PROFILES.iterdir():
        old.unlink()
    # Processes of one binary add to one of four files.
    environment = dict(os.environ, LLVM_PROFILE_FILE=str(PROFILES / "%4m.profraw"))
    what(environment)
    run("llvm-profdata-14", "merge", "-sparse", "-o", PROFILE, *sorted(PROFILES.iterdir()))


def run_tests(labels):
    def of(environment):
        # A test that fails is told of, and what it reached counts.
        run("ctest", "--preset", "coverage", "-L", labels, "-j", os.cpu_count(), environment=environment, may_fail=True)
    return of


def run_corpora(environment):
    replay = BUILD / "bin/limber_fuzz_replay"
    for target in subprocess.run([replay], stdout=subprocess.PIPE, text=True, check=True).stdout.split():
        run(replay, target, environment=environment)


def files():
    """Path below src → (lines, lines reached, branches, branches reached)."""
    text = subprocess.run(
        ["llvm-cov-14", "export", "-summary-only", f"-instr-profile={PROFILE}", *objects()], cwd=ROOT,
        stdout=subprocess.PIPE, check=True).stdout
    found = {}
    for entry in json.loads(text)["data"][0]["files"]:
        path = pathlib.Path(entry["filename"])
        if path.is_relative_to(ROOT / "src"):
            summary = entry["summary"]
            found[str(path.relative_to(ROOT))] = tuple(
                summary[kind][number] for kind in ("lines", "branches") for number in ("count", "covered"))
    return found


def print_table(title, counts):
    def share(of, reached):
        return f"{100 * reached / of:.1f} %" if of else "–"

    print(f"| {title} | lines | reached | branches | reached |\n|---|---|---|---|---|")
    total = [sum(column) for column in zip(*counts.values())]
    for name, (lines, lines_reached, branches, branches_reached) in [*sorted(counts.items()), ("all", total)]:
        print(f"| {name} | {lines} | {share(lines, lines_reached)} | {branches} | {share(branches, branches_reached)} |")


def by_module(found):
    counts = collections.defaultdict(lambda: (0, 0, 0, 0))
    for path, numbers in found.items():
        module = path.split("/")[1]
        counts[module] = tuple(map(sum, zip(counts[module], numbers)))
    return counts


def print_uncovered(module):
    sources = sorted((ROOT / "src" / module).rglob("*.[ch]pp"))
    if not sources:
        sys.exit(f"error: no module {module} in src")
    text = subprocess.run(["llvm-cov-14", "show", f"-instr-profile={PROFILE}", *objects(), *sources], cwd=ROOT,
                          stdout=subprocess.PIPE, text=True, check=True).stdout
    shown = ""
    for line in text.splitlines():
        if line.endswith(":") and "|" not in line:
            shown = line[len(str(ROOT)) + 1:-1]
            continue
        columns = line.split("|", 2)
        if len(columns) == 3 and columns[1].strip() == "0":
            print(f"{shown}:{columns[0].strip()}: {columns[2].strip()}")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--tests", default="unit", help="labels of the tests to run")
    arguments.add_argument("--corpora", action="store_true", help="instead of tests: the fuzz targets' own inputs")
    arguments.add_argument("--uncovered", metavar="MODULE", help="of the last measurement: lines that nothing reached")
    chosen = arguments.parse_args()
    if chosen.uncovered:
        print_uncovered(chosen.uncovered)
        return
    run("cmake", "--preset", "coverage")
    run("cmake", "--build", "--preset", "coverage")
    measure(run_corpora if chosen.corpora else run_tests(chosen.tests))
    found = files()
    if chosen.corpora:
        print_table("reader", {path: numbers for path, numbers in found.items() if path.startswith(READERS)})
    else:
        print_table("module", by_module(found))


if __name__ == "__main__":
    main()
