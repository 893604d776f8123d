"""kill -9 at random moments, then the same command again (with --resume where there is something to go on from) until
it is done: whole files, the same bytes as an undisturbed run, no temporary files. After each kill a file that was there
before is there still, as it was or as it is to be.

    kill_campaign.py                    100 kills in each verb that writes: hours
    kill_campaign.py --kills 1 --seed 7 one of each, at a moment drawn with this seed; what the ordinary tests run
    kill_campaign.py --kills 0          none: whether two undisturbed runs write the same bytes
"""

import argparse
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from program import temporary_files
from writing_verbs import add_choice, chosen_verbs, comparable

AGAIN = 0.5  # probability that the run that goes on is killed as well
OVER_OLD = 0.5  # probability that a verb without --resume replaces what was there before
WHILE_WRITING = 0.5  # probability that the moment is just after a file began to be written; else any moment
LONGEST_S = 600.0  # no run takes so long
MOST_IDLE = 20  # runs in a row that ended before the blow


def children_of(pid):
    return pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii").split()


def runs(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text(encoding="utf-8").rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


class Campaign:
    def __init__(self, verb, folder, chance):
        self.verb = verb
        self.folder = folder
        self.messages = folder.with_suffix(".messages")
        self.chance = chance
        self.kills, self.rounds, self.left_behind = 0, 0, 0
        self.lost, self.differ, self.other = [], [], []
        start = time.monotonic()
        self.expected = self.undisturbed()
        self.duration_s = time.monotonic() - start

    def undisturbed(self):
        self.begin()
        if self.start(["--force"]).wait(timeout=LONGEST_S) != 0:
            sys.exit(f"{self.verb.name}: {self.messages.read_text()}")
        return self.bytes()

    def begin(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()

    def bytes(self):
        """Of what is there, but logs of killed runs beside those of later ones, and who began a campaign's unit."""
        names = [str(p.relative_to(self.folder)) for p in self.folder.rglob("*")
                 if p.is_file() and not re.search(r"\.driver\.\d+\.jsonl$|^started_\w+\.json$", p.name)]
        return {name: comparable(self.folder, name) for name in names}

    def start(self, flags, messages=None):
        with open(messages or self.messages, "w", encoding="utf-8") as messages:
            return subprocess.Popen([*self.verb.command, *flags], cwd=self.folder, stdin=subprocess.DEVNULL,
                                    stdout=messages, stderr=messages, start_new_session=True)

    def wait_for_a_write(self, process):
        """Until one of the next files begins to be written."""
        seen = set()
        for _ in range(self.chance.randrange(1, 8)):
            while process.poll() is None:
                now = {p.name for p in temporary_files(self.folder)}
                if now - seen:
                    seen |= now
                    break
        time.sleep(self.chance.choice([0.0, 0.0, 0.0005, 0.003]))

    def kill_one(self, flags):
        """@return whether the run was killed before its end."""
        before = {*temporary_files(self.folder)}
        process = self.start(flags)
        if self.chance.random() < WHILE_WRITING:
            self.wait_for_a_write(process)
        else:
            time.sleep(self.chance.uniform(0.0, self.duration_s))
        if self.verb.starts_others and process.poll() is None:
            others = children_of(process.pid)
            os.killpg(process.pid, signal.SIGKILL)
            while any(runs(other) for other in others):
                time.sleep(0.001)
        process.send_signal(signal.SIGKILL)
        killed = process.wait(timeout=LONGEST_S) == -signal.SIGKILL
        self.kills += killed
        self.left_behind += len({*temporary_files(self.folder)} - before)
        return killed

    def round(self, kills):
        self.begin()
        self.rounds += 1
        old = self.verb.unfinished is None and self.chance.random() < OVER_OLD
        if old:
            for name in self.verb.outputs:
                (self.folder / name).write_bytes(self.verb.old)
        before = self.kills
        while self.kills < kills and self.kill_one(self.verb.flags(self.folder)):
            self.check_what_stays(old)
            if self.chance.random() >= AGAIN:
                break
        if self.kills > before:  # else it was done before the blow
            flags = self.verb.flags(self.folder)
            self.check_end(self.start(flags).wait(timeout=LONGEST_S), flags)
        return self.kills > before

    def where(self):
        return f"{self.verb.name}, run {self.rounds}"

    def check_what_stays(self, old):
        """Between a kill and the run that goes on."""
        for name in self.verb.outputs:
            path = self.folder / name
            if path.exists():
                if path.read_bytes() != self.verb.old and comparable(self.folder, name) != self.expected[name]:
                    self.lost.append(f"{self.where()}: {name} is neither what was there nor what is to be")
            elif old:
                self.lost.append(f"{self.where()}: {name} is gone")

    def check_end(self, code, flags):
        where = f"{self.where()}, {' '.join(flags)}"
        if code != 0:
            self.other.append(f"{where}: exit code {code}: {self.messages.read_text()}")
            return
        self.compare(where)

    def compare(self, where):
        found = self.bytes()
        self.lost += [f"{where}: {name} is missing" for name in sorted(self.expected.keys() - found.keys())]
        self.other += [f"{where}: {name} stays" for name in sorted(found.keys() - self.expected.keys())]
        self.differ += [f"{where}: {name}: other bytes than an undisturbed run"
                        for name in sorted(found) if found[name] != self.expected.get(name, found[name])]

    def run(self, kills):
        if kills == 0:
            self.undisturbed()
            self.compare(f"{self.verb.name}, again")
        idle = 0
        while self.kills < kills and idle < MOST_IDLE:
            idle = 0 if self.round(kills) else idle + 1
        return [*self.lost, *self.differ, *self.other]

    def row(self):
        return (f"| `{self.verb.name}` | {self.duration_s:.1f} s | {self.kills} | {self.rounds} | {self.left_behind} | "
                f"{len(self.lost)} | {len(self.differ)} | {len(self.other)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=100, help="in each verb")
    add_choice(parser)
    arguments = parser.parse_args()
    failures = []
    print("| verb | takes | kills | runs | temporary files left by kills | lost | bytes differ | other failures |\n"
          "|---|---|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory(prefix="limber_kills_") as temporary:
        folder = pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir()
        for number, verb in enumerate(chosen_verbs(inputs, arguments)):
            campaign = Campaign(verb, folder / f"work_{number}", random.Random(f"{arguments.seed} {verb.name}"))
            failures += campaign.run(arguments.kills)
            print(campaign.row(), flush=True)
    print("\n".join(failures))
    print(f"{len(failures)} failures, seed {arguments.seed}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
