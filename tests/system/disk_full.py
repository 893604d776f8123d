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
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

from program import PROGRAM, limber, temporary_files

LEVELS = 16  # shares of the room needed: 0/16, 1/16 … 16/16, and one above
SLOW_LEVELS = 4  # for verbs that take a minute
PAGE = 4096
FAULT = 3

# A goal that the no-load model's plans reach on the virtual arm.
WIDE = json.dumps({"schema": "limber/environment/1", "name": "wide", "obstacles": [], "start": "rest",
                   "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.15}})

IN_NAMESPACE = "LIMBER_TEST_MAY_MOUNT"


class Verb:
    """One command, and the files that it writes: `outputs` are replaced by --force, `folders` filled."""

    def __init__(self, name, arguments, outputs=(), folders=(), old=b"what was there before\n", levels=LEVELS,
                 peak=1.0):
        self.name = name
        self.arguments = arguments
        self.outputs = outputs
        self.folders = folders
        self.old = old
        self.levels = levels
        self.peak = peak  # room taken on the way, over that of what stays


def make_inputs(folder):
    """What the verbs read, made by the program itself."""

    def run(*arguments):
        result = limber(*arguments, folder=folder)
        if result.returncode != 0:
            sys.exit(f"limber {' '.join(map(str, arguments))}: {result.stderr}")

    arm = ("--arm", "two_segment")
    run("collect", *arm, "--schedule", "random", "--count", 8, "--episodes", 3, "--hold-s", 0.5, "--out", "r.h5")
    run("export", "r.h5", "--csv", "csv")
    run("train", *arm, "--data", "r.h5", "--epochs", 3, "--hidden", 8, "--out", "m.safetensors")
    # Enough for some of its plans to be certified, which collect --schedule plans asks for.
    run("collect", *arm, "--schedule", "random", "--count", 10, "--episodes", 6, "--out", "t.h5")
    run("train", *arm, "--data", "t.h5", "--epochs", 20, "--out", "plans.safetensors")
    run("environment", *arm, "--random", "--count", 1, "--out", "envs")
    environment = next((folder / "envs").iterdir())
    (folder / "wide.yaml").write_text(WIDE, encoding="utf-8")
    run("plan", *arm, "--no-load", "--environment", "wide.yaml", "--goal-margin-m", 0.12, "--max-queries", 20000,
        "--out", "p.json")
    run("plan", *arm, "--no-load", "--build-forest", "--forest-nodes", 20, "--forest", "old.forest")
    return environment


def all_verbs(inputs):
    environment = make_inputs(inputs)
    arm = ("--arm", "two_segment")
    recording, model, plan = inputs / "r.h5", inputs / "m.safetensors", inputs / "p.json"
    logs = sorted((inputs / "csv").glob("episode_*.csv"))
    return [
        Verb("collect", ["collect", *arm, "--schedule", "random", "--count", 3, "--episodes", 3, "--hold-s", 0.3,
                         "--out", "c.h5"], ["c.h5"], peak=2.0),
        Verb("import", ["import", "csv", *logs, "--mapping", inputs / "csv" / "mapping.yaml", *arm, "--out", "i.h5"],
             ["i.h5"]),
        Verb("train", ["train", *arm, "--data", recording, "--epochs", 3, "--hidden", 8, "--checkpoint-interval-s", 0,
                       "--out", "m.safetensors"], ["m.safetensors", "m.curve.csv", "m.curve.svg"],
             peak=6.0),
        Verb("evaluate --plots", ["evaluate", *arm, "--model", model, "--data", recording, "--plots", "."],
             ["error_over_time.svg", "position_distribution.svg", "orientation_distribution.svg", "backbones.svg"]),
        Verb("plan", ["plan", *arm, "--no-load", "--environment", environment, "--max-queries", 20000,
                      "--out", "p.json", "--svg", "p.svg", "--animation", "p.html", "--csv", "p.csv"],
             ["p.json", "p.svg", "p.html", "p.csv"]),
        Verb("plan --build-forest", ["plan", *arm, "--no-load", "--build-forest", "--forest-nodes", 200,
                                     "--forest", "f.forest"],
             ["f.forest"], old=(inputs / "old.forest").read_bytes()),
        Verb("execute", ["execute", *arm, "--plan", plan, "--environment", inputs / "wide.yaml", "--out", "e.h5",
                         "--svg", "e.svg", "--animation", "e.html"], ["e.h5", "e.svg", "e.html"]),
        Verb("experiment", ["experiment", *arm, "--model", model, "--environments", inputs / "envs", "--trials", 1,
                            "--max-queries", 3000, "--out", "x"], folders=["x"]),
        Verb("collect --schedule plans", ["collect", *arm, "--schedule", "plans", "--model",
                                          inputs / "plans.safetensors", "--count", 2, "--max-queries", 3000,
                                          "--out", "v.h5"]),
        Verb("export --csv", ["export", recording, "--csv", "csv"], folders=["csv"]),
        Verb("export --motive", ["export", recording, "--motive", "motive"], folders=["motive"]),
        Verb("export --onnx", ["export", model, "--onnx", "m.onnx"], ["m.onnx"]),
        Verb("export --mjcf", ["export", inputs / "arm.yaml", "--mjcf", "arm.xml"], ["arm.xml"]),
        Verb("characterize --out", ["characterize", "--arm", inputs / "arm.yaml", "--steps", 5, "--out", "arm.yaml",
                                    "--plot", "arm.svg"], ["arm.yaml", "arm.svg"]),
        Verb("environment --random", ["environment", *arm, "--random", "--count", 2, "--out", "envs"],
             folders=["envs"]),
        Verb("demo --quick", ["demo", *arm, "--quick", "--out", "demo"], folders=["demo"], levels=SLOW_LEVELS),
    ]


def is_whole(path):
    """Whether a file can be read to its end by what reads such files."""
    if path.suffix in (".h5", ".safetensors", ".forest") or path.name == "p.json":
        return limber("inspect", path).returncode == 0
    text = path.read_bytes()
    if path.suffix == ".json":
        json.loads(text)
        return True
    ends = {".svg": b"</svg>", ".html": b"</html>", ".xml": b"</mujoco>"}
    if path.suffix in ends:
        return text.rstrip().endswith(ends[path.suffix])
    return len(text) > 0 and (path.suffix == ".onnx" or text.endswith(b"\n"))


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
        return subprocess.run([PROGRAM, *map(str, verb.arguments), *more], cwd=self.disk.folder,
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
            if result.returncode == FAULT and verb.name in ("collect", "train") and not problems:
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
        if result.returncode not in (0, FAULT):
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
                if path.suffix != ".checkpoint" and not is_whole(path):
                    found.append(f"{path.name} is broken")
        if result.returncode == 0:
            found += [f"{path} was not written" for path in written if not (folder / path).exists()]
        return found

    def resume(self, verb, folder):
        """With room again, the work that was done before goes on to its end."""
        self.disk.unlimit()
        flags = ["--force"]
        if verb.name == "collect" or list(folder.glob("*.checkpoint")):
            flags.append("--resume")
        result = self.run(verb, *flags)
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
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="verbs, separated by commas")
    parser.add_argument("--without", default="", help="verbs to leave out, separated by commas")
    arguments = parser.parse_args()
    mounting = may_mount()
    chance = random.Random(arguments.seed)
    failures = []
    with tempfile.TemporaryDirectory(prefix="limber_disk_full_") as temporary:
        folder = pathlib.Path(temporary)
        inputs = folder / "inputs"
        inputs.mkdir()
        (inputs / "arm.yaml").write_bytes((pathlib.Path(__file__).parents[2] / "arms/two_segment.yaml").read_bytes())
        verbs = [v for v in all_verbs(inputs) if (not arguments.only or v.name in arguments.only.split(","))
                 and v.name not in arguments.without.split(",")]
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
