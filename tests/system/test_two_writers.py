"""Two runs with one output: the later one neither replaces the other's file nor mixes with it."""

import json
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ROOT, InFolder, limber
from test_plan import PILLAR

ARM = ("--arm", ROOT / "arms" / "two_segment.yaml")


class TwoWriters(InFolder):
    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, encoding="utf-8")

    def collection(self, seed):
        return ("collect", *ARM, "--schedule", "random", "--count", 30, "--episodes", 4, "--hold-s",
                1, "--seed", seed, "--jobs", 1, "--out", "c.h5")

    def wait_for(self, path):
        while not (self.folder / path).exists():
            time.sleep(0.01)

    def test_a_collection_begun_meanwhile_is_refused(self):
        first = self.start(*self.collection(1))
        self.wait_for("c.h5.parts")
        second = limber(*self.collection(2), folder=self.folder)
        _, error = first.communicate()
        self.assertEqual(first.returncode, 0, error)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertRegex(second.stderr, "c.h5.parts: another limber collect is writing there")
        described = json.loads(limber("inspect", "c.h5", "--json", folder=self.folder).stdout)
        self.assertEqual(described["seed"], 1)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["c.h5"])

    def test_a_file_that_was_made_meanwhile_stays(self):
        first = self.start(*self.collection(1))
        self.wait_for("c.h5.parts")
        (self.folder / "c.h5").write_bytes(b"theirs")
        _, error = first.communicate()
        self.assertNotEqual(first.returncode, 0)
        self.assertIn("c.h5: exists already", error)
        self.assertEqual((self.folder / "c.h5").read_bytes(), b"theirs")
        described = json.loads(limber("inspect", "c.h5.2", "--json", folder=self.folder).stdout)
        self.assertEqual(described["seed"], 1)

    def test_an_experiment_begun_meanwhile_is_refused_also_with_force(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 0.5, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 3, "--hidden", 8, "--out", "m.safetensors")
        (self.folder / "envs").mkdir()
        self.write("envs/a.yaml", json.dumps(PILLAR))
        experiment = ("experiment", *ARM, "--model", "m.safetensors", "--environments", "envs", "--trials", 2,
                      "--jobs", 1, "--max-queries", 30000, "--out", "out")
        first = self.start(*experiment, "--force")
        self.wait_for("out/experiment.json")
        first.send_signal(signal.SIGSTOP)  # in the middle of it, however fast the machine
        for flags in (("--force",), ("--resume",)):
            second = limber(*experiment, *flags, folder=self.folder)
            self.assertEqual(second.returncode, 2, second.stderr)
            self.assertIn("out: another limber experiment is writing there", second.stderr)
        self.assertIsNone(first.poll())
        first.send_signal(signal.SIGCONT)
        _, error = first.communicate()
        self.assertEqual(first.returncode, 0, error)
        resumed = limber(*experiment, "--resume", folder=self.folder)
        self.assertEqual(resumed.returncode, 0, resumed.stderr)


if __name__ == "__main__":
    unittest.main()
