"""examples/python, from a recording to an executed plan, and the page of names that the build makes."""

import pathlib
import re
import subprocess
import sys
import unittest

import limber
from chain import EXAMPLES, ROOT, InFolder, chain, run_example, run_program

PUBLIC = sorted(name for name in vars(limber) if not name.startswith("_")
                and getattr(getattr(limber, name), "__module__", "").startswith("limber"))


def python_blocks(page):
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), flags=re.M | re.S)


def run_in(folder, code):
    subprocess.run([sys.executable, "-c", code], cwd=folder, check=True, input=b"")


class Examples(InFolder):
    def run_to_end(self, name, *arguments, codes=(0,)):
        result = run_example(name, *arguments, folder=self.folder)
        self.assertIn(result.returncode, codes, result.stdout + result.stderr)
        self.assertNotIn("Traceback", result.stderr)
        return result.stdout

    def test_the_chain(self):
        trained = self.run_to_end("02_record_and_train.py", "train.h5", "model.safetensors", 90)
        self.assertIn("epoch 90: loss", trained)
        self.assertIn("unseen runs", trained)
        queried = self.run_to_end("01_query_the_model.py", "model.safetensors", 60)
        self.assertIn("2 s: tip at", queried)
        self.assertRegex(queried, "segment 0 at (60|59)")
        self.run_readme()
        environment = limber.data_folder() / "environments" / "01_pillar.yaml"
        # A network of ninety epochs: its plans may be none, and need not arrive.
        planned = self.run_to_end("03_plan_and_verify.py", "model.safetensors", environment,
                                  "plan.json", codes=(0, 1))
        self.assertRegex(planned, "(?m)^certified: |^no plan: ")
        run_program("plan", "--model", "model.safetensors", "--environment", "01_pillar",
                    "--margin-m", 0, "--goal-margin-m", 0, "--goal-margin-rad", 0,
                    "--max-queries", 100000, "--out", "wrong.json", folder=self.folder)
        executed = self.run_to_end("04_execute.py", "wrong.json", environment,
                                   "model.safetensors", codes=(0, 1))
        self.assertRegex(executed, "(?m)^open loop: done")
        self.assertRegex(executed, "(?m)^closed loop: (done|stopped)")
        nudged = self.run_to_end("11_your_own_controller.py", "wrong.json", environment)
        self.assertRegex(nudged, r"^done: [\d.]+ cm from the goal")
        own = self.run_to_end("06_plug_in_a_planner.py", "model.safetensors", environment,
                              "own.json", codes=(0, 1))
        self.assertRegex(own, "(?m)^own.json: .* certified$|^no plan: ")
        beside = run_example("07_ompl.py", "model.safetensors", environment, folder=self.folder)
        self.assertRegex(beside.stdout, "(?m)^default: ")
        if beside.returncode:  # limber without OMPL says so, and how to get it
            self.assertIn("libompl-dev", beside.stderr)
        else:
            self.assertRegex(beside.stdout, "(?m)^ompl:RRT: ")

    def test_without_a_network(self):
        self.assertIn(" -> ", self.run_to_end("09_reach_a_pose.py", 0.45, 0.3))
        self.run_to_end("09_reach_a_pose.py", 5, 5, codes=(1,))
        self.run_to_end("10_draw_the_arm.py", "arm.svg", 40, -40, 40)
        self.assertIn("<svg", (self.folder / "arm.svg").read_text(encoding="utf-8"))

    def test_an_arm_in_space(self):
        printed = self.run_to_end("12_arm_in_space.py", "space.h5", "space.safetensors", 40)
        off_mm = dict(re.findall(r"(?m)^(no load|networks): tip ([\d.]+) mm off", printed))
        self.assertLess(float(off_mm["networks"]), float(off_mm["no load"]))
        self.assertRegex(printed, r"(?m)^at the end: tip at .* m, give or take [\d.]+ mm$")
        self.assertRegex(printed, r"(?m)^after one frame: tip [\d.]+ mm off$")

    def test_every_example_has_its_twin(self):
        own = {path.stem for path in EXAMPLES.glob("[0-9]*.py")}
        theirs = {path.stem for path in (ROOT / "examples" / "cpp").glob("[0-9]*.cpp")}
        self.assertEqual(own - theirs, {"08_train_in_pytorch"})
        self.assertEqual(theirs - own, set())

    def run_readme(self):
        """The README's lines, in a folder that has what they name."""
        for name in ("arms", "environments"):
            (self.folder / name).symlink_to(ROOT / name)
        (self.folder / "out").mkdir()
        (self.folder / "out" / "model.safetensors").symlink_to(self.folder / "model.safetensors")
        blocks = python_blocks(ROOT / "README.md")
        self.assertEqual(len(blocks), 1)
        run_in(self.folder, blocks[0])

    def test_an_arm_of_ones_own(self):
        recording = limber.read_recording(chain().recording)
        *logs, mapping = limber.export_csv(recording, self.folder / "logs")
        printed = self.run_to_end("05_bring_your_own_arm.py", ROOT / "arms" / "two_segment.yaml",
                                  mapping, chain().environment_file, "plan.json", 30, *logs,
                                  codes=(0, 1))
        self.assertRegex(printed, r"(?m)^plan.json: \d+ frames|^no plan: ")


class Documents(InFolder):
    def test_the_pages_code_runs(self):
        blocks = python_blocks(ROOT / "docs" / "python.md")
        (driver,) = [block for block in blocks if "limber.driver.serve" in block]
        (self.folder / "my_driver.py").write_text(driver, encoding="utf-8")
        self.assertGreaterEqual(len(blocks), 3)
        for block in blocks:
            run_in(self.folder, block)

    def test_the_readme_plans_in_four_lines_and_four_calls_as_example_03(self):
        page = (ROOT / "README.md").read_text(encoding="utf-8")
        (cpp,) = re.findall(r"^```cpp\n(.*?)^```", page, flags=re.M | re.S)
        (own,) = python_blocks(ROOT / "README.md")
        self.assertEqual(own.splitlines()[0], "import limber")
        self.assertEqual((len(own.splitlines()[1:]), len(cpp.splitlines())), (4, 4))
        calls = ["load_arm", "load_environment", "plan", "write_plan"]
        example = "03_plan_and_verify"
        for text in (cpp, own, (EXAMPLES / f"{example}.py").read_text(encoding="utf-8"),
                     (ROOT / "examples" / "cpp" / f"{example}.cpp").read_text(encoding="utf-8")):
            found = re.findall(r"limber(?:\.|::)(\w+)\(", text)
            self.assertEqual([name for name in found if name != "data_folder"][:4], calls)


class Names(unittest.TestCase):
    def test_the_build_lists_every_public_name_with_a_line(self):
        page = pathlib.Path(limber.__file__).parents[1] / "names.md"
        listed = dict(re.findall(r"^\| `(\w+)` \| (.+) \|$", page.read_text(encoding="utf-8"), flags=re.M))
        self.assertEqual(sorted(listed), PUBLIC)
        self.assertIn("Pose of the end effector", listed["tip_pose"])

    def test_every_public_name_says_what_it_is(self):
        for name in PUBLIC:
            self.assertTrue(getattr(limber, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
