#!/usr/bin/env python3
"""Breaks limber on purpose, line by line, and tells which test notices.

    tools/mutation_check.py --by-hand                       central lines, broken by hand
    tools/mutation_check.py --draw 200 --seed 1 --modules arm world
    tools/mutation_check.py --self-check                    the lines broken by hand still stand

Each change is made in a copy of the tree under --work, never in the tree itself, and built there. Test programs run
until one fails: the module's own first, then those of modules that link it. Results go to --out, one JSON line per
change; with --resume those in there are not tried again. --draw draws from all of MODULES, whatever --modules picks of
it. Tests run in a process namespace of their own, where that is allowed: a broken line may kill what it should not.
"""

import argparse
import collections
import dataclasses
import json
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys

from source_copy import copy_sources

ROOT = pathlib.Path(__file__).resolve().parents[1]
MODULES = ("arm", "world", "forward", "certificate", "driver", "run", "planning")  # drawn from; fast tests first
PROGRAMS = ("common", "arm", "world", "forward", "certificate", "planning", "run", "driver", "sim")  # low to high
SKIPPED = {"src/driver/child_process.cpp"}  # sends signals: a broken line could reach any process
MAX_MEMORY_B = 6 << 30  # of a test program; a broken loop may ask for more
SLOWER = 3.0  # times the unbroken program's processor time, and MIN_TIME_S at least: more is a failure too
MIN_TIME_S = 20.0
WAITING = 20.0  # times that in all, for programs that hang: other work on the machine is no failure


@dataclasses.dataclass(frozen=True)
class Mutation:
    file: str
    line: int  # from 1; 0: by hand, wherever `old` stands
    column: int
    old: str
    new: str
    why: str = ""

    @property
    def name(self):
        return f"{self.file}:{self.line}:{self.column} {self.old!r} -> {self.new!r}"

    @property
    def module(self):
        return self.file.split("/")[1]

    def applied_to(self, text):
        if self.line == 0:
            return text.replace(self.old, self.new)
        lines = text.splitlines(keepends=True)
        line = lines[self.line - 1]
        assert line[self.column:].startswith(self.old), self.name
        lines[self.line - 1] = line[:self.column] + self.new + line[self.column + len(self.old):]
        return "".join(lines)


def by_hand(file, old, new, why):
    return Mutation(file, 0, 0, old, new, why)


BY_HAND = (
    by_hand("src/arm/no_load_model.cpp", "e / (s.width_m * (1.0 - 0.5 * e));", "e / (s.width_m * (1.0 + 0.5 * e));",
            "a sign in (3)"),
    by_hand("src/arm/jacobian.cpp", "magnitude = 2.0 * s.length_m", "magnitude = s.length_m", "a factor in (6)"),
    by_hand("src/forward/motion_simulator.cpp", "  for (int k = 1; k <= count && is_free; ++k) {",
            "  for (int k = 1; k < count && is_free; ++k) {", "a motion's last frame is left out"),
    by_hand("src/world/collision.cpp", "* BroadPhase::kGaps; first >= 0;", "* BroadPhase::kGaps; first > 0;",
            "the gaps beside the base are not looked at"),
    by_hand("src/driver/calibration/wire_calibration.cpp", "from_origin.dot(plane.y_axis)",
            "from_origin.dot(plane.normal())", "a swapped axis of the tracker's plane"),
    by_hand("src/sim/arm_physics.cpp", "friction_.coefficient(speed_m_per_s) * link.mass_kg",
            "0.0 * friction_.coefficient(speed_m_per_s) * link.mass_kg", "the table has no friction"),
    by_hand("src/driver/calibration/tracker_units.cpp", '{"mm", 0.001}', '{"mm", 0.01}', "a wrong unit"),
    by_hand("src/common/atomic_file.cpp", "!write_all(file.get(), content) || !sync(file.get())",
            "!write_all(file.get(), content)", "a file is renamed before it is on disk"),
    by_hand("src/world/inverse_kinematics.cpp", ".cwiseMax(low_).cwiseMin(high_)", ".cwiseMax(low_)",
            "curvatures beyond their upper limit"),
    by_hand("src/planning/search/batch_search.cpp", "RandomStream random(seed_, kSearchStream",
            "RandomStream random(1, kSearchStream", "the same search whatever the seed"),
    by_hand("src/certificate/exact_arm.cpp", "away * std::exp(-left_s / law.time_constant_s)",
            "away * std::exp(-left_s / (2.0 * law.time_constant_s))", "valves take twice their time constant"),
    by_hand("src/forward/error_room.cpp", "plate_radius_m.push_back(level.factor * scale);",
            "plate_radius_m.push_back(scale);", "a tube's radius without its level's factor"),
)

