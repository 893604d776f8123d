"""docs/first_day.md walked through with an arm that limber knows nothing of: examples/drivers/foreign_arm.py, whose valves,
sensors and tracker are crossed, mirrored and in mm. Its commands run as written, but for what a test has no time for, and
print what the page says."""

import re
import shlex
import shutil
import subprocess
import sys
import unittest

from program import PROGRAM, ROOT, InFolder

PAGE = (ROOT / "docs" / "first_day.md").read_text(encoding="utf-8")
FOREIGN_ARM = ROOT / "examples" / "drivers" / "foreign_arm.py"
NUMBER = re.compile(r"-?\d+(?:[.:]\d+)*")
# As fast as it is asked, fewer motions and a smaller network; and what a poor network's error leaves no room for.
SHORTER = (
    (r"--driver", "--simulated --driver"),
    (r"--start-from-driver", "--simulated --start-from-driver"),
    (r"--episodes 6", "--episodes 3"),
    (r"(limber train .*)", r"\1 --hidden 24 --epochs 20"),
    (r"(limber plan .*)", r"\1 --time-limit-s 10 --margin-m 0.001 --goal-margin-m 0 --goal-margin-rad 0"),
    (r"(limber execute .*)", r"\1 --max-start-error-m 0.05"),
    (r"exec:python3 my_driver.py", f"exec:{sys.executable} {FOREIGN_ARM} --fast"),
)
ENTER, LEFT = "\n" * 6, "l\n"  # what the operator of step 2 does


def blocks():
    """(language, text) of the page's fences, in order."""
    return re.findall(r"^```(\w*)\n(.*?)^```$", PAGE, flags=re.M | re.S)


def expectation(line):
    """A line of the page as a pattern: numbers are those of another run, … is anything."""
    parts = [NUMBER.split(part) for part in line.strip().split("…")]
    return ".*".join(r"-?[\d.:]+".join(map(re.escape, part)) for part in parts)


class FirstDay(InFolder):
    def run_block(self, command, answer=LEFT):
        for pattern, longer in SHORTER:
            command = re.sub(pattern, lambda match: match.expand(longer.replace("\\1", "\\g<1>")), command)
        command = re.sub(r"^limber", shlex.quote(PROGRAM), command)
        return subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=self.folder, input=ENTER + answer,
                              capture_output=True, encoding="utf-8")

    def test_the_ten_commands_print_what_the_page_says(self):
        shutil.copy(ROOT / "arms" / "two_segment.yaml", self.folder / "mine.yaml")
        ran, said = 0, ""
        for language, text in blocks():
            if language == "sh":
                result = self.run_block(text.strip())
                ran, said = ran + 1, result.stdout + result.stderr
                # `head` ends the pipe of the first; a small network may miss the goal of the last.
                allowed = {1: (0, 141), 10: (0, 1)}.get(ran, (0,))
                self.assertIn(result.returncode, allowed, f"{text}\n{said}")
            elif language == "yaml":
                self.write("room.yaml", text)
            else:
                for line in text.splitlines():
                    self.assertRegex(said, expectation(line))
        self.assertEqual(ran, 10)

    def test_a_wrong_answer_may_be_why_the_base_is_not_known(self):
        shutil.copy(ROOT / "arms" / "two_segment.yaml", self.folder / "mine.yaml")
        second = [text for language, text in blocks() if language == "sh"][1]
        result = self.run_block(second.strip(), answer="r\n")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("the base's frame is known to ±", result.stderr)
        self.assertIn("Left and right exchanged (--handedness) do this too", result.stderr)

    def test_without_a_calibration_it_stops_and_says_why(self):
        shutil.copy(ROOT / "arms" / "two_segment.yaml", self.folder / "mine.yaml")
        fourth = [text for language, text in blocks() if language == "sh"][3]
        result = self.run_block(fourth.strip().replace("--calibration calibration.yaml ", ""))
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertRegex(result.stderr, r"plate 0 jumped by .* The shape is 4[67]\d m long from plate to plate")
        self.assertIn("limber driver calibrate finds", result.stderr)
        self.assertIn("docs/first_day.md", result.stderr)


if __name__ == "__main__":
    unittest.main()
