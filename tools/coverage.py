#!/usr/bin/env python3
"""Which lines and branches of the library the unit tests reach, and which lines of the readers the fuzz corpora do.

    tools/coverage.py                  builds the preset coverage, runs the unit tests and the corpora, prints two tables
    tools/coverage.py --tables         prints them again, of what was run before
    tools/coverage.py --lines FILE     names the lines of a source that no test reaches

It wants clang-14, llvm-14 and libclang-rt-14-dev. Branches are those of conditions; those that an exception takes are
not counted. The build has the address and undefined-behaviour sanitizers, so the run is also theirs.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build" / "coverage"
REPLAY = BUILD / "bin" / "limber_fuzz_replay"
PROFILES = BUILD / "profiles"
WANTED = ("clang++-14", "llvm-cov-14", "llvm-profdata-14")
# What turns bytes from outside into values: the sources that the targets of fuzz/ are there for.
READERS = re.compile(
    r"src/(arm/(arm_description|arm_file|valve_file|bench_csv)\w*|common/(csv_reader|json_reader|yaml_reader|safetensors)"
    r"|data/recording_(reader|pipe|inspection)|driver/(driver_protocol|line_reader|calibration/wire_calibration_file)"
    r"|lab/(campaign/campaign_file|trial_file)|logs/\w+|network/model_file\w*|planning/(forest/forest_file|planner_factory)"
    r"|run/tip_path\w*|studio/(http|request|scene_json)\w*|training/(checkpoint|cross_validation_file)"
    r"|world/(environment_reader|plan_file))\.cpp$")


def environment(kind):
    """Profiles are merged as they are written, by four processes at most at a time."""
    libraries_leak = "detect_leaks=1:detect_stack_use_after_return=0:use_sigaltstack=0"
    return os.environ | {"LLVM_PROFILE_FILE": str(PROFILES / kind / "%4m.profraw"), "ASAN_OPTIONS": libraries_leak,
                         "LSAN_OPTIONS": f"suppressions={ROOT / 'tests' / 'lsan.supp'}:print_suppressions=0"}


def run_tests(arguments):
    return subprocess.run(["ctest", "--preset", "coverage", "-L", "unit", "--no-tests=error", *arguments], cwd=ROOT,
                          env=environment("tests")).returncode


def run_corpora():
    targets = subprocess.run([REPLAY], capture_output=True, text=True, check=True).stdout.split()
    codes = [subprocess.run([REPLAY, target], cwd=BUILD, env=environment("corpora"), stdout=subprocess.DEVNULL).returncode
             for target in targets]
    return int(any(codes))


def merged(kind):
    profile = PROFILES / f"{kind}.profdata"
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-o", profile, *(PROFILES / kind).glob("*.profraw")],
                   check=True)
    return profile


def llvm_cov(verb, kind, *arguments):
    programs = [REPLAY, *sorted((BUILD / "bin").glob("*_test"))]
    objects = [words for program in programs for words in ("-object", program)][1:]
    return subprocess.run(["llvm-cov-14", verb, *objects, "-instr-profile", merged(kind), *arguments],
                          capture_output=True, text=True, check=True).stdout


def files(kind):
    """What is counted of each source of the library: {path: {"lines": …, "branches": …}}."""
    exported = json.loads(llvm_cov("export", kind, "-summary-only"))
    found = {os.path.relpath(file["filename"], ROOT): file["summary"] for file in exported["data"][0]["files"]}
    return {path: summary for path, summary in found.items() if path.startswith("src/")}


def share(summaries, what):
    count = sum(summary[what]["count"] for summary in summaries)
    covered = sum(summary[what]["covered"] for summary in summaries)
    return f"{covered} of {count}, {100 * covered / count:.1f} %" if count else "none"


def print_tables():
    by_tests, by_corpora = files("tests"), files("corpora")
    modules = {}
    for path, summary in by_tests.items():
        modules.setdefault(path.split("/")[1], []).append(summary)
    print("| module | lines reached by tests | branches |\n|---|---|---|")
    for name, summaries in [*sorted(modules.items()), ("all", list(by_tests.values()))]:
        print(f"| {name} | {share(summaries, 'lines')} | {share(summaries, 'branches')} |")
    readers = {path: summary for path, summary in by_corpora.items() if READERS.search(path)}
    print("\n| reader | lines reached by the fuzz corpora |\n|---|---|")
    for path, summary in [*sorted(readers.items()), ("all", None)]:
        print(f"| `{path}` | {share([summary], 'lines')} |" if summary else
              f"| all | {share(list(readers.values()), 'lines')} |")


def print_lines(source):
    for line in llvm_cov("show", "tests", str(pathlib.Path(source).resolve())).splitlines():
        number_count_code = line.split("|", 2)
        if len(number_count_code) == 3 and number_count_code[1].strip() == "0":
            print(f"{number_count_code[0].strip()}:{number_count_code[2]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tables", action="store_true", help="print the tables of what was run before")
    parser.add_argument("--lines", metavar="FILE", help="the lines of a source that no test reaches")
    parser.add_argument("ctest", nargs="*", help="further arguments of ctest, behind --")
    arguments = parser.parse_args()
    code = 0
    for program in WANTED:
        if not shutil.which(program):
            sys.exit(f"error: {program} is missing: apt-get install clang-14 llvm-14 libclang-rt-14-dev")
    if arguments.lines:
        print_lines(arguments.lines)
        return 0
    if not arguments.tables:
        subprocess.run(["cmake", "--preset", "coverage"], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", "--preset", "coverage"], cwd=ROOT, check=True)
        shutil.rmtree(PROFILES, ignore_errors=True)  # of another build
        code = int(any([run_tests(arguments.ctest), run_corpora()]))
    print_tables()
    return code


if __name__ == "__main__":
    sys.exit(main())
