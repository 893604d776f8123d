"""What the tests of the Python module share: the program to compare with, and a small recording and
network that it made."""

import functools
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import limber

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("LIMBER_PROGRAM", str(ROOT / "build" / "release" / "bin" / "limber"))
EXAMPLES = ROOT / "examples" / "python"
TWO_SEGMENT = ROOT / "arms" / "two_segment.yaml"
HANGING = ROOT / "arms" / "hanging_3x2.yaml"


def run_program(*arguments, folder, code=0):
    """Runs the program to its end."""
    result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True,
                            encoding="utf-8", check=False)
    if code is not None and result.returncode != code:
        raise AssertionError(f"limber {' '.join(map(str, arguments))}\n{result.stderr}")
    return result


def run_json(*arguments, folder, code=0):
    return json.loads(run_program(*arguments, "--json", folder=folder, code=code).stdout)


def run_execution(*arguments, folder):
    """What `limber execute --json` prints; it ends with 1 where the arm did not arrive."""
    done = run_program("execute", *arguments, "--json", folder=folder, code=None)
    found = json.loads(done.stdout)
    assert done.returncode == (1 if found["message"] else 0), done.stderr
    return found


def run_example(name, *arguments, folder):
    """One of examples/python, in a Python of its own."""
    return subprocess.run([sys.executable, str(EXAMPLES / name), *map(str, arguments)], cwd=folder,
                          capture_output=True, encoding="utf-8", check=False)


class InFolder(unittest.TestCase):
    """A test with a fresh folder of its own, self.folder."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="limber_test_")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)


class Chain:
    """A recording of the two-segment arm and a network, made by the program."""

    def __init__(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="limber_chain_")
        self.folder = pathlib.Path(self.temporary.name)
        self.recording = self.folder / "train.h5"
        self.model = self.folder / "model.safetensors"
        run_program("collect", "--arm", TWO_SEGMENT, "--schedule", "random", "--count", 6,
                    "--episodes", 3, "--hold-s", 1, "--seed", 4, "--out", self.recording,
                    folder=self.folder)
        run_program("train", "--arm", TWO_SEGMENT, "--data", self.recording, "--hidden", 16, 16,
                    "--epochs", 180, "--seed", 4, "--out", self.model, folder=self.folder)
        self.arm = limber.load_arm(TWO_SEGMENT)
        self.environment = limber.Environment(
            "a wall", [limber.Circle(x_m=0.30, y_m=-0.30, radius_m=0.03)],
            limber.PoseGoal(x_m=0.38, y_m=0.13, position_tolerance_m=0.03))
        self.environment_file = self.folder / "wall.yaml"
        limber.write_environment(self.environment_file, self.environment)


@functools.cache
def chain():
    """Made once a process."""
    return Chain()


class SpaceChain:
    """A recording of the hanging arm and a network of few epochs, made by the program."""

    def __init__(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="limber_space_")
        self.folder = pathlib.Path(self.temporary.name)
        self.recording = self.folder / "train.h5"
        self.model = self.folder / "model.safetensors"
        run_program("collect", "--arm", HANGING, "--schedule", "random", "--count", 6,
                    "--episodes", 3, "--hold-s", 1, "--seed", 4, "--out", self.recording,
                    folder=self.folder)
        run_program("train", "--arm", HANGING, "--data", self.recording, "--hidden", 16, 16,
                    "--epochs", 30, "--ensemble", 2, "--seed", 4, "--out", self.model,
                    folder=self.folder)
        self.arm = limber.load_arm(HANGING)
        self.episodes = limber.read_recording(self.recording).episodes


@functools.cache
def space():
    """Made once a process."""
    return SpaceChain()
