"""kill -9 at random moments, then the same command again (with --resume where there is something to go on from) until
it is done: whole files, the same bytes as an undisturbed run, no temporary files.

    kill_campaign.py                    100 kills in each of collect, import and train: about ten minutes
    kill_campaign.py --kills 1 --seed 7 one of each, at a moment drawn with this seed; what the ordinary tests run
"""

import argparse
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from program import PROGRAM, limber, temporary_files

AGAIN = 0.5  # probability that the run that goes on is killed as well
WHILE_WRITING = 0.5  # probability that the moment is just after a file began to be written; else any moment
LONGEST_S = 300.0  # no run takes so long

ARM = ("--arm", "two_segment")


class Work:
    def __init__(self, name, arguments, outputs, end):
        self.name = name
        self.arguments = [str(a) for a in arguments]
        self.outputs = outputs
        self.end = end  # of the names of what stands for unfinished work

    def flags(self, folder):
        """What makes the same command go on."""
        if self.end is None:
            return ["--force"]
        if list(folder.glob("*" + self.end)):
            return ["--resume"]
        # Killed after its last file: nothing is left to do, which --force repeats.
        return ["--force"] if (folder / self.outputs[0]).exists() else []

    def bytes(self, folder):
        """All that it wrote, but for the times of day in learning curves."""
        found = {}
        for name in self.outputs:
            text = (folder / name).read_bytes()
            if name.endswith(".curve.csv"):
                text = b"\n".join(line.rsplit(b",", 1)[0] for line in text.splitlines())
            found[name] = text
        return found


def make_works(inputs):
    def run(*arguments):
        result = limber(*arguments, folder=inputs)
        if result.returncode != 0:
            sys.exit(f"limber {' '.join(map(str, arguments))}: {result.stderr}")

    run("collect", *ARM, "--schedule", "random", "--count", 60, "--episodes", 6, "--hold-s", 1, "--out", "r.h5")
    run("export", "r.h5", "--csv", "csv")
    logs = sorted((inputs / "csv").glob("episode_*.csv"))
    return [
        Work("collect", ["collect", *ARM, "--schedule", "random", "--count", 8, "--episodes", 24, "--hold-s", 0.5,
                         "--out", "c.h5"], ["c.h5"], ".parts"),
        Work("import", ["import", "csv", *(logs * 6), "--mapping", inputs / "csv" / "mapping.yaml", *ARM,
                        "--out", "i.h5"], ["i.h5"], None),
        Work("train", ["train", *ARM, "--data", inputs / "r.h5", "--epochs", 24, "--hidden", 32,
                       "--checkpoint-interval-s", 0, "--out", "m.safetensors"],
             ["m.safetensors", "m.curve.csv", "m.curve.svg"], ".checkpoint"),
    ]


class Campaign:
    def __init__(self, work, folder, chance):
        self.work = work
        self.folder = folder
        self.chance = chance
        self.failures = []
        self.kills = 0
        self.rounds = 0
        self.left_behind = 0
        folder.mkdir()
        start = time.monotonic()
        result = self.start([]).wait(timeout=LONGEST_S)
        self.duration_s = time.monotonic() - start
        if result != 0:
            sys.exit(f"{work.name}: {(folder / 'messages').read_text()}")
        self.expected = work.bytes(folder)

    def start(self, flags):
        with open(self.folder / "messages", "w", encoding="utf-8") as messages:
            return subprocess.Popen([PROGRAM, *self.work.arguments, *flags], cwd=self.folder, stdin=subprocess.DEVNULL,
                                    stdout=messages, stderr=messages)

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

    def kill_one(self):
        """@return whether the run was killed before its end."""
        before = {*temporary_files(self.folder)}
        process = self.start(self.work.flags(self.folder))
        if self.chance.random() < WHILE_WRITING:
            self.wait_for_a_write(process)
        else:
            time.sleep(self.chance.uniform(0.0, self.duration_s))
        process.send_signal(signal.SIGKILL)
        killed = process.wait(timeout=LONGEST_S) == -signal.SIGKILL
        self.kills += killed
        self.left_behind += len({*temporary_files(self.folder)} - before)
        return killed

    def round(self, kills):
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        self.rounds += 1
        before = self.kills
        while self.kills < kills and self.kill_one():
            if self.chance.random() >= AGAIN:
                break
        if self.kills == before:
            return  # it was done before the blow
        flags = self.work.flags(self.folder)
        code = self.start(flags).wait(timeout=LONGEST_S)
        self.check(code, flags)

    def check(self, code, flags):
        problems = [] if code == 0 else [f"exit code {code}: {(self.folder / 'messages').read_text()}"]
        if code == 0 and self.work.bytes(self.folder) != self.expected:
            problems.append("other bytes than an undisturbed run")
        allowed = {*self.work.outputs, "messages"}
        problems += [f"{p.name} stays" for p in self.folder.iterdir() if p.name not in allowed]
        if problems:
            self.failures.append(f"{self.work.name}, round {self.rounds}, {' '.join(flags)}: {'; '.join(problems)}")

    def run(self, kills):
        while self.kills < kills:
            self.round(kills)
        print(f"{self.work.name}: {self.kills} kills in {self.rounds} runs of {self.duration_s:.1f} s, "
              f"{self.left_behind} temporary files that they left were removed; {len(self.failures)} failures", flush=True)
        return self.failures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=100, help="in each verb")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="verbs, separated by commas")
    arguments = parser.parse_args()
    failures = []
    with tempfile.TemporaryDirectory(prefix="limber_kills_") as temporary:
        folder = pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir()
        for work in make_works(inputs):
            if not arguments.only or work.name in arguments.only.split(","):
                chance = random.Random(f"{arguments.seed} {work.name}")
                failures += Campaign(work, folder / work.name, chance).run(arguments.kills)
    print("\n".join(failures))
    print(f"{len(failures)} failures, seed {arguments.seed}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
