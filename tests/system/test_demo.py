"""`limber demo --quick`: the whole chain, its files, its report, whose folder it may replace, and the
documents' commands that go on from it."""

import json
import re
import shlex
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from program import ROOT, InFolder, cpu_levels, limber

# What makes a documented command take seconds instead of minutes; the rest runs as printed.
SHORTER = {
    "bench": {"--queries": 1000},
    "experiment": {"--trials": 1, "--time-limit-s": 0.2},
    "plan": {"--max-queries": 100_000, "--cost-threshold": 1e6},
}

FILES = ("train.h5", "test.h5", "model.safetensors", "report.html", "summary.json")


class Demo(InFolder):
    def test_runs_from_bench_test_to_report(self):
        self.run_limber("demo", "--quick", "--seed", 3)
        out = self.folder / "out"
        for name in FILES:
            self.assertGreater((out / name).stat().st_size, 0, name)
        self.check_summary(json.loads((out / "summary.json").read_text(encoding="utf-8")))
        self.check_report((out / "report.html").read_text(encoding="utf-8"))
        self.check_results_table()
        self.check_arm()
        self.check_documented_commands()
        self.check_folder_rules()

    def check_summary(self, summary):
        for key in ("evaluation", "bench", "plans", "executions", "wall_time_s"):
            self.assertIn(key, summary)
        self.assertEqual([row["first_plan"] for row in summary["arrivals"]], [True, False])
        for row in summary["arrivals"]:
            self.assertEqual(row["plans"], 8)
            self.assertLessEqual(row["arrived"] + row["collided"], row["solved"])
        self.assertGreaterEqual(len({plan["environment"] for plan in summary["plans"]}), 3)
        self.assertEqual({run["model"] for run in summary["executions"]}, {"no_load", "network"})
        arrived = [run["goal_reached"] and not run["collided"]
                   for run in summary["executions"] if run["model"] == "network"]
        self.assertEqual(arrived, [True] * 3)
        # Even little data beats the model without any.
        self.assertGreater(summary["evaluation"]["reduction_percent"]["position"], 0.0)

    def check_report(self, html):
        root = xml.etree.ElementTree.fromstring(html.split("\n", 1)[1])
        self.assertGreaterEqual(sum(element.tag == "figure" for element in root.iter()), 5)
        without_namespace = html.replace('xmlns="http://www.w3.org/2000/svg"', "")
        loaded = re.findall(r"""(?:src|href)\s*=\s*["'](?!#)[^"']*|url\([^)]*|<script[^>]*""",
                            without_namespace)
        self.assertEqual(loaded, ["<script"])  # its own, within the page
        self.assertIn("1 plan of each model, 5 s each", html)
        self.assertIn("over planning time", html)
        self.assertNotIn("nan", re.findall(r'="[^"]*\bnan\b', html))

    def check_results_table(self):
        table = subprocess.run(
            [sys.executable, ROOT / "tools" / "results_table.py", "out/summary.json"],
            cwd=self.folder, capture_output=True, encoding="utf-8", check=True,
        )
        self.assertIn("| reduction by the network", table.stdout)

    def check_arm(self):
        """What the bench test fitted is the arm that was asked for, on this machine too."""
        own = self.run_json("inspect", ROOT / "arms" / "three_segment.yaml")
        self.assertEqual(self.run_json("inspect", "out/arm.yaml")["hash"], own["hash"])

    def documented_commands(self):
        """Commands of README.md and docs/ that take the demo's results, as lists of words."""
        for document in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
            text = document.read_text(encoding="utf-8").replace("\\\n", " ")
            for command in re.findall(r"(?:^ *|`)(limber [^`\n]*\bout/[^`\n]*)", text, flags=re.M):
                words = shlex.split(command, comments=True)
                yield document.name, words[1:]

    def check_documented_commands(self):
        commands = list(self.documented_commands())
        self.assertLessEqual(
            {"bench", "evaluate", "experiment", "plan", "verify"},
            {words[0] for _, words in commands},
        )
        for level in cpu_levels():
            for document, words in commands:
                for flag, value in SHORTER.get(words[0], {}).items():
                    if flag in words:
                        del words[words.index(flag) : words.index(flag) + 2]
                    words += [flag, str(value)]
                with self.subTest(level=level, document=document, command=" ".join(words)):
                    result = limber(*words, "--force", folder=self.folder,
                                    environment={"LIMBER_CPU": level})
                    self.assertEqual(result.returncode, 0, result.stderr)

    def check_folder_rules(self):
        """A folder with somebody's files is refused; nothing in it changes."""
        other = self.folder / "precious"
        other.mkdir()
        (other / "thesis.txt").write_text("years of work", encoding="utf-8")
        result = self.run_limber("demo", "--quick", "--out", "precious", code=2)
        self.assertIn("--force", result.stderr)
        self.assertEqual([path.name for path in other.iterdir()], ["thesis.txt"])
        result = self.run_limber("demo", "--quick", "--arm", "out/arm.yaml", code=2)
        self.assertIn("out/arm.yaml lies in out, the folder for results", result.stderr)
        (self.folder / "out" / "train.h5").write_bytes(b"mine")
        result = self.run_limber("demo", "--quick", code=2)
        self.assertIn("out/train.h5: limber demo did not write this file", result.stderr)
        self.assertEqual((self.folder / "out" / "train.h5").read_bytes(), b"mine")


if __name__ == "__main__":
    unittest.main()
