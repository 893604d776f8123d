#!/usr/bin/env python3
"""Plants bugs of kinds that real readers had, one after another, and tells whether fuzzing finds them.

    tools/planted_bugs.py --out ~/planted             an hour of processor time, and two dozen builds
    tools/planted_bugs.py --out ~/planted --resume    goes on; parts that are done are kept
    tools/planted_bugs.py --only plan_holds_all_of_its_frames --seconds 600 --skip-unplanted
    tools/planted_bugs.py --dry-run                   every place for a bug is still where it was

The bugs are in planted_bugs.yaml. Each is planted in a copy of the sources under --out, never in the tree itself, and
built there as the preset `fuzz`. libFuzzer starts with the committed corpus and what limber's own writers make, without
fuzz/regressions: those inputs were found before. It ends with the first finding, which counts if the sources without
the bug stand the same input. First these sources have the same time for each target, and nothing may be found in them.
Findings, logs and corpora stay under --out, in runs/NAME.
"""

import argparse
import contextlib
import dataclasses
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import yaml

from kept_parts import KeptParts
from source_copy import copy_sources

ROOT = pathlib.Path(__file__).resolve().parents[1]
COMPILER = "clang++-14"
PROGRAMS = ("limber_fuzz", "limber_fuzz_replay")
LIMITS = ("-timeout=30", "-max_len=8192", "-malloc_limit_mb=1000", "-rss_limit_mb=3000")  # as fuzz/soak.sh
ENVIRONMENT = {**os.environ, "ASAN_OPTIONS": "detect_leaks=0"}  # libhdf5 leaks where it refuses a file
WAITING = 8.0  # times the processor time in all: `http` waits for sockets, and others work, too
LOOK_S = 0.2  # between two looks at the processor time
END_S = 60.0  # until a fuzzer that was asked to end is killed
FINDING = re.compile(r"(crash|oom|timeout)-")  # slow inputs are kept, too, and are none
TARGET = re.compile(r'\{"(\w+)", "[\w.]*", \w+')
EXECUTIONS = re.compile(r"^(?:#|stat::number_of_executed_units: +)(\d+)", re.M)
REPORTS = (r"runtime error: (.{1,90})", r"ERROR: AddressSanitizer: ([\w-]+)", r"Assertion `(.{1,90})",
           r"terminate called after throwing an instance of '(.+)'", r"ERROR: libFuzzer: ([\w -]+)")


@dataclasses.dataclass(frozen=True)
class Bug:
    name: str
    target: str  # that reads the file
    file: str
    like: str
    old: str
    new: str

    @contextlib.contextmanager
    def planted_in(self, source):
        file = source / self.file
        text = file.read_text(encoding="utf-8")
        count = text.count(self.old)
        if count != 1:
            raise ValueError(f"{self.name}: its place stands in {self.file} {count} times; expected once")
        file.write_text(text.replace(self.old, self.new), encoding="utf-8")
        try:
            yield
        finally:
            file.write_text(text, encoding="utf-8")


def all_bugs():
    text = pathlib.Path(__file__).with_suffix(".yaml").read_text(encoding="utf-8")
    return [Bug(**entry) for entry in yaml.safe_load(text)]


def faults(bugs, copy):
    """What keeps bugs from being planted, a line each. Each is planted in the folder `copy`."""
    targets = {name for path in (ROOT / "fuzz").glob("*_targets.cpp")
               for name in TARGET.findall(path.read_text(encoding="utf-8"))}
    for bug in bugs:
        if bug.target not in targets:
            yield f"{bug.name}: no fuzz target '{bug.target}'"
        (copy / bug.file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / bug.file, copy / bug.file)
        try:
            with bug.planted_in(copy):
                pass
        except ValueError as fault:
            yield str(fault)


