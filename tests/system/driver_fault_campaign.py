"""Drivers that fail in every way that `limber virtual-arm --serve --fault` can play, and limber and its driver sent every
signal: the log of the simulated device says whether every channel was told to vent within 0.3 s.

    driver_fault_campaign.py --faults 100 --kills 1        what the ordinary tests run: about two minutes
    driver_fault_campaign.py --faults 10000 --kills 100 --state faults.jsonl    all of it: hours, in parts

Every run has to end by itself with its exit code, one error message that is true, no file under the recording's own name
and, where frames were recorded, a valid partial recording. The 0.3 s have no allowance: a machine that stalls fails them.
A run that such a machine ended before its fault was played is played again, and that is counted. With --state every
result is kept as it comes; the same command goes on from there. --report prints what the file holds."""

import argparse
import collections
import concurrent.futures
import contextlib
import datetime
import json
import os
import pathlib
import platform
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

import h5py
import numpy

from program import PROGRAM, ROOT, temporary_files

VENT_S = 0.3
LONGEST_S = 300.0  # of a run, which is over in seconds on a machine that does nothing else
LAST_FRAME = 20
ARM = "two_segment"
ATTEMPTS = 10  # on a machine so busy that limber or its driver miss their frames before the fault
# Played from a frame on. Those that limber sees at that frame …
SEEN_AT_ONCE = ("late", "repeat", "old", "half", "huge", "nan", "size", "clock", "die", "hang", "flood", "over", "jump",
                "release")
SEEN_LATER = ("stuck", "sealed")  # … and only when pressures have not followed for a while.
KINDS = SEEN_AT_ONCE + SEEN_LATER
ANSWERS_ON = ("repeat", "clock", "jump", "release")  # so that the vent is measured
MISREADS = ("over", "stuck", "sealed")  # what is measured counts, which need not be where the arm is
# How the driver samples; a tracker of 200, 100 or 25 Hz is overtaken by requests.
SAMPLINGS = ("", "--at-once", "--sampled 0.005", "--sampled 0.01", "--sampled 0.04")
STOPS = ("INT", "TERM", "HUP", "QUIT", "TSTP", "USR1", "USR2", "PIPE", "ALRM")
CRASHES = ("SEGV", "ABRT", "BUS", "FPE", "ILL")
# From outside: whom, with which signal, how often, and the exit code.
SIGNALS = {
    **{f"limber {name}": ("limber", name, 1, 1) for name in STOPS},
    "limber INT three times": ("limber", "INT", 3, 1),
    **{f"limber {name}": ("limber", name, 1, -getattr(signal, f"SIG{name}")) for name in (*CRASHES, "KILL")},
    "limber STOP": ("limber", "STOP", 1, 3),
    **{f"driver {name}": ("driver", name, 1, 3) for name in ("KILL", "STOP", "TERM", "SEGV")},
}


def device_events(log):
    """The device's log as far as it is written."""
    if not log.exists():
        return []
    return [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines() if line.endswith("}")]


def first_vent_after(events, moment):
    """Seconds from `moment` until the device was vented; None where it never was, or was told to move later."""
    before = [e for e in events if e["at_s"] <= moment and e["event"] in ("set", "vent")]
    after = [e for e in events if e["at_s"] > moment and e["event"] in ("set", "vent")]
    vents = [e["at_s"] for e in after if e["event"] == "vent"]
    if before and before[-1]["event"] == "vent" and not after:
        return 0.0
    if not vents or after[-1]["event"] != "vent":
        return None
    return vents[0] - moment


def child_of(process):
    children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text(encoding="ascii").split()
    return int(children[0]) if children else None


@contextlib.contextmanager
def without_waiting():
    """This thread goes first where that is allowed: from reading the clock to sending the signal nothing comes between."""
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(2))
    except PermissionError:
        yield
        return
    try:
        yield
    finally:
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))


class NotPlayed(Exception):
    """The machine stalled, and limber stopped the run for that, before the fault."""


class Wrong(Exception):
    """What limber or its driver did wrong."""


