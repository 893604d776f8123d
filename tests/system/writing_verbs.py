"""Every verb that writes: its command, what it leaves, and how it goes on; for campaigns of full disks and of kills."""

import contextlib
import fnmatch
import json
import pathlib
import sys

from program import PROGRAM, ROOT, limber, verbs as verb_names

LEVELS = 16  # fill levels of a disk: 0/16, 1/16 … 16/16 of the room needed, and one above
SLOW_LEVELS = 4  # for verbs that take long
ARM = ("--arm", "two_segment")

# A goal that the no-load model's plans reach on the virtual arm.
WIDE = json.dumps({"schema": "limber/environment/1", "name": "wide", "obstacles": [], "start": "rest",
                   "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.15}})
# The tip starts where the vented arm has it, and leaves.
LINE = "time_s,x_m,y_m\n0,0.45,0\n1,0.449,0.01\n2,0.447,0.02\n"
CAMPAIGN = """schema: limber/campaign/1
verb: collect
flags: {arm: two_segment, schedule: random, count: 3, hold-s: 0.3}
grid:
  episodes: [1, 2]
repeat: 2
"""
# What a clock decides, or where an arm was left when a driver was killed: keys in JSON, and files as a whole.
TIMES = {"wall_time_s", "time_s", "first_candidate_s", "first_certificate_s", "first_solution_s",
         "first_solution_s_median", "late_ms", "round_trip_ms", "episodes_kept_from_before"}
TIMED_FILES = ("*driver.jsonl", "*/log.txt", "*/report.html", "x/table.md", "x/planner_arena/*", "b.svg",
               "plans/p.json", "d.h5")
EPISODES = 3  # of the recording that verbs read
FAULT = 3
READ_ONLY = {"inspect", "verify", "doctor"}  # the verbs that write nothing
STUDIO = (sys.executable, str(pathlib.Path(__file__).resolve().parent / "studio_saves.py"))


class Verb:
    """One command, and the files that it writes: `outputs` are replaced by --force, `folders` filled."""

    def __init__(self, name, arguments, outputs=(), folders=(), old=b"what was there before\n", levels=LEVELS,
                 peak=1.0, unfinished=None, goes_on="--resume", fault=FAULT, starts=(PROGRAM,)):
        self.name = name
        self.command = [*starts, *map(str, arguments)]
        self.starts_others = starts != (PROGRAM,)  # they are killed with it
        self.outputs = outputs
        self.folders = folders
        self.old_content = old
        self.levels = levels
        self.peak = peak  # room taken on the way, over that of what stays
        self.unfinished = unfinished  # pattern of what `goes_on` goes on from
        self.goes_on = goes_on
        self.fault = fault  # exit code where something can't be written

    @property
    def old(self):
        """What was there before."""
        return self.old_content if isinstance(self.old_content, bytes) else self.old_content.read_bytes()

    def flags(self, folder):
        """What makes the same command go on, or begin again."""
        resumes = [self.goes_on] if self.unfinished and list(folder.glob(self.unfinished)) else []
        begun = any((folder / name).exists() for name in self.outputs) or not resumes
        return resumes + ["--force"] * begun


def make_inputs(folder, has_tube):
    """What the verbs read, made by the program itself."""

    def run(*arguments):
        result = limber(*arguments, folder=folder)
        if result.returncode != 0:
            sys.exit(f"limber {' '.join(map(str, arguments))}: {result.stderr}")

    (folder / "arm.yaml").write_bytes((ROOT / "arms/two_segment.yaml").read_bytes())
    (folder / "wide.yaml").write_text(WIDE, encoding="utf-8")
    (folder / "line.csv").write_text(LINE, encoding="utf-8")
    (folder / "campaign.yaml").write_text(CAMPAIGN, encoding="utf-8")
    run("collect", *ARM, "--schedule", "random", "--count", 8, "--episodes", EPISODES, "--hold-s", 0.5,
        "--out", "r.h5")
    run("export", "r.h5", "--csv", "csv")
    run("train", *ARM, "--data", "r.h5", "--epochs", 3, "--hidden", 8, "--out", "m.safetensors")
    # Enough for some of its plans to be certified, which collect --schedule plans asks for.
    run("collect", *ARM, "--schedule", "random", "--count", 10, "--episodes", 6, "--out", "t.h5")
    run("train", *ARM, "--data", "t.h5", "--epochs", 20, "--out", "plans.safetensors")
    if has_tube:  # plans enough for limber calibrate to draw a tube around
        run("collect", *ARM, "--schedule", "random", "--count", 400, "--out", "tube.h5")
        run("train", *ARM, "--data", "tube.h5", "--epochs", 60, "--windows", 8, "--out", "tube.safetensors")
    run("family", *ARM, "--hours", 0.02, "--epochs", 3, "--hidden", 8, "--family-size", 3, "--vary-physics", 1.5,
        "--tube-runs", 0, "--out", "family.safetensors")
    run("environment", *ARM, "--random", "--count", 1, "--out", "envs")
    run("plan", *ARM, "--no-load", "--environment", "wide.yaml", "--goal-margin-m", 0.12, "--max-queries", 20000,
        "--out", "p.json")
    run("plan", *ARM, "--no-load", "--build-forest", "--forest-nodes", 20, "--forest", "old.forest")


def add_choice(parser):
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="verbs, separated by commas")
    parser.add_argument("--without", default="", help="verbs to leave out, separated by commas")


def chosen_verbs(inputs, arguments):
    """Those of add_choice, whose inputs are made; a verb of the program that is missing here is an error."""
    verbs = all_verbs(inputs)
    forgotten = {verb.name.split()[0] for verb in verbs} ^ (set(verb_names()) - READ_ONLY)
    if forgotten:
        sys.exit(f"writing_verbs.py does not know, or the program does not have: {', '.join(sorted(forgotten))}")
    names = {verb.name for verb in verbs}
    only, without = ({*text.split(",")} - {""} for text in (arguments.only, arguments.without))
    if unknown := (only | without) - names:
        sys.exit(f"no such verbs: {', '.join(sorted(unknown))}; there are {', '.join(sorted(names))}")
    wanted = (only or names) - without
    make_inputs(inputs, "calibrate" in wanted)
    return [verb for verb in verbs if verb.name in wanted]


def all_verbs(inputs):
    recording, model, plan = inputs / "r.h5", inputs / "m.safetensors", inputs / "p.json"
    planner, wide = inputs / "plans.safetensors", inputs / "wide.yaml"
    logs = [inputs / "csv" / f"episode_{k:03d}.csv" for k in range(EPISODES)]
    served = f"exec:'{PROGRAM}' virtual-arm --serve --arm two_segment --fast"
    driver = ("--simulated", "--driver", served)
    short = ("--hold-s", 0.3, "--hold-min-s", 0.2)
    return [
        Verb("collect", ["collect", *ARM, "--schedule", "random", "--count", 3, "--episodes", 3, "--hold-s", 0.3,
                         "--out", "c.h5"], ["c.h5"], peak=2.0, unfinished="*.parts"),
        Verb("collect --driver", ["collect", *ARM, "--schedule", "random", "--count", 3, "--episodes", 3, *short,
                                  *driver, "--out", "d.h5"], ["d.h5"], peak=2.0, unfinished="*.parts"),
        Verb("collect --schedule plans", ["collect", *ARM, "--schedule", "plans", "--model", planner, "--count", 2,
                                          "--episodes", 2, "--max-queries", 3000, "--out", "v.h5"], ["v.h5"],
             peak=2.0, unfinished="*.parts"),
        Verb("import", ["import", "csv", *logs, "--mapping", inputs / "csv" / "mapping.yaml", *ARM, "--out", "i.h5"],
             ["i.h5"]),
        Verb("train", ["train", *ARM, "--data", recording, "--epochs", 3, "--hidden", 8, "--checkpoint-interval-s", 0,
                       "--out", "m.safetensors"], ["m.safetensors", "m.curve.csv", "m.curve.svg"],
             peak=6.0, unfinished="*.checkpoint"),
        Verb("family", ["family", *ARM, "--hours", 0.02, "--epochs", 3, "--hidden", 8, "--family-size", 3,
                        "--vary-physics", 1.5, "--tube-runs", 0, "--out", "f.safetensors"], ["f.safetensors"],
             levels=SLOW_LEVELS, peak=30.0, unfinished="*.parts"),
        Verb("adapt", ["adapt", *ARM, "--model", inputs / "family.safetensors", "--recording", recording,
                       "--out", "a.safetensors"], ["a.safetensors"]),
        Verb("improve", ["improve", *ARM, "--model", planner, "--data", recording, "--rounds", 2, "--plans", 2,
                         "--max-queries", 3000, "--epochs", 1, "--out", "improved"], folders=["improved"],
             levels=SLOW_LEVELS, peak=2.0, unfinished="improved/*"),
        Verb("calibrate", ["calibrate", *ARM, "--model", inputs / "tube.safetensors", "--max-queries", 3000,
                           "--shape-runs", 6, "--screen-runs", 3, "--test-runs", 4, "--audit-runs", 2, "--levels", 0.2,
                           "--confidence", 0.4, "--out", "c.safetensors"], ["c.safetensors"],
             levels=SLOW_LEVELS, unfinished="*.calibration"),
        Verb("evaluate --plots", ["evaluate", *ARM, "--model", model, "--data", recording, "--plots", "."],
             ["error_over_time.svg", "position_distribution.svg", "orientation_distribution.svg", "backbones.svg"]),
        Verb("plan", ["plan", *ARM, "--no-load", "--environment", inputs / "envs/random_1_001.yaml", "--max-queries",
                      20000, "--out", "p.json", "--svg", "p.svg", "--animation", "p.html", "--csv", "p.csv"],
             ["p.json", "p.svg", "p.html", "p.csv"]),
        Verb("plan --build-forest", ["plan", *ARM, "--no-load", "--build-forest", "--forest-nodes", 200,
                                     "--forest", "f.forest"],
             ["f.forest"], old=inputs / "old.forest"),
        Verb("execute", ["execute", *ARM, "--plan", plan, "--environment", wide, "--out", "e.h5",
                         "--svg", "e.svg", "--animation", "e.html"], ["e.h5", "e.svg", "e.html"]),
        Verb("execute --driver", ["execute", *ARM, "--plan", plan, "--environment", wide, *driver, "--out", "e.h5",
                                  "--times-svg", "t.svg"], ["e.h5", "t.svg"]),
        Verb("execute --replan", ["execute", *ARM, "--plan", plan, "--environment", wide, "--model", model, "--replan",
                                  "--motion-queries", 500, "--plans-out", "plans"], folders=["plans"]),
        Verb("execute --track", ["execute", *ARM, "--model", model, "--track", inputs / "line.csv",
                                 "--track-queries", 1000, "--out", "k.h5", "--svg", "k.svg"], ["k.h5", "k.svg"]),
        Verb("experiment", ["experiment", *ARM, "--model", model, "--environments", inputs / "envs", "--trials", 1,
                            "--max-queries", 3000, "--out", "x"], folders=["x"], unfinished="x/experiment.json"),
        Verb("campaign", ["campaign", inputs / "campaign.yaml", "--out", "many"], folders=["many"],
             unfinished="many/*", goes_on="--force", fault=1),
        Verb("export --csv", ["export", recording, "--csv", "csv"], folders=["csv"]),
        Verb("export --motive", ["export", recording, "--motive", "motive"], folders=["motive"]),
        Verb("export --onnx", ["export", model, "--onnx", "m.onnx"], ["m.onnx"]),
        Verb("export --mjcf", ["export", inputs / "arm.yaml", "--mjcf", "arm.xml"], ["arm.xml"]),
        Verb("characterize", ["characterize", "--arm", inputs / "arm.yaml", "--steps", 5, "--out", "arm.yaml",
                              "--plot", "arm.svg"], ["arm.yaml", "arm.svg"]),
        Verb("characterize --valves", ["characterize", *ARM, "--valves", recording, "--out", "valves.yaml",
                                       "--plots", "."], ["valves.yaml", "valves.svg"]),
        Verb("environment --random", ["environment", *ARM, "--random", "--count", 2, "--out", "envs"],
             folders=["envs"]),
        Verb("driver check", ["driver", "check", *ARM, *driver, "--out", "checked"], folders=["checked"]),
        Verb("driver calibrate", ["driver", "calibrate", *ARM, "--simulated", "--yes", "--handedness", "right",
                                  "--driver", served, "--out", "o.yaml"], ["o.yaml"]),
        Verb("virtual-arm --truth", ["virtual-arm", "--serve", *ARM, "--misassembled", 1, "--truth", "o.yaml"],
             ["o.yaml"]),
        Verb("bench --plot", ["bench", *ARM, "--queries", 1000, "--plot", "b.svg"], ["b.svg"]),
        Verb("studio", [*ARM], folders=["environments", "plans"], starts=STUDIO),
        Verb("demo --quick", ["demo", *ARM, "--quick", "--out", "demo"], folders=["demo"], levels=SLOW_LEVELS),
    ]


def is_whole(path):
    """Whether a file can be read to its end by what reads such files."""
    if path.suffix in (".h5", ".safetensors", ".forest") or path.name == "p.json":
        return limber("inspect", path).returncode == 0
    text = path.read_bytes()
    if path.suffix == ".json":
        with contextlib.suppress(ValueError):
            return isinstance(json.loads(text), (dict, list))
        return False
    ends = {".svg": b"</svg>", ".html": b"</html>", ".xml": b"</mujoco>"}
    if path.suffix in ends:
        return text.rstrip().endswith(ends[path.suffix])
    return len(text) > 0 and (path.suffix == ".onnx" or text.endswith(b"\n"))


def without_times(value):
    if isinstance(value, dict):
        return {key: without_times(item) for key, item in value.items() if key not in TIMES}
    return [without_times(item) for item in value] if isinstance(value, list) else value


def comparable(folder, name):
    """A file's bytes, but for what a clock decides; of what it decides as a whole, whether it is whole."""
    path = folder / name
    text = path.read_bytes()
    if any(fnmatch.fnmatch(name, pattern) for pattern in TIMED_FILES):
        return is_whole(path)
    if path.name.endswith(".curve.csv"):
        return b"\n".join(line.rsplit(b",", 1)[0] for line in text.splitlines())
    if path.name.startswith(".limber-"):  # hashes of files with times in them
        return sorted(json.loads(text)["files"])
    return without_times(json.loads(text)) if path.suffix == ".json" and is_whole(path) else text