# clang-format puts blanks around binary operators and none into template brackets, so that text alone tells them apart.
SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " += ": " -= ", " -= ": " += ", " < ": " <= ",
         " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && ",
         "std::min(": "std::max(", "std::max(": "std::min(", "cwiseMin(": "cwiseMax(", "cwiseMax(": "cwiseMin("}
SWAP = re.compile("|".join(sorted(map(re.escape, SWAPS), key=len, reverse=True)))
SIGN = re.compile(r"(?<=[(,?:=] )-(?=[A-Za-z(])|(?<=[({\[])-(?=[A-Za-z(])|(?<=return )-(?=[A-Za-z(])")
NUMBER = re.compile(r"(?<![\w.<'])(\d+(?:\.\d*)?(?:e-?\d+)?)(F|U|L)?(?![\w.>'])")
CONDITION = re.compile(r"\bif \(")
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*'
                    r"|\b(?:static_)?assert\((?:[^;]*);|\btemplate <[^\n]*", re.S | re.M)


def hidden(text):
    """The text with blanks for what no change is drawn from: comments, strings, includes, assertions."""
    return HIDDEN.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)


def other_number(number, suffix):
    if re.fullmatch(r"\d+", number):
        return f"{int(number) + 1}{suffix}"
    value = float(number)
    return f"{2.0 * value if value else 1.0!r}{suffix}"


def closing(line, start):
    """Where the bracket that opens at `start` closes; −1: on a later line."""
    depth = 0
    for i in range(start, len(line)):
        depth += {"(": 1, ")": -1}.get(line[i], 0)
        if depth == 0:
            return i
    return -1


def mutations_of_line(file, number, line, whole):
    """@param line  the whole line, without what is hidden"""
    for found in SWAP.finditer(line):
        yield Mutation(file, number, found.start(), found.group(), SWAPS[found.group()])
    for found in SIGN.finditer(line):
        yield Mutation(file, number, found.start(), "-", "")
    for found in NUMBER.finditer(line):
        new = other_number(found.group(1), found.group(2) or "")
        yield Mutation(file, number, found.start(), found.group(), new)
    for found in CONDITION.finditer(line):
        start = found.end() - 1
        end = closing(line, start)
        if end > 0 and " = " not in line[start:end]:
            old = whole[start:end + 1]
            yield Mutation(file, number, start, old, f"(!{old})")


def all_mutations():
    for module in MODULES:
        for path in sorted((ROOT / "src" / module).rglob("*.?pp")):
            file = path.relative_to(ROOT).as_posix()
            if file in SKIPPED or "/include/" in file or "/internal/" in file:
                continue  # a shared header would have everything built again
            text = path.read_text(encoding="utf-8")
            for number, lines in enumerate(zip(hidden(text).splitlines(), text.splitlines()), 1):
                yield from mutations_of_line(file, number, *lines)


def drawn(count, seed):
    """In the order of MODULES."""
    found = random.Random(seed).sample(list(all_mutations()), count)
    return sorted(found, key=lambda m: MODULES.index(m.module))


