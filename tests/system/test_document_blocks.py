"""Every code block of README.md and docs/: it is run here, in a folder with the files that the pages
speak of, or it stands below with the test that runs it or why nobody does. A new block that is
neither fails. Commands are shortened by SHORTER alone, since a test has minutes."""

import json
import os
import re
import shlex
import subprocess
import unittest

from program import PROGRAM, ROOT, InFolder

SHELL = ("sh", "bash")
# Fences without a language are drawings and output; math is typeset.
NOT_RUN = ("", "math")
# (page, beginning of the block): who runs it, or why nobody does.
ELSEWHERE = {
    ("README.md", "./demo.sh"): "test_demo.py; test.sh is what runs this",
    ("README.md", "const auto arm"): "installed_package.sh compiles it",
    ("README.md", "import limber"): "tests/python_module/test_examples.py",
    ("docs/python.md", "export PYTHONPATH"):
        "installed_package.sh, debian_package.sh, python_wheel.sh",
    ("docs/python.md", "import"): "tests/python_module/test_examples.py",
    ("docs/tutorial.md", "limber"): "test_tutorial.py",
    ("docs/tutorial_python.md", ""): "tests/python_module/test_tutorial.py",
    ("docs/cluster.md", "schema: limber/campaign/1"): "test_campaign.py reads campaigns",
    ("docs/cluster.md", "#!/bin/bash"): "test_campaign.py runs them",
    ("docs/studio.md", "limber studio"): "tests/studio/page_test.sh starts it",
    ("docs/studio.md", "ssh"): "needs another machine",
    ("docs/studio.md", "cd web"): "tests/studio/page_test.sh",
    ("docs/driver.md", "limber collect --arm mine.yaml"):
        "needs a board; test_example_drivers.py has one",
    ("docs/first_day.md", ""): "test_first_day.py walks through the page",
    ("docs/hardware.md", "limber driver check"): "in real time; test_driver.py checks drivers",
    ("docs/hardware.md", "limber execute"): "as below it, with --start-from-driver",
    ("docs/hardware.md", "limber collect --arm mine.yaml --schedule random --count 3"):
        "in real time; test_driver.py collects",
    ("docs/hardware.md", "limber characterize --arm one_segment.yaml"):
        "test_characterize_driver.py",
    ("docs/hardware.md", "limber driver calibrate"): "in real time; test_driver_calibrate.py",
    ("docs/hardware.md", "limber collect --schedule random --approach straight"):
        "measures in real time how punctual a machine is",
    ("docs/tracking.md", "tools/track_paths.py"): "test_track.py, with a shorter path",
    ("docs/importing.md", "schema: limber/import/1"): "an excerpt; test_import.py reads mappings",
    ("docs/importing.md", "pressures:"): "an excerpt; test_setpoints.py reads one",
    ("docs/importing.md", "time: {rate_hz: 40}"):
        "an excerpt; tests/logs/space_import_test.cpp reads such mappings",
    ("docs/importing.md", "commands:"): "an excerpt; examples/six_motors has it",
    ("docs/space.md", "schema: limber/arm/1"): "tests/arm/space_no_load_test.cpp reads such arms",
    ("docs/importing.md", "cp -r examples/six_motors"): "test_six_motors.py",
    ("docs/importing.md", "limber characterize --arm arm.yaml --commands"): "test_six_motors.py",
    ("docs/formats.md", "commands:"): "an excerpt; tests/arm/arm_commands_test.cpp",
    ("docs/importing.md", "command:"): "an excerpt; test_import.py has such arms",
    ("docs/families.md", "limber collect"): "test_family.py adapts, and plans with what it made",
    ("docs/improving.md", "limber improve"): "an hour; test_plan_schedule.py runs a small one",
    ("docs/improving.md", "limber collect"): "ten minutes; test_plan_schedule.py runs a small one",
    ("docs/tube.md", "limber calibrate"): "hours; test_calibrate.py runs small ones",
    ("docs/tube.md", "limber plan --model model.safetensors"):
        "59 runs; test_calibrate.py has them",
}
SHORTER = (
    (r"--trials 20 --time-limit-s 10", "--trials 1 --time-limit-s 0.1"),
    (r"--count 60 --episodes 10", "--count 10 --episodes 3"),
    (r"--count 100 --seed 7", "--count 10 --seed 7"),
    (r"--count 20 --episodes 6", "--count 6 --episodes 6"),
    (r" --calibration calibration.yaml", ""),  # the stand's driver speaks as the arm file does
    (r"(limber train .*)", r"\1 --hidden 16 --epochs 6"),
    (r"(limber plan .*)",
     r"\1 --time-limit-s 20 --margin-m 0.001 --goal-margin-m 0 --goal-margin-rad 0"),
)
# Exit codes besides 0 that are what the page says, or what small models make of it.
CODES = (("--fault die@30", (3,)), ("limber execute", (0, 1)), ("environments/03_gap_in_a_wall.yaml", (0, 1)),
         ("| head", (0, 141)))  # 141: head has seen enough


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def blocks():
    """(page, language, text) of every block that says something to a machine."""
    for page in pages():
        text = page.read_text(encoding="utf-8")
        for match in re.finditer(r"^```(\w*)\n(.*?)^```$", text, flags=re.M | re.S):
            if match[1] not in NOT_RUN:
                yield str(page.relative_to(ROOT)), match[1], match[2]


