"""`limber experiment`: the table, its files, resuming, and the same result for any number of jobs."""

import json
import unittest

from program import InFolder
from test_plan import PILLAR, changed

ARM = ("--arm", "two_segment")


class Experiment(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 20, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 3, "--out", "m.safetensors")
        (self.folder / "environments").mkdir()
        self.write("environments/a.yaml", json.dumps(PILLAR))
        self.write("environments/b.yaml", json.dumps(changed(name="nothing there", obstacles=[])))

    def experiment(self, out, *arguments, code=0):
        return self.run_json(
            "experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
            "--max-iterations", 150, "--trials", 2, "--out", out, *arguments, code=code,
        )

    def table(self, out):
        table = json.loads((self.folder / out / "table.json").read_text(encoding="utf-8"))
        for row in table:
            del row["first_solution_s"]  # clock
        return table

    def test_the_table_does_not_depend_on_jobs_or_on_stopping_and_resuming(self):
        printed = self.experiment("one", "--jobs", 1)
        self.assertEqual(
            [(row["environment"], row["model"]) for row in printed["table"]],
            [("a", "no_load"), ("a", "network"), ("b", "no_load"), ("b", "network")],
        )
        self.assertTrue(all(row["trials"] == 2 for row in printed["table"]))
        for name in ("table.md", "report.html", "figures/a.svg", "figures/b_all.svg",
                     "planner_arena/a.log", "experiment.json"):
            self.assertTrue((self.folder / "one" / name).exists(), name)
        self.experiment("two", "--jobs", 2)
        self.assertEqual(self.table("one"), self.table("two"))
        # As if it had been stopped: two trials are missing, and the table.
        trials = sorted((self.folder / "two" / "trials").iterdir())
        self.assertEqual(len(trials), 8)
        for path in (trials[1], trials[6], self.folder / "two" / "table.json"):
            path.unlink()
        self.experiment("two", "--resume")
        self.assertEqual(self.table("one"), self.table("two"))

    def test_resuming_another_experiment_or_replacing_one_is_refused(self):
        self.experiment("out")
        error = self.run_limber(
            "experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
            "--max-iterations", 151, "--trials", 2, "--out", "out", "--resume", code=2,
        ).stderr
        self.assertIn("max_iterations = 150; this run has 151", error)
        error = self.run_limber(
            "experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
            "--max-iterations", 150, "--trials", 2, "--out", "out", code=2,
        ).stderr
        self.assertIn("--resume continues it", error)

    def test_bad_input_is_named_before_any_work(self):
        for arguments, message in (
            (("--environments", "environments", "--planner", "fast"), "planner 'fast'"),
            (("--environments", "none"), "none: no folder"),
            (("--environments", "environments", "--trials", 0), "--trials 0"),
        ):
            with self.subTest(message=message):
                error = self.run_limber(
                    "experiment", *ARM, "--model", "m.safetensors", "--max-iterations", 10,
                    *arguments, "--out", "bad", code=2,
                ).stderr
                self.assertIn(message, error)
                self.assertFalse((self.folder / "bad").exists())


if __name__ == "__main__":
    unittest.main()
