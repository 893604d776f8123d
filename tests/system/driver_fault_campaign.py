"""Drivers that fail in every way that `limber virtual-arm --serve --fault` can play, and limber and its driver killed
and stopped: the log of the simulated device says whether every channel was told to vent within 0.3 s.

    driver_fault_campaign.py --faults 100 --kills 1        what the ordinary tests run: about two minutes
    driver_fault_campaign.py --faults 10000 --kills 100    all of it: hours

Every run has to end by itself with exit code 3, one error message, no file under the recording's own name and, where
frames were recorded, a valid partial recording. A machine that stalls is no fault of limber's: how late this script
itself wakes up is measured beside each run and added to the 0.3 s."""

import argparse
import concurrent.futures
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

import h5py
import numpy

from program import PROGRAM, temporary_files

VENT_S = 0.3
LONGEST_S = 60.0
LAST_FRAME = 20
# Played from a frame on; limber has to see them at that frame.
KINDS = ("late", "repeat", "old", "half", "huge", "nan", "size", "clock", "die", "hang", "flood", "over", "jump")
# From outside: who is sent which signal.
SIGNALS = {
    "kill-limber": ("limber", signal.SIGKILL), "kill-driver": ("driver", signal.SIGKILL),
    "stop-limber": ("limber", signal.SIGSTOP), "stop-driver": ("driver", signal.SIGSTOP),
}
ARM = "two_segment"
NOT_PLAYED = "the fault was not played"
ATTEMPTS = 3  # on a machine so busy that limber or its driver miss their frames before the fault


class StallWatch:
    """How late a thread of this process wakes up, at worst: what the machine, not limber, is slow by."""

    def __init__(self):
        self.worst_s = 0.0
        self.done = threading.Event()
        self.thread = threading.Thread(target=self.watch, daemon=True)

    def watch(self):
        while not self.done.is_set():
            before = time.monotonic()
            time.sleep(0.01)
            self.worst_s = max(self.worst_s, time.monotonic() - before - 0.01)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.done.set()
        self.thread.join()


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


class Case:
    def __init__(self, kind, number, seed, folder):
        self.kind = kind
        self.chance = random.Random(f"{seed}/{kind}/{number}")
        # A shape that was never seen elsewhere has not jumped.
        self.frame = max(self.chance.randrange(LAST_FRAME), 1 if kind == "jump" else 0)
        self.folder = folder / f"{kind}_{number}"
        self.folder.mkdir()
        self.log = self.folder / "device.jsonl"
        self.name = f"{kind}@{self.frame} ({number})"

    def start(self):
        driver = [PROGRAM, "virtual-arm", "--serve", "--arm", ARM, "--device-log", str(self.log)]
        if self.kind in KINDS:
            driver += ["--fault", f"{self.kind}@{self.frame}"]
        return subprocess.Popen(
            [PROGRAM, "collect", "--arm", ARM, "--schedule", "random", "--count", "20", "--approach", "straight",
             "--hold-s", "0.2", "--hold-min-s", "0.1", "--seed", str(self.chance.randrange(1000)), "--out", "run.h5", "--force",
             "--driver", "exec:" + " ".join(f"'{word}'" for word in driver)],
            cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            encoding="utf-8")

    def disturb(self, process):
        """Sends the signal once the arm moves. @return when."""
        whom, number = SIGNALS[self.kind]
        end = time.monotonic() + LONGEST_S
        while sum(e["event"] == "set" for e in device_events(self.log)) <= self.frame and time.monotonic() < end:
            time.sleep(0.01)
        victim = process.pid if whom == "limber" else child_of(process)
        moment = time.monotonic()
        os.kill(victim, number)
        if self.kind == "stop-limber":
            time.sleep(0.6)
            os.kill(victim, signal.SIGCONT)
        return moment

    def run(self):
        """@return (what is wrong, seconds until the vent)"""
        for _ in range(ATTEMPTS):
            wrong, taken_s = self.run_once()
            if wrong != NOT_PLAYED:
                break
            self.log.unlink(missing_ok=True)  # the machine stalled, and limber stopped the run for that
        return wrong, taken_s

    def run_once(self):
        with StallWatch() as stalls:
            process = self.start()
            moment = self.disturb(process) if self.kind in SIGNALS else None
            try:
                _, messages = process.communicate(timeout=LONGEST_S)
            except subprocess.TimeoutExpired:
                process.kill()
                return "hangs", None
            time.sleep(0.35 if self.kind == "kill-limber" else 0.02)
        expected = -signal.SIGKILL if self.kind == "kill-limber" else 3
        if process.returncode != expected:
            return f"exit code {process.returncode}: {messages.strip()[-300:]}", None
        if expected == 3 and messages.count("error:") != 1:
            return f"not one message: {messages.strip()[-300:]}", None
        return self.check_vent(moment, stalls.worst_s)

    def check_vent(self, moment, stalled_s):
        events = device_events(self.log)
        if moment is None:
            faults = [e["at_s"] for e in events if e["event"] == "fault"]
            if not faults:
                return NOT_PLAYED, None
            moment = faults[0]
        taken_s = first_vent_after(events, moment)
        if taken_s is None:
            return f"never vented: {events[-3:]}", None
        if taken_s > VENT_S + stalled_s:
            return f"vented after {taken_s:.3f} s, the machine stalled for {stalled_s:.3f} s", taken_s
        return self.check_files(), taken_s

    def check_files(self):
        left = temporary_files(self.folder) if self.kind != "kill-limber" else []
        if (self.folder / "run.h5").exists() or left:
            return "files that should not be there"
        for path in self.folder.rglob("*.h5"):
            with h5py.File(path) as file:
                for episode in file["episodes"].values() if "episodes" in file else ():
                    for data in episode.values():
                        if not numpy.isfinite(data[()]).all():
                            return f"{path.name}: a number that is not finite"
        return ""


def cases(arguments, folder):
    kinds = [KINDS[i % len(KINDS)] for i in range(arguments.faults)]
    kinds += [name for name in SIGNALS for _ in range(arguments.kills)]
    for number, kind in enumerate(kinds):
        if not arguments.only or kind in arguments.only:
            yield Case(kind, number, arguments.seed, folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faults", type=int, default=100)
    parser.add_argument("--kills", type=int, default=1, help="of each of " + ", ".join(SIGNALS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", nargs="*", help="kinds")
    arguments = parser.parse_args()
    failures = []
    taken = []
    with tempfile.TemporaryDirectory(prefix="limber_faults_") as name:
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            waiting = {pool.submit(case.run): case for case in cases(arguments, pathlib.Path(name))}
            for done, future in enumerate(concurrent.futures.as_completed(waiting), 1):
                if done % 200 == 0:
                    print(f"{done} of {len(waiting)}", file=sys.stderr, flush=True)
                wrong, taken_s = future.result()
                if wrong:
                    failures.append(f"{waiting[future].name}: {wrong}")
                    print(failures[-1], flush=True)
                if taken_s is not None:
                    taken.append(taken_s)
    taken.sort()
    print(f"{len(waiting)} faults, {len(failures)} failures; vented after {numpy.median(taken):.3f} s (median), "
          f"{numpy.quantile(taken, 0.99):.3f} s (99 %), {taken[-1]:.3f} s (longest)" if taken else "no fault was timed")
    return 1 if failures or not taken else 0


if __name__ == "__main__":
    sys.exit(main())