class Case:
    def __init__(self, kind, number, seed, folder):
        self.kind = kind
        self.name = f"{kind} {number}"
        self.chance = random.Random(f"{seed}/{kind}/{number}")
        # A shape that was never seen elsewhere has not jumped; zero in force was sent recently.
        self.frame = max(self.chance.randrange(LAST_FRAME), {"jump": 2, "release": 8}.get(kind, 0))
        # On a clock of its own, 50 cm are no jump where the machine stalls for four frames.
        self.sampling = self.chance.choice(SAMPLINGS[:2] if kind == "jump" else SAMPLINGS)
        self.seed = self.chance.randrange(1000)
        self.folder = folder / self.name.replace(" ", "_")
        self.log = self.folder / "device.jsonl"

    def start(self):
        driver = [PROGRAM, "virtual-arm", "--serve", "--arm", ARM, "--device-log", str(self.log), *self.sampling.split()]
        if self.kind in KINDS:
            driver += ["--fault", f"{self.kind}@{self.frame}"]
        return subprocess.Popen(
            [PROGRAM, "collect", "--arm", ARM, "--schedule", "random", "--count", "20", "--approach", "straight",
             "--hold-s", "0.2", "--hold-min-s", "0.1", "--seed", str(self.seed), "--out", "run.h5", "--force",
             "--driver", "exec:" + " ".join(f"'{word}'" for word in driver)],
            cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            encoding="utf-8")

    def disturb(self, process):
        """Sends the signals once the arm moves. @return when the first."""
        whom, name, count, _ = SIGNALS[self.kind]
        number = getattr(signal, f"SIG{name}")
        while sum(e["event"] == "set" for e in device_events(self.log)) <= self.frame:
            if process.poll() is not None:
                raise NotPlayed
            time.sleep(0.02)
        victim = process.pid if whom == "limber" else child_of(process)
        if victim is None or process.poll() is not None:
            raise NotPlayed
        with without_waiting():
            moment = time.monotonic()
            os.kill(victim, number)
        for _ in range(count - 1):
            time.sleep(0.03)
            if process.poll() is None:
                os.kill(victim, number)
        if name == "STOP" and whom == "limber":
            time.sleep(0.6)
            os.kill(victim, signal.SIGCONT)
        return moment

    def run(self):
        """@return seconds until the vent. @throws Wrong, NotPlayed."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        process = self.start()
        try:
            moment = self.disturb(process) if self.kind in SIGNALS else None
            _, messages = process.communicate(timeout=LONGEST_S)
        except NotPlayed:
            process.communicate()
            raise
        except subprocess.TimeoutExpired as error:
            process.kill()
            process.communicate()
            raise Wrong("hangs") from error
        if process.returncode < 0:
            time.sleep(0.4)  # its driver has to end too
        events = device_events(self.log)
        if moment is None:
            faults = [e["at_s"] for e in events if e["event"] == "fault"]
            if not faults:
                raise NotPlayed
            moment = faults[0]
        self.check_end(process.returncode, messages)
        self.check_messages(messages)
        self.check_files()
        return self.check_vent(events, moment)

    def check_end(self, code, messages):
        expected = SIGNALS[self.kind][3] if self.kind in SIGNALS else 3
        if expected == 1 and "VENT NOT CONFIRMED" in messages:
            expected = 3
        if code != expected:
            raise Wrong(f"exit code {code}: {messages.strip()[-300:]}")
        if messages.count("error:") != (expected != -signal.SIGKILL):
            raise Wrong(f"not one message: {messages.strip()[-300:]}")

    def check_messages(self, messages):
        """What is said of the vent is true."""
        if "can't be killed" in messages:
            raise Wrong(f"no such driver: {messages.strip()[-300:]}")
        stopped = self.kind in SIGNALS and SIGNALS[self.kind][3] == 1
        vented = re.search(r"^vented: [0-9.]+ kPa", messages, flags=re.M)
        alarm = re.search("^VENT NOT CONFIRMED: segment", messages, flags=re.M)
        # On a machine that stalls, an answer may be late: then limber can't know, and says that.
        unknown = re.search("^VENT NOT CONFIRMED: the driver does not answer", messages, flags=re.M)
        if (stopped or self.kind in ANSWERS_ON) and not (vented or unknown):
            raise Wrong(f"vented, but not said: {messages.strip()[-300:]}")
        if self.kind in MISREADS and not (vented or alarm or unknown):
            raise Wrong(f"measured, but not said: {messages.strip()[-300:]}")
        if self.kind not in MISREADS and alarm:
            raise Wrong(f"a false alarm: {messages.strip()[-300:]}")

    def check_vent(self, events, moment):
        taken_s = first_vent_after(events, moment)
        if taken_s is None:
            raise Wrong(f"never vented: {events[-3:]}")
        if self.kind in SEEN_LATER:
            return None
        if taken_s > VENT_S:
            raise Wrong(f"vented after {taken_s:.3f} s")
        return taken_s

    def check_files(self):
        killed = self.kind in SIGNALS and SIGNALS[self.kind][3] < 0
        left = [] if killed else temporary_files(self.folder)
        if (self.folder / "run.h5").exists() or left:
            raise Wrong("files that should not be there")
        if not killed and self.frame > 1 and not (self.folder / "run.partial.h5").exists():
            raise Wrong("no partial recording")
        for path in self.folder.rglob("*.h5"):
            with h5py.File(path) as file:
                for episode in file["episodes"].values() if "episodes" in file else ():
                    for data in episode.values():
                        if not numpy.isfinite(data[()]).all():
                            raise Wrong(f"{path.name}: a number that is not finite")

    def result(self):
        """One line of the state file."""
        found = {"case": self.name, "kind": self.kind, "sampling": self.sampling, "frame": self.frame}
        for again in range(ATTEMPTS):
            found.update(played_again=again, wrong="", vent_s=None)
            try:
                found["vent_s"] = self.run()
                break
            except NotPlayed:
                found["wrong"] = "the fault was not played"
            except Wrong as wrong:
                found["wrong"] = str(wrong)
                break
        shutil.rmtree(self.folder, ignore_errors=True)
        return found


def cases(arguments, folder):
    """All kinds alike at every moment, so that a part of the campaign is a sample of it."""
    numbered = [(i // len(KINDS) / max(1, arguments.faults // len(KINDS)), KINDS[i % len(KINDS)], i)
                for i in range(arguments.faults)]
    numbered += [(i / max(1, arguments.kills), kind, i) for kind in SIGNALS for i in range(arguments.kills)]
    for _, kind, number in sorted(numbered, key=lambda case: case[0]):
        if not arguments.only or kind in arguments.only:
            yield Case(kind, number, arguments.seed, folder)


def commit():
    """The hash of what runs; unknown outside a repository and on machines without git."""
    try:
        done = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], capture_output=True,
                              encoding="utf-8", check=False)
    except FileNotFoundError:
        return "unknown"
    return done.stdout.strip() or "unknown"


def processor():
    names = re.findall(r"^model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), flags=re.M)
    return f"{len(names)} × {names[0]}" if names else platform.machine()


class State:
    """Results as they come, in a file or in memory."""

    def __init__(self, path, seed):
        self.results = []
        self.lock = threading.Lock()
        self.file = None
        self.head = {"seed": seed, "commit": commit(), "machine": processor(), "system": platform.platform()}
        if path is None:
            return
        if path.exists():
            lines = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line.endswith("}")]
            if lines[0]["seed"] != seed:
                sys.exit(f"{path}: is of --seed {lines[0]['seed']}")
            self.head, self.results = lines[0], lines[1:]
        self.file = open(path, "a", encoding="utf-8", buffering=1)
        if not self.results and path.stat().st_size == 0:
            self.file.write(json.dumps(self.head) + "\n")

    def add(self, result):
        with self.lock:
            self.results.append(result)
            if self.file:
                self.file.write(json.dumps(result) + "\n")
            if result["wrong"]:
                print(f"{result['case']} (frame {result['frame']}, {result['sampling'] or 'each frame'}): {result['wrong']}",
                      flush=True)

    def report(self):
        """A table for docs/log."""
        kinds = collections.defaultdict(list)
        for result in self.results:
            kinds[result["kind"]].append(result)
        print(f"Commit {self.head['commit']}, seed {self.head['seed']}, {self.head['machine']}, {self.head['system']}.\n")
        print("| fault | played | failed | played again | vented after: median | 99 % | longest |\n|---|---|---|---|---|---|---|")
        for kind, found in (*kinds.items(), ("all", self.results)):
            taken = [f["vent_s"] for f in found if f["vent_s"] is not None]
            times = ("–",) * 3 if not taken else tuple(
                f"{s:.3f} s" for s in (numpy.median(taken), numpy.quantile(taken, 0.99), max(taken)))
            print(f"| {kind} | {len(found)} | {sum(bool(f['wrong']) for f in found)} | "
                  f"{sum(f['played_again'] for f in found)} | {' | '.join(times)} |")


def play(waiting, state, until, jobs):
    """Plays cases until there are none, or the time is over."""
    lock = threading.Lock()

    def play_on():
        while until is None or datetime.datetime.now() < until:
            with lock:
                case = next(waiting, None)
            if case is None:
                return
            state.add(case.result())

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for worker in [pool.submit(play_on) for _ in range(jobs)]:
            worker.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faults", type=int, default=100)
    parser.add_argument("--kills", type=int, default=1, help="of each of " + ", ".join(SIGNALS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", nargs="*", help="kinds")
    parser.add_argument("--state", type=pathlib.Path, help="file of results, which a later run goes on from")
    parser.add_argument("--until", help="start no more from this time of day on, as in 23:15")
    parser.add_argument("--report", action="store_true", help="only print what --state holds, as a table")
    arguments = parser.parse_args()
    for name in STOPS[1:]:  # as a shell in the foreground leaves them
        signal.signal(getattr(signal, f"SIG{name}"), signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    until = arguments.until and datetime.datetime.combine(
        datetime.date.today(), datetime.time.fromisoformat(arguments.until))
    state = State(arguments.state, arguments.seed)
    if not arguments.report:
        done = {result["case"] for result in state.results}
        with tempfile.TemporaryDirectory(prefix="limber_faults_") as name:
            waiting = (case for case in cases(arguments, pathlib.Path(name)) if case.name not in done)
            play(waiting, state, until, arguments.jobs)
    state.report()
    return 1 if not state.results or any(result["wrong"] for result in state.results) else 0


if __name__ == "__main__":
    sys.exit(main())
