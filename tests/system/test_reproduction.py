"""tools/reproduction.py and reproduction_readings.py run small; docs/reproduction.md shows what they print."""

import json
import os
import pathlib
import subprocess
import sys
import unittest

from program import PROGRAM, ROOT, InFolder

RECORDS = ROOT / "docs/log/reproduction"
MODULE = pathlib.Path(PROGRAM).parents[1] / "python"
PAGES = (ROOT / "docs/reproduction.md", *sorted((ROOT / "docs/log").glob("*-reproduction-*.md")))


def script(name, *arguments):
    done = subprocess.run([sys.executable, str(ROOT / "tools" / name), "--limber", PROGRAM, *map(str, arguments)],
                          capture_output=True, encoding="utf-8", check=False, cwd=ROOT,
                          env={**os.environ, "PYTHONPATH": str(MODULE)})
    assert done.returncode == 0, done.stderr
    return done.stdout


def rows(text):
    return [line for line in text.splitlines() if line.startswith("| ")]


@unittest.skipUnless(MODULE.is_dir(), "built without the Python module")
class Reproduction(InFolder):
    def test_a_reading_is_trained_measured_and_kept(self):
        arguments = ("--out", self.folder, "--arms", "own", "--readings", "unbounded", "--epochs", 12,
                     "--transitions", 24, "--motions", 8)
        printed = script("reproduction_readings.py", *arguments)
        kept = self.folder / "own/reading_unbounded.json"
        self.assertEqual(json.loads(kept.read_text(encoding="utf-8"))["epochs"], 12)
        # Without network, without memory, and the reading: for both tests.
        self.assertEqual(len([row for row in rows(printed) if not row.startswith("| reading")]), 6)
        self.assertEqual(script("reproduction_readings.py", *arguments, "--print"), printed)

    def test_table_1_counts_what_was_executed(self):
        model = self.folder / "model.safetensors"
        self.run_limber("collect", "--schedule", "random", "--count", 20, "--out", "small.h5")
        self.run_limber("train", "--data", "small.h5", "--epochs", 3, "--out", model.name)
        printed = script("reproduction.py", "--out", self.folder / "out", "--model", model, "--parts", "table_1",
                         "--trials", 1, "--queries", 20000)
        trials = [json.loads(path.read_text(encoding="utf-8"))
                  for path in (self.folder / "out/table_1/trials").glob("*.json")]
        self.assertEqual(len(trials), 16)
        solved = {model: sum(trial["execution"] is not None for trial in trials if trial["model"] == model)
                  for model in ("no_load", "network")}
        last = rows(printed)[-1].split(" | ")
        self.assertEqual((last[1], last[6]), tuple(f"{solved[model]} of 8" for model in ("no_load", "network")))

    def test_every_table_of_the_pages_is_what_the_scripts_print(self):
        pages = "\n".join(path.read_text(encoding="utf-8") for path in PAGES)
        printed = script("reproduction_readings.py", "--out", RECORDS, "--print")
        if (RECORDS / "table_1.json").exists():
            printed += script("reproduction.py", "--out", RECORDS, "--print")
        self.assertGreater(len(rows(printed)), 6)
        for row in rows(printed):
            self.assertIn(row, pages)


if __name__ == "__main__":
    unittest.main()
