"""docs/tutorial.md: every command in it is run, in order, in a copy of its folder, and timed."""

import json
import os
import re
import shutil
import subprocess
import time
import unittest

from program import PROGRAM, ROOT, InFolder


class Tutorial(InFolder):
    def commands(self):
        text = (ROOT / "docs" / "tutorial.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```sh\n(.*?)^```", text, flags=re.S | re.M)
        return [line for block in blocks for line in block.splitlines() if line.strip()]

    def run_line(self, line):
        begin = time.monotonic()
        result = subprocess.run(
            ["bash", "-c", line], cwd=self.folder / "mine", capture_output=True, encoding="utf-8",
            env={**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"}, check=False,
        )
        print(f"{time.monotonic() - begin:6.1f} s  {line}")
        self.assertEqual(result.returncode, 0, f"{line}\n{result.stdout}{result.stderr}")
        return result.stdout

    def test_every_command_does_what_the_page_says(self):
        shutil.copytree(ROOT / "docs" / "tutorial", self.folder / "mine")
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "limber").symlink_to(os.path.abspath(PROGRAM))
        said = {}
        for line in self.commands():
            said[line.split()[1]] = said.get(line.split()[1], "") + self.run_line(line)
        self.assertIn("episode 6 (trial_6.csv) is broken", said["import"])
        self.assertEqual(said["import"].count("is broken"), 1)
        levels = re.search(r"correlate by ([0-9., ]+)", said["import"]).group(1)
        self.assertTrue(all(float(value) > 0.8 for value in levels.split(",")), levels)
        self.assertIn("95 % intervals", said["characterize"])
        self.assertIn("fitted simple model", said["evaluate"])
        self.assertIn("certified", said["verify"])
        self.assertIn("by other.safetensors: ends", said["verify"])
        self.assertTrue((self.folder / "mine" / "plots" / "error_over_horizon.svg").exists())
        errors = self.run_json(
            "evaluate", "--arm", "mine/fitted.yaml", "--model", "mine/model.safetensors", "--data",
            "mine/test.h5", "--fit", "mine/train.h5",
        )
        network = errors["network"]["open_loop"]["position_error_cm"]["mean"]
        simple = errors["baselines"]["simple_model"]["open_loop"]["position_error_cm"]["mean"]
        self.assertLess(network, simple, "what the page says of a network worth planning with")
        plan = json.loads((self.folder / "mine" / "plan.json").read_text(encoding="utf-8"))
        self.assertGreater(len(plan["frames"]), 5)


if __name__ == "__main__":
    unittest.main()
