"""A tenth of a campaign's processes killed at random moments, over and over, until it is done: no unit is lost, none is
done twice, and what is joined has the bytes of an undisturbed run.

    campaign_kills.py               twenty times with shards, and twenty with ranks where mpirun is
    campaign_kills.py --times 2 --processes 4 --seed 7
"""

import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from program import PROGRAM, temporary_files
from test_campaign import COLLECT, HAS_MPI, MPIRUN, mpi_environment

SHARE = 0.1  # of the processes
LONGEST_S = 6.0  # after which whoever is to die dies
MOST_IDLE = 5  # campaigns in a row that ended before a kill


def children_of(pid):
    """The ranks that an mpirun has started."""
    path = pathlib.Path(f"/proc/{pid}/task/{pid}/children")
    return [int(word) for word in path.read_text(encoding="ascii").split()] if path.exists() else []


def done_units(folder):
    return {path: path.stat().st_mtime_ns for path in folder.glob("units/*/*/done_*.json")}


def start(folder, out, processes, by_ranks):
    def popen(*words):
        return subprocess.Popen(words, cwd=folder, env=mpi_environment(), stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    if by_ranks:
        return [popen(*MPIRUN, "-n", str(processes), PROGRAM, "campaign", "c.yaml", "--out", out)]
    return [popen(PROGRAM, "campaign", "c.yaml", "--out", out, "--jobs", "1", "--shard", f"{i}/{processes}")
            for i in range(processes)]


def alive_of(runs, by_ranks):
    return children_of(runs[0].pid) if by_ranks else [run.pid for run in runs if run.poll() is None]


def kill_some(runs, processes, by_ranks, chance):
    """How many were killed: none, where all had ended before."""
    while not alive_of(runs, by_ranks) and any(run.poll() is None for run in runs):
        time.sleep(0.02)  # mpirun has no ranks yet
    deadline = time.monotonic() + chance.uniform(0.0, LONGEST_S)
    while time.monotonic() < deadline and any(run.poll() is None for run in runs):
        time.sleep(0.02)
    alive = alive_of(runs, by_ranks)
    victims = chance.sample(alive, min(len(alive), max(1, round(SHARE * processes))))
    for victim in victims:
        try:
            os.kill(int(victim), signal.SIGKILL)
        except OSError:
            pass
    for run in runs:
        run.wait()
    return len(victims)


def campaign_of(units):
    return COLLECT.replace("repeat: 2", f"repeat: {units // 3}").replace("count: 6", "count: 20")


def joined(folder, out):
    subprocess.run([PROGRAM, "campaign", "c.yaml", "--out", out, "--collect", "--quiet"], cwd=folder, check=True)
    return [(folder / out / name).read_bytes() for name in ("recording.h5", "table.csv", "report.html")]


def one_campaign(folder, out, options, by_ranks, chance, wanted, times):
    """Starts it until it is done, at most `times` times with a kill; returns how many those were."""
    with_kill, kills, starts = 0, 0, 0
    before = {}
    while len(before) < options.units:
        runs = start(folder, out, options.processes, by_ranks)
        starts += 1
        killed = kill_some(runs, options.processes, by_ranks, chance) if with_kill < times else 0
        with_kill += killed > 0
        kills += killed
        for run in runs:
            run.wait()
        after = done_units(folder / out)
        if any(after.get(unit) != moment for unit, moment in before.items()):
            sys.exit(f"{out}: a finished unit was lost or done again")
        if killed == 0 and len(after) < options.units:
            sys.exit(f"{out}: an undisturbed start left {options.units - len(after)} units undone")
        before = after
    if joined(folder, out) != wanted:
        sys.exit(f"{out}: other bytes than those of an undisturbed run")
    left = temporary_files(folder / out)
    print(f"{out}: {options.units} units, {starts} starts of {options.processes} processes, {kills} killed: every unit done "
          f"once, same bytes; {len(left)} temporary files left in units' folders", flush=True)
    return with_kill


def many_kills(folder, name, options, by_ranks, chance, wanted):
    """A campaign may be done before so many kills: then another begins."""
    with_kill, campaigns, idle = 0, 0, 0
    while with_kill < options.times and idle < MOST_IDLE:
        here = one_campaign(folder, f"{name}_{campaigns}", options, by_ranks, chance, wanted, options.times - with_kill)
        idle = 0 if here else idle + 1
        with_kill += here
        campaigns += 1
    if with_kill < options.times:
        sys.exit(f"{name}: {MOST_IDLE} campaigns ended before a kill: more --units")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=20)
    parser.add_argument("--processes", type=int, default=10)
    parser.add_argument("--units", type=int, default=300, help="a multiple of 3")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="limber_kills_"))
    (folder / "c.yaml").write_text(campaign_of(options.units), encoding="utf-8")
    subprocess.run([PROGRAM, "campaign", "c.yaml", "--out", "undisturbed", "--quiet"], cwd=folder, check=True)
    wanted = joined(folder, "undisturbed")
    many_kills(folder, "shards", options, False, chance, wanted)
    if HAS_MPI:
        many_kills(folder, "ranks", options, True, chance, wanted)
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