def processor_s(process):
    """Processor time of one that runs, with that of its children that have ended."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text(encoding="utf-8", errors="replace")
    return sum(map(int, fields.rpartition(")")[2].split()[11:15])) / os.sysconf("SC_CLK_TCK")


def run_until(process, seconds):
    """Until it ends, or has used so much processor time. @return whether it was ended"""
    start_s = time.monotonic()
    while process.poll() is None:
        if processor_s(process) >= seconds or time.monotonic() - start_s >= WAITING * seconds:
            process.send_signal(signal.SIGINT)  # libFuzzer then says what it did
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(END_S)
            process.kill()  # if it still runs
            process.wait()
            return True
        time.sleep(LOOK_S)
    return False


class Campaign:
    """The copy of the sources, its builds, and what was found."""

    def __init__(self, options):
        self.options = options
        self.source = options.out / "source"
        self.unplanted = options.out / "unplanted"  # programs of the sources without a bug
        if not options.resume:
            for name in ("parts", "runs", "unplanted"):
                shutil.rmtree(options.out / name, ignore_errors=True)
        self.parts = KeptParts(None, options.out / "parts")
        copy_sources(ROOT, self.source)
        if not self.unplanted.exists():
            self.command("cmake", "--preset", "fuzz")
            self.build(*PROGRAMS)
            self.unplanted.mkdir()
            for name in PROGRAMS:
                shutil.copy(self.built(name), self.unplanted)

    def built(self, name):
        return self.source / "build" / "fuzz" / "bin" / name

    def command(self, *words):
        done = subprocess.run(words, cwd=self.source, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              errors="replace", check=False)
        if done.returncode != 0:
            sys.exit(f"error: {' '.join(words)}: exit code {done.returncode}\n{done.stdout[-4000:]}")

    def build(self, *names):
        self.command("cmake", "--build", "--preset", "fuzz", "--parallel", str(self.options.jobs), "--target", *names)

    def replay(self, *words):
        """By the sources without a bug. @return whether they stand it"""
        return subprocess.run([self.unplanted / "limber_fuzz_replay", *words], env=ENVIRONMENT, cwd=self.options.out,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode == 0

    def fuzz(self, program, target, name):
        """One run of libFuzzer, until its first finding or the end of its time."""
        run = self.options.out / "runs" / name
        shutil.rmtree(run, ignore_errors=True)
        for folder in ("corpus", "found"):
            (run / folder).mkdir(parents=True)
        self.replay(target, "--seeds", run / "seeds")
        corpora = [run / "corpus", run / "seeds", self.source / "fuzz" / "corpus" / target]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with (run / "log").open("wb") as log:
            process = subprocess.Popen(
                [program, target, f"-seed={self.options.seed}", *LIMITS, "-print_final_stats=1",
                 f"-dict={self.source / 'fuzz' / 'words.dict'}", f"-artifact_prefix={run / 'found'}/",
                 *filter(pathlib.Path.exists, corpora)], stdout=log, stderr=subprocess.STDOUT, env=ENVIRONMENT)
            was_ended = run_until(process, self.options.seconds)
        shutil.rmtree(f"/dev/shm/limber_fuzz_{process.pid}", ignore_errors=True)  # which it leaves behind
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        text = (run / "log").read_text(encoding="utf-8", errors="replace")
        inputs = [str(path) for path in (run / "found").iterdir() if FINDING.match(path.name)]
        if not inputs and not was_ended:
            sys.exit(f"error: the fuzzer ended by itself, without a finding: {run / 'log'}")
        reports = [found.group(1) for pattern in REPORTS if (found := re.search(pattern, text))]
        return {"target": target, "input": inputs[0] if inputs else None,
                "in_corpus": bool(inputs) and "\tINITED" not in text,  # found before the first mutation
                "executions": max(map(int, EXECUTIONS.findall(text)), default=0),
                "seconds": round(used.ru_utime + used.ru_stime - before.ru_utime - before.ru_stime, 1),
                "report": reports[0] if inputs and reports else ""}

    def outcome(self, bug):
        with bug.planted_in(self.source):
            self.build("limber_fuzz")
            result = self.fuzz(self.built("limber_fuzz"), bug.target, bug.name)
        found = result["input"] is not None and self.replay(bug.target, result["input"])
        return {"name": bug.name, "like": bug.like, "found": found, **result}

    def require_nothing_without(self, bug):
        name = f"unplanted_{bug.target}"
        result = self.parts.kept(name, lambda: self.fuzz(self.unplanted / "limber_fuzz", bug.target, name))
        if result["input"]:
            sys.exit(f"error: {bug.target} fails without a planted bug: {result['report']}: {result['input']}")


def how_found(result):
    if not result["found"]:
        return "no" if result["input"] is None else "another"
    return "in the corpus" if result["in_corpus"] else "yes"


def table(results):
    print("| bug | target | like | found | executions | seconds | report |\n|---|---|---|---|---|---|---|")
    for result in results:
        report = result["report"].replace("|", "\\|")
        print(f"| {result['name'].replace('_', ' ')} | `{result['target']}` | {result['like']} | {how_found(result)} | "
              f"{result['executions']} | {result['seconds']:.0f} | {report} |")
    print(f"\n{sum(result['found'] for result in results)} of {len(results)} found")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, help="default: a new temporary folder")
    parser.add_argument("--only", nargs="+", metavar="NAME", default=[], help="these bugs alone")
    parser.add_argument("--seconds", type=float, default=180.0, help="of processor time for each bug")
    parser.add_argument("--seed", type=int, default=1, help="of libFuzzer, at least 1")
    parser.add_argument("--jobs", type=int, default=1, help="of the compiler")
    parser.add_argument("--skip-unplanted", action="store_true", help="the sources without a bug are not fuzzed first")
    parser.add_argument("--resume", action="store_true")
    parser.add_argument("--list", action="store_true", help="shows the bugs, and plants none")
    parser.add_argument("--dry-run", action="store_true", help="plants each in a copy of its file, and builds nothing")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    bugs = [bug for bug in all_bugs() if not options.only or bug.name in options.only]
    if unknown := set(options.only) - {bug.name for bug in bugs}:
        parser.error(f"no such bugs: {', '.join(sorted(unknown))}; --list shows them")
    if options.list:
        print("\n".join(f"{bug.name:40} {bug.target:17} {bug.like}" for bug in bugs))
        return
    with tempfile.TemporaryDirectory() as folder:
        wrong = list(faults(bugs, pathlib.Path(folder)))
    if wrong or options.dry_run:
        sys.exit("\n".join(wrong) or 0)
    if not shutil.which(COMPILER):
        sys.exit(f"error: {COMPILER} is missing: apt-get install clang-14 libclang-rt-14-dev")
    options.out = (options.out or pathlib.Path(tempfile.mkdtemp(prefix="limber_planted_"))).resolve()
    if ROOT in (options.out, *options.out.parents):
        parser.error(f"--out {options.out}: expected a folder outside of {ROOT}")
    print(f"findings, logs and corpora: {options.out}", file=sys.stderr, flush=True)
    campaign = Campaign(options)
    for bug in bugs if not options.skip_unplanted else ():
        campaign.require_nothing_without(bug)
    results = []
    for bug in bugs:
        results.append(campaign.parts.kept(bug.name, lambda bug=bug: campaign.outcome(bug)))
        print(f"{bug.name}: {how_found(results[-1])}", file=sys.stderr, flush=True)
    print(json.dumps(results, indent=1)) if options.json else table(results)


if __name__ == "__main__":
    main()
