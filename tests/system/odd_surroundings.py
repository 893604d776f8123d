"""Every verb that writes, where something around it is not as usual: whole files with the bytes of an undisturbed run,
or a message and nothing written; no temporary files, and no signal ends the program.

    odd_surroundings.py                    each verb 100 times in each of the surroundings: hours
    odd_surroundings.py --times 1 --seed 7 once each, with a chance drawn with this seed; what the ordinary tests run

two writers  the same command twice at once, the second some time after the first
closed       standard input, output and error are closed
full         standard output and error take nothing (/dev/full): 3 where a result could not be printed
unread       whoever was to read output and error has gone: SIGPIPE, once all is written
no home      no environment variable but those that name limber's own files
read-only    the folder takes no files: wants the right to mount, and is left out elsewhere"""

import argparse
import contextlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from disk_full import may_mount
from kill_campaign import LONGEST_S, Campaign
from writing_verbs import add_choice, chosen_verbs

DONE, SOME_LEFT, REFUSED, FAULT = 0, 1, 2, 3  # a campaign leaves to the other what that one is doing
OWN = ("LIMBER_DATA_DIR", "LIMBER_PROGRAM")
NEEDS_OUTPUT = "studio"  # it prints its address, without which nobody can save anything


class Surroundings(Campaign):
    def __init__(self, verb, folder, chance):
        super().__init__(verb, folder, chance)
        self.counts = {}

    def expect(self, kind, code, allowed):
        self.counts[kind] = self.counts.get(kind, 0) + 1
        where = f"{self.verb.name}, {kind}"
        if code not in allowed:
            self.other.append(f"{where}: exit code {code}: {self.messages.read_text()}")
        return where

    def shell(self, redirections, environment=None):
        words = ["sh", "-c", f'exec "$0" "$@" {redirections}', *self.verb.command, "--force"]
        result = subprocess.run(words, cwd=self.folder, env=environment, stdin=subprocess.DEVNULL,
                                capture_output=True, check=False, timeout=LONGEST_S)
        self.messages.write_bytes(result.stderr)
        return result.returncode

    def whole(self, kind, code, allowed=(DONE,)):
        where = self.expect(kind, code, allowed)
        if code in allowed:
            self.compare(where)

    def two_writers(self):
        self.begin()
        processes = [self.start(["--force"])]
        time.sleep(self.chance.uniform(0.0, self.duration_s))
        processes.append(self.start(["--force"], self.folder.with_suffix(".second")))
        codes = [process.wait(timeout=LONGEST_S) for process in processes]
        if codes[1] != DONE:
            self.messages.write_bytes(self.folder.with_suffix(".second").read_bytes())
        where = self.expect("two writers", max(codes), (DONE, REFUSED, SOME_LEFT))
        if max(codes) != DONE and "another limber" not in self.messages.read_text():
            self.other.append(f"{where}: exit codes {codes}: {self.messages.read_text()}")
        self.compare(where)

    def closed(self):
        self.begin()
        self.whole("closed", self.shell(">&- 2>&- <&-"))

    def full(self):
        self.begin()
        self.whole("full", self.shell(">/dev/full 2>/dev/full"), (DONE, FAULT))

    def unread(self):
        self.begin()
        reader, writer = os.pipe()
        os.close(reader)
        process = subprocess.run([*self.verb.command, "--force"], cwd=self.folder, stdin=subprocess.DEVNULL,
                                 stdout=writer, stderr=writer, check=False, timeout=LONGEST_S)
        os.close(writer)
        self.whole("unread", process.returncode, (DONE, FAULT, -signal.SIGPIPE))

    def no_home(self):
        self.begin()
        environment = {name: os.environ[name] for name in OWN if name in os.environ}
        self.whole("no home", self.shell("", environment))

    @contextlib.contextmanager
    def read_only_folder(self):
        subprocess.run(["mount", "-t", "tmpfs", "-o", "ro", "tmpfs", self.folder], check=True)
        try:
            yield
        finally:
            subprocess.run(["umount", "-l", self.folder], check=True)

    def read_only(self):
        self.begin()
        with self.read_only_folder():
            where = self.expect("read-only", self.shell(""), (REFUSED, FAULT))
            if b"error: " not in self.messages.read_bytes():
                self.other.append(f"{where}: no message")

    def run(self, times, mounting):
        kinds = [self.two_writers, self.no_home] + [self.read_only] * mounting
        if self.verb.name != NEEDS_OUTPUT:
            kinds += [self.closed, self.full, self.unread]
        for _ in range(times):
            for kind in kinds:
                kind()
        return [*self.lost, *self.differ, *self.other]

    def row(self):
        counts = ", ".join(f"{kind} {count}" for kind, count in self.counts.items())
        return f"| `{self.verb.name}` | {counts} | {len(self.lost)} | {len(self.differ)} | {len(self.other)} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--times", type=int, default=100, help="each verb in each of the surroundings")
    add_choice(parser)
    arguments = parser.parse_args()
    mounting = may_mount()
    failures = []
    print("| verb | times | lost | bytes differ | other failures |\n|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory(prefix="limber_odd_") as temporary:
        folder = pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir()
        for number, verb in enumerate(chosen_verbs(inputs, arguments)):
            odd = Surroundings(verb, folder / f"work_{number}", random.Random(f"{arguments.seed} {verb.name}"))
            failures += odd.run(arguments.times, mounting)
            print(odd.row(), flush=True)
    print("\n".join(failures))
    if not mounting:
        print("read-only: left out, nothing may be mounted here")
    print(f"{len(failures)} failures, seed {arguments.seed}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