def elsewhere(page, text):
    return next((key for key in ELSEWHERE if key[0] == page and text.startswith(key[1])), None)


def commands(text):
    """Lines of a shell block, continued ones joined, without comments, shortened."""
    for line in re.sub(r"\\\n\s*", " ", text).splitlines():
        line = re.sub(r"\s+#.*", "", line)
        if line.strip():
            for long, short in SHORTER:
                line = re.sub(long, short, line)
            yield line


class Blocks(InFolder):
    def run_line(self, line, codes=(0,)):
        result = subprocess.run(
            ["bash", "-c", "set -o pipefail; " + line], cwd=self.folder, capture_output=True,
            encoding="utf-8", check=False, stdin=subprocess.DEVNULL,
            env={**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}"})
        self.assertIn(result.returncode, codes, f"{line}\n{result.stdout}{result.stderr}")

    def make_stand(self):
        """What the pages take for granted: an arm of mine, its recordings and model, a driver."""
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "limber").symlink_to(os.path.abspath(PROGRAM))
        for name in ("arms", "environments"):
            self.run_line(f"cp -r {shlex.quote(str(ROOT / name))} {name}")
        (self.folder / "my_driver.py").write_text(
            "import os\nos.execvp('limber', ['limber', 'virtual-arm', '--serve', '--arm',"
            " 'mine.yaml'])\n", encoding="utf-8")
        (self.folder / "bench.csv").write_text(
            "pressure_kpa,strain\n" + "".join(f"{p},{-0.0014 * p}\n" for p in range(0, 101, 10)),
            encoding="utf-8")
        for line in (
            "cp arms/three_segment.yaml mine.yaml",
            "cp environments/05_between_pillars.yaml room.yaml",
            "sed -i 's/^obstacles:.*/obstacles: []/; /^  - /d' room.yaml",
            "limber collect --schedule random --count 15 --episodes 3 --hold-s 1 --out recorded.h5",
            "limber train --data recorded.h5 --hidden 16 16 --epochs 30 --out model.safetensors",
            "mkdir out && cp model.safetensors out/ && cp recorded.h5 out/test.h5",
            "limber export recorded.h5 --motive take",
            "cp $(ls take/*.csv | grep -v press | head -1) take1.csv",
            "cp $(ls take/*press*.csv | head -1) pressures1.csv",
            "cp recorded.h5 recording.h5",
        ):
            self.run_line(line)

    def run_shell(self, page, text):
        # A page's blocks go on from its earlier ones, but each page begins with the stand.
        for line in commands(text):
            with self.subTest(page=page, line=line):
                codes = next((codes for part, codes in CODES if part in line), (0,))
                forced = re.sub(r"^limber [a-z-]+( csv| motive)?", r"\g<0> --force", line)
                self.run_line(forced, codes)

    def run_data(self, page, language, text):
        if language == "json":
            decoder, rest = json.JSONDecoder(), text.strip()
            while rest:
                message, end = decoder.raw_decode(rest)
                self.assertIn("type", message)
                rest = rest[end:].strip()
        elif text.startswith("schema: limber/environment/1"):
            (self.folder / "shown.yaml").write_text(text, encoding="utf-8")
            self.run_line("limber inspect shown.yaml")
        elif text.startswith("safety:"):
            arm = (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8")
            (self.folder / "safe.yaml").write_text(arm + text, encoding="utf-8")
            self.run_line("limber inspect safe.yaml")
        elif language == "python":
            (self.folder / "shown.py").write_text(
                "import h5py\npath = 'recorded.h5'\n" + text + "print(tip.shape)\n",
                encoding="utf-8")
            self.run_line("/usr/bin/python3 shown.py")
        else:
            self.fail(f"{page}: a {language} block that no test runs: {text[:60]!r}; run it here, "
                      "or say in ELSEWHERE who does")

    def test_every_block_runs(self):
        self.make_stand()
        for page, language, text in blocks():
            if elsewhere(page, text):
                continue
            if language in SHELL:
                self.run_shell(page, text)
            else:
                with self.subTest(page=page, block=text[:60]):
                    self.run_data(page, language, text)

    def test_what_stands_elsewhere_is_still_there(self):
        found = {elsewhere(page, text) for page, _, text in blocks()}
        self.assertEqual(set(ELSEWHERE) - found, set())


if __name__ == "__main__":
    unittest.main()
