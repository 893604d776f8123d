"""What the system tests share: running the program as a user does."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("LIMBER_PROGRAM", str(ROOT / "build" / "release" / "bin" / "limber"))


def limber(*arguments, folder=None, environment=None):
    """Runs the program to its end."""
    return subprocess.run(
        [PROGRAM, *map(str, arguments)],
        cwd=folder,
        env={**os.environ, **(environment or {})},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


def temporary_files(folder):
    """Files that were being written when the program ended, or are now: what goes meanwhile is left out."""
    return sorted(pathlib.Path(where) / name for where, folders, files in os.walk(folder)
                  for name in folders + files if name.startswith(".") and name.endswith(".tmp"))


def cpu_levels():
    """Every CPU level that this machine runs, as LIMBER_CPU takes them."""
    wanted = ("baseline", "avx2", "avx512")
    return [
        level for level in wanted if limber("doctor", environment={"LIMBER_CPU": level}).returncode == 0
    ]


def verbs():
    """Every verb that the program has."""
    subcommands = limber("--help").stdout.split("Subcommands:")[1]
    return re.findall(r"^  ([a-z-]+) ", subcommands, flags=re.M)


def numeric_flags(verb):
    """Every flag of a verb that takes numbers, with its kind: [("--seed", "UINT"), …]."""
    text = limber(verb, "--help").stdout
    return re.findall(r"^  (?:-\w,)?(--[a-z-]+)(?:,--[a-z-]+)* (INT|UINT|FLOAT)\b", text, flags=re.M)


class InFolder(unittest.TestCase):
    """A test with a fresh folder of its own, self.folder."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="limber_test_")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_limber(self, *arguments, code=0):
        result = limber(*arguments, folder=self.folder)
        if code is None:  # the test looks at it itself
            return result
        self.assertEqual(
            result.returncode, code, f"limber {' '.join(map(str, arguments))}\n{result.stderr}"
        )
        return result

    def run_json(self, *arguments, code=0):
        """The one JSON object that --json prints: nothing else may be on standard output."""
        result = self.run_limber(*arguments, "--json", code=code)
        return json.loads(result.stdout)

    def run_execution(self, *arguments):
        """What `limber execute --json` prints: it ends with 0 where the arm arrived, and with 1 and
        a reason where it did not."""
        result = self.run_limber("execute", *arguments, "--json", code=None)
        found = json.loads(result.stdout)
        arrived = found["goal_reached"] is True and found["collided"] is False
        self.assertEqual(result.returncode, 0 if arrived else 1, result.stderr)
        self.assertEqual(arrived, found["message"] == "")
        self.assertIn("" if arrived else f"error: {found['message']}", result.stderr)
        return found

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path


class WithFiles(InFolder):
    """Each test has copies of the files that FILES names, with the commands that make them once a class."""

    FILES = ()

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = {}

    def setUp(self):
        super().setUp()
        for name, command in self.FILES:
            path = self.folder / name
            if name in self.made:
                path.write_bytes(self.made[name])
            else:
                self.run_limber(*command, "--out", name)
                self.made[name] = path.read_bytes()
