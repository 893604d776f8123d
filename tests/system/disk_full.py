"""Every verb that writes, on a disk that is full: it exits with 3 and a message, or with 0 and whole files. What was
there before a failure is there after it, byte for byte; no temporary file stays, and no signal ends the program.

    disk_full.py                     every verb at every fill level, both kinds of disks: about half an hour
    disk_full.py --levels 2 --seed 5 two levels a verb, drawn with this seed; what the ordinary tests run
    disk_full.py --only train,collect

Disks of two kinds: `small disk` is a file system in memory with room for a share of what the verb writes (wants the right to
mount, as root or in a user namespace; left out elsewhere); `small files` lets no file grow beyond a share of the
largest one written (ulimit -f)."""

import argparse
import contextlib
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

from program import temporary_files
from writing_verbs import FAULT, LEVELS, add_choice, chosen_verbs, is_whole

PAGE = 4096
# Unfinished work; a driver's log, which never stops an arm; what a unit of a campaign said.
MAY_END_EARLY = (".checkpoint", ".driver.jsonl", "result.json", "log.txt")

IN_NAMESPACE = "LIMBER_TEST_MAY_MOUNT"


class SmallDisk:
    """A file system in memory, as large as `room` says. Freshly made for each run."""

    name = "small disk"

    def __init__(self, folder):
        self.folder = folder / "disk"
        self.folder.mkdir()

    @contextlib.contextmanager
    def fresh(self):
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=1g", "tmpfs", self.folder], check=True)
        try:
            yield self.folder
        finally:
            subprocess.run(["umount", "-l", self.folder], check=True)

    def room_needed(self):
        """For everything there, with the temporary copy of the largest file."""
        state = os.statvfs(self.folder)
        largest = max(p.stat().st_size for p in self.folder.rglob("*") if p.is_file())
        return (state.f_blocks - state.f_bfree) * state.f_frsize + largest

    def limit(self, room):
        state = os.statvfs(self.folder)
        size = (state.f_blocks - state.f_bfree) * state.f_frsize + int(room) // PAGE * PAGE
        # A size of 0 would be no limit.
        subprocess.run(["mount", "-o", f"remount,size={max(size, PAGE)}", self.folder], check=True)

    def unlimit(self):
        subprocess.run(["mount", "-o", "remount,size=1g", self.folder], check=True)

    def preparation(self):
        return None


class SmallFiles:
    """An ordinary folder, in which no file may be larger than `room` bytes."""

    name = "small files"

    def __init__(self, folder):
        self.folder = folder / "files"
        self.bytes = resource.RLIM_INFINITY

    @contextlib.contextmanager
    def fresh(self):
        self.folder.mkdir()
        self.bytes = resource.RLIM_INFINITY
        try:
            yield self.folder
        finally:
            shutil.rmtree(self.folder)

    def room_needed(self):
        return max(p.stat().st_size for p in self.folder.rglob("*") if p.is_file())

    def limit(self, room):
        self.bytes = int(room)

    def unlimit(self):
        self.bytes = resource.RLIM_INFINITY

    def preparation(self):
        limit = (self.bytes, resource.RLIM_INFINITY)
        return lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit)