class Tree:
    """A copy of the working tree, built on its own."""

    def __init__(self, work, jobs, programs):
        self.source, self.build, self.jobs, self.programs = work / "source", work / "build", jobs, programs
        self.times_s = {}
        copy_sources(ROOT, self.source)
        alone = ["unshare", "--pid", "--fork", "--kill-child", "--mount-proc"]
        self.alone = alone if shutil.which(alone[0]) and self.run([*alone, "true"]).returncode == 0 else []
        if not (self.build / "build.ninja").exists():
            # ccache finds what is built again after a change only if it may look into precompiled headers.
            self.run(["cmake", "--preset", "test", "-S", self.source, "-B", self.build, "-DCMAKE_UNITY_BUILD=OFF",
                      "-DCMAKE_CXX_FLAGS=-fpch-preprocess", "-DCMAKE_CXX_FLAGS_DEBUG=-O1"], check=True)
        self.below = {}  # of a module, those that it links, and those that they link
        for line in (self.build / "module_links.txt").read_text(encoding="utf-8").splitlines():
            module, links = line.split(":")
            self.below[module] = set().union(*(({m} | self.below.get(m, set())) for m in links.split())) \
                if links.split() else set()

    def run(self, command, **options):
        return subprocess.run(command, cwd=self.source, capture_output=True, text=True, errors="replace", **options)

    def ninja(self, target):
        return self.run(["ninja", f"-j{self.jobs}", "-C", self.build, target]).returncode == 0

    def programs_for(self, module):
        """Its own, then those above it."""
        return [p for p in self.programs if p == module or module in self.below[p]]

    def test(self, program, max_s=None):
        """None if all tests pass, else the first that does not."""
        path = next((self.build / "bin").glob(f"{program}_test"))
        def limit():
            resource.setrlimit(resource.RLIMIT_DATA, (MAX_MEMORY_B, MAX_MEMORY_B))
            if max_s:
                resource.setrlimit(resource.RLIMIT_CPU, (int(max_s) + 1, int(max_s) + 1))

        try:
            ended = self.run([*self.alone, path, "--gtest_fail_fast"], preexec_fn=limit,
                             timeout=WAITING * max_s if max_s else None)
        except subprocess.TimeoutExpired as expired:
            output = (expired.stdout or b"").decode(errors="replace")
            return f"{last_test(output)} (hangs)"
        if ended.returncode == 0:
            return None
        failed = re.search(r"^\[  FAILED  \] ([\w/.]+)", ended.stdout, re.M)
        return failed.group(1) if failed else f"{last_test(ended.stdout)} (crash or out of time)"

    def measure(self, program):
        """Builds the program without a change; its tests must pass. What it may take with one."""
        if program not in self.times_s:
            if not self.ninja(f"{program}_test"):
                sys.exit(f"error: {program}_test can't be built")
            start_s = processor_time_s()
            failed = self.test(program)
            self.times_s[program] = processor_time_s() - start_s
            if failed:
                sys.exit(f"error: {program}_test fails without a change: {failed}")
        return max(MIN_TIME_S, SLOWER * self.times_s[program])

    def outcome(self, mutation):
        file = self.source / mutation.file
        text = file.read_text(encoding="utf-8")
        for program in self.programs_for(mutation.module):
            max_s = self.measure(program)
            try:
                file.write_text(mutation.applied_to(text), encoding="utf-8")
                if not self.ninja(f"limber_{mutation.module}"):
                    return "not compiled", ""
                # A build that fails here is a program that can't even list its tests.
                failed = self.test(program, max_s) if self.ninja(f"{program}_test") else "listing its tests"
            finally:
                file.write_text(text, encoding="utf-8")
            if failed:
                return "caught", f"{program}_test: {failed}"
        return "survived", ""


def processor_time_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def last_test(output):
    started = re.findall(r"^\[ RUN      \] ([\w/.]+)", output, re.M)
    return started[-1] if started else "before the first test"


def self_check():
    """What is wrong with the list of changes by hand, a line each."""
    for mutation in BY_HAND:
        path = ROOT / mutation.file
        count = path.read_text(encoding="utf-8").count(mutation.old) if path.exists() else 0
        if count != 1:
            yield f"{mutation.file}: {mutation.old!r} stands there {count} times; expected once ({mutation.why})"


def table(results):
    counts = collections.defaultdict(collections.Counter)
    for result in results:
        counts[result["module"]][result["outcome"]] += 1
    print("\n| module | drawn | not compiled | caught | survived |\n|---|---|---|---|---|")
    counts["all"] = sum(counts.values(), collections.Counter())
    for module, count in counts.items():
        print(f"| {module} | {count.total()} | {count['not compiled']} | {count['caught']} | {count['survived']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--self-check", action="store_true")
    parser.add_argument("--by-hand", action="store_true")
    parser.add_argument("--draw", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--modules", nargs="+", help="of what is broken by hand or drawn, these alone")
    parser.add_argument("--programs", nargs="+", default=PROGRAMS, help="whose tests run, low modules first")
    parser.add_argument("--list", action="store_true", help="shows the changes, and makes none")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "mutations")
    parser.add_argument("--out", type=pathlib.Path, help="default: mutations.jsonl under --work")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("--jobs", type=int, default=1, help="of the compiler")
    options = parser.parse_args()
    faults = list(self_check())
    if faults or options.self_check:
        sys.exit("\n".join(faults) or 0)
    mutations = [m for m in list(BY_HAND) * options.by_hand + drawn(options.draw, options.seed)
                 if not options.modules or m.module in options.modules]
    if options.list:
        print("\n".join(m.name for m in mutations))
        return
    out = options.out or options.work / "mutations.jsonl"
    known = {}
    if options.resume and out.exists():
        known = {r["name"]: r for r in map(json.loads, out.read_text(encoding="utf-8").splitlines())}
    tree = Tree(options.work.resolve(), options.jobs, options.programs)
    results = []
    for mutation in mutations:
        if mutation.name not in known:
            outcome, test = tree.outcome(mutation)
            known[mutation.name] = {"name": mutation.name, "module": mutation.module, "why": mutation.why,
                                    "outcome": outcome, "test": test}
            with out.open("a" if options.resume or results else "w", encoding="utf-8") as lines:
                lines.write(json.dumps(known[mutation.name]) + "\n")
        results.append(known[mutation.name])
        print(f"{results[-1]['outcome']:12} {mutation.why or mutation.name}  {results[-1]['test']}", flush=True)
    table(results)


if __name__ == "__main__":
    main()