class Campaign:
    def __init__(self, disk):
        self.disk = disk
        self.failures = []
        self.rows = {}

    def run(self, verb, *more):
        return subprocess.run([*verb.command, *more], cwd=self.disk.folder,
                              preexec_fn=self.disk.preparation(), stdin=subprocess.DEVNULL, capture_output=True,
                              encoding="utf-8", check=False)

    def measure(self, verb):
        """Room that the verb takes where there is enough, and what it writes then."""
        with self.disk.fresh() as folder:
            result = self.run(verb)
            if result.returncode != 0:
                sys.exit(f"{verb.name}: {result.returncode}: {result.stderr}")
            return verb.peak * self.disk.room_needed(), {p.relative_to(folder) for p in folder.rglob("*") if p.is_file()}

    def cell(self, verb, room, written):
        with self.disk.fresh() as folder:
            for name in verb.outputs:
                (folder / name).write_bytes(verb.old)
            self.disk.limit(room)
            result = self.run(verb, "--force")
            problems = self.problems(verb, folder, result, written)
            text = str(result.returncode)
            if result.returncode == verb.fault and verb.unfinished and not problems:
                problems = self.resume(verb, folder)
                text += "r"
        if problems:
            self.failures.append(f"{self.disk.name}, {verb.name}, {room} bytes: exit {result.returncode}: "
                                 f"{'; '.join(problems)}\n{result.stderr}")
            text = "FAIL"
        return text

    def problems(self, verb, folder, result, written):
        """What is wrong after a run."""
        found = []
        if result.returncode not in (0, verb.fault, FAULT):  # of a campaign's run, or of itself
            found.append(f"exit code {result.returncode}")
        if result.returncode != 0 and "error: " not in result.stderr:
            found.append("no message")
        found += [f"{path} stays" for path in temporary_files(folder)]
        for name in verb.outputs:
            if not (folder / name).exists():
                found.append(f"{name} is gone")
            elif (folder / name).read_bytes() == verb.old:
                if result.returncode == 0:
                    found.append(f"{name} was not written")
            elif not is_whole(folder / name):
                found.append(f"{name} is broken")
        for path in folder.rglob("*"):
            if path.is_file() and not path.name.startswith(".limber") and path.read_bytes() != verb.old:
                if not path.name.endswith(MAY_END_EARLY) and not is_whole(path):
                    found.append(f"{path.name} is broken")
        if result.returncode == 0:
            found += [f"{path} was not written" for path in written if not (folder / path).exists()]
        return found

    def resume(self, verb, folder):
        """With room again, the work that was done before goes on to its end."""
        self.disk.unlimit()
        result = self.run(verb, *verb.flags(folder))
        left = [p for p in folder.iterdir() if p.name.endswith((".parts", ".checkpoint"))]
        found = self.problems(verb, folder, result, set())
        return found + [f"{path.name} stays" for path in left] + (
            [] if result.returncode == 0 else [f"can't be resumed: {result.stderr}"])

    def sweep(self, verb, count, chance):
        room, written = self.measure(verb)
        levels = list(range(verb.levels + 2))
        if count is not None:
            levels = sorted(chance.sample(levels, min(count, len(levels))))
        for level in levels:
            share = level * LEVELS // verb.levels
            self.rows.setdefault(verb.name, {})[share] = self.cell(verb, room * level / verb.levels, written)

    def table(self):
        shares = sorted({share for row in self.rows.values() for share in row})
        width = max(len(name) for name in self.rows)
        lines = [f"{self.disk.name}: exit code by room, in sixteenths of what is needed (r: then resumed to its end)",
                 " " * width + "".join(f"{share:>5}" for share in shares)]
        for name, row in self.rows.items():
            lines.append(f"{name:<{width}}" + "".join(f"{row.get(share, ''):>5}" for share in shares))
        return "\n".join(lines)


def may_mount():
    """Starts the script again where it may mount, if there is such a place."""
    if os.environ.get(IN_NAMESPACE):
        return os.environ[IN_NAMESPACE] == "yes"
    for way in (["unshare", "--mount"], ["unshare", "--user", "--map-root-user", "--mount"]):
        probe = [*way, "sh", "-c", "mount -t tmpfs tmpfs /mnt"]
        if shutil.which("unshare") and subprocess.run(probe, capture_output=True, check=False).returncode == 0:
            os.environ[IN_NAMESPACE] = "yes"
            os.execvp(way[0], [*way, sys.executable, *sys.argv])
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--levels", type=int, help="so many fill levels a verb, drawn by chance")
    add_choice(parser)
    arguments = parser.parse_args()
    mounting = may_mount()
    chance = random.Random(arguments.seed)
    failures = []
    with tempfile.TemporaryDirectory(prefix="limber_disk_full_") as temporary:
        folder = pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir()
        verbs = chosen_verbs(inputs, arguments)
        disks = [SmallFiles(folder)] + ([SmallDisk(folder)] if mounting else [])
        for disk in disks:
            campaign = Campaign(disk)
            for verb in verbs:
                campaign.sweep(verb, arguments.levels, chance)
            print(campaign.table(), flush=True)
            failures += campaign.failures
    if not mounting:
        print("small disk: left out, nothing may be mounted here")
    print("\n".join(failures))
    print(f"{len(failures)} failures, seed {arguments.seed}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
