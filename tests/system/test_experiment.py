"""`limber experiment`: the table, its files, resuming, and the same result for any number of jobs."""

import json
import math
import os
import statistics
import unittest

from program import InFolder
from test_plan import PILLAR, changed

ARM = ("--arm", "two_segment")
KPA_PER_PSI = 6.894757293168361
ROW_KEYS = {
    "environment", "model", "planner", "controller", "disturbance", "trials", "solved",
    "not_certified", "first_solution_s", "first_candidate_s", "first_certificate_s",
    "first_solution_cost_psi", "cost_psi", "executed", "collided", "reached", "stopped_ahead",
    "distance_to_goal_cm", "distance_to_goal_without_collision_cm", "orientation_to_goal_rad",
    "orientation_to_goal_without_collision_rad",
}


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
            for key in ("first_solution_s", "first_candidate_s", "first_certificate_s"):
                del row[key]  # clock
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

    def test_the_tables_figures_are_those_of_its_trials(self):
        """The keys of docs/experiments.md, all of them and no other; and values, from the trials."""
        self.experiment("out")
        trials = [json.loads(path.read_text(encoding="utf-8"))
                  for path in sorted((self.folder / "out" / "trials").iterdir())]
        for row in json.loads((self.folder / "out" / "table.json").read_text(encoding="utf-8")):
            self.assertEqual(set(row), ROW_KEYS)
            mine = [trial for trial in trials
                    if all(trial[key] == row[key] for key in ("environment", "model", "planner"))]
            solved = [trial for trial in mine if trial["status"] == "solved"]
            runs = [trial["execution"] for trial in solved]
            free = [run for run in runs if not run["collided"]]
            self.assertEqual(row["trials"], len(mine))
            self.assertEqual(row["solved"], len(solved))
            self.assertEqual(row["not_certified"],
                             sum(trial["status"] == "not_certified" for trial in mine))
            self.assertEqual(row["executed"], len(runs))
            self.assertEqual(row["collided"], len(runs) - len(free))
            self.assertEqual(row["reached"], sum(run["goal_reached"] for run in runs))
            for key, values in (
                ("cost_psi", [trial["cost_psi"] for trial in solved]),
                ("first_solution_s", [trial["first_solution"]["time_s"] for trial in solved]),
                ("first_solution_cost_psi",
                 [trial["first_solution"]["cost_kpa"] / KPA_PER_PSI for trial in solved]),
                ("first_candidate_s", [trial["first_candidate_s"] for trial in solved]),
                ("first_certificate_s", [trial["first_certificate_s"] for trial in solved]),
                ("distance_to_goal_cm", [run["distance_to_goal_cm"] for run in runs]),
                ("distance_to_goal_without_collision_cm",
                 [run["distance_to_goal_cm"] for run in free]),
                ("orientation_to_goal_rad", []),  # no goal here asks for a heading
                ("orientation_to_goal_without_collision_rad", []),
            ):
                with self.subTest(row=row["environment"], model=row["model"], key=key):
                    self.assert_figures(row[key], values)

    def assert_figures(self, found, values):
        self.assertEqual(set(found), {"mean", "median", "p95", "standard_error", "count"})
        self.assertEqual(found["count"], len(values))
        expected = {
            "mean": statistics.fmean(values) if values else None,
            "median": statistics.median(values) if values else None,
            "standard_error": (statistics.stdev(values) / math.sqrt(len(values))
                               if len(values) > 1 else None),
        }
        for name, value in expected.items():
            if value is None:
                self.assertIsNone(found[name], name)
            else:
                self.assertAlmostEqual(found[name], value, delta=1e-6 * abs(value) + 1e-9, msg=name)
        if values:
            self.assertGreaterEqual(found["p95"], found["median"])
            self.assertLessEqual(found["p95"], max(values) * (1 + 1e-6))

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

    def test_no_input_and_nobody_elses_file_is_ever_removed(self):
        self.experiment("x")
        for name in ("m.safetensors", "environments"):
            (self.folder / name).rename(self.folder / "x" / name)
        command = ("experiment", *ARM, "--max-iterations", 10, "--trials", 1, "--out", "x")
        before = sorted(self.folder.rglob("*"))
        for flags in (
            ("--model", "x/m.safetensors", "--environments", "x/environments"),
            ("--model", "./x/../x/m.safetensors"),
        ):
            for force in ((), ("--force",), ("--resume",)):
                error = self.run_limber(*command, *flags, *force, code=2).stderr
                self.assertIn("lies in x, the folder for results", error)
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        for name in ("m.safetensors", "environments"):
            (self.folder / "x" / name).rename(self.folder / name)
        (self.folder / "x" / "trials" / "my_notes.txt").write_text("mine", encoding="utf-8")
        inputs = ("--model", "m.safetensors", "--environments", "environments")
        said = self.run_limber(*command, *inputs, "--force").stderr
        self.assertIn("did not write them or they have changed since: trials/my_notes.txt", said)
        self.assertEqual((self.folder / "x" / "trials" / "my_notes.txt").read_text(), "mine")
        # A result that was changed by hand is its owner's from then on.
        (self.folder / "x" / "table.md").write_text("mine", encoding="utf-8")
        error = self.run_limber(*command, *inputs, "--force", code=2).stderr
        self.assertIn("x/table.md: limber experiment did not write this file", error)
        self.assertEqual((self.folder / "x" / "table.md").read_text(), "mine")

    def test_trials_of_another_experiment_and_damaged_ones_are_refused(self):
        self.experiment("one")
        self.experiment("two", "--seed", 2)
        names = sorted(path.name for path in (self.folder / "one" / "trials").iterdir())
        trial = self.folder / "one" / "trials" / names[0]
        good = trial.read_bytes()
        table = (self.folder / "one" / "table.json").read_bytes()

        def refused():
            return self.run_limber(
                "experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
                "--max-iterations", 150, "--trials", 2, "--out", "one", "--resume", code=2,
            ).stderr

        trial.write_bytes((self.folder / "two" / "trials" / names[0]).read_bytes())
        self.assertRegex(refused(), f"one/trials/{names[0]}: belongs_to.experiment: .* remove one/")
        damaged = json.loads(good)
        damaged["execution"] = {"status": "done", "final_backbone": [[]]}
        for text in (json.dumps(damaged), "[]", "{" + '"a":' + "[" * 200000, '{"a": 1e309}'):
            trial.write_text(text, encoding="utf-8")
            self.assertIn(f"one/trials/{names[0]}: ", refused())
        for field, edited in (("environment", "b"), ("model", "other"), ("planner", "paper"),
                              ("seed", 5), ("time_s", 1e308), ("nodes", 3)):
            trial.write_text(json.dumps({**json.loads(good), field: edited}), encoding="utf-8")
            self.assertRegex(refused(), f"one/trials/{names[0]}: ({field}: |has changed since)")
        trial.write_bytes(good)
        (self.folder / "one" / "experiment.json").write_text("[1]", encoding="utf-8")
        self.assertIn("one/experiment.json: [1] found; expected a JSON object", refused())
        self.assertEqual((self.folder / "one" / "table.json").read_bytes(), table)

    def test_all_ways_execute_the_same_plans(self):
        self.experiment("out", "--controller", "open", "--controller", "jacobian", "--disturbance", "none",
                        "--disturbance", "friction")
        plans = {}
        for path in (self.folder / "out" / "trials").iterdir():
            trial = json.loads(path.read_text(encoding="utf-8"))
            key = (trial["environment"], trial["model"], trial["seed"])
            plans.setdefault(key, []).append((trial["cost_kpa"], trial["time_s"]))
        self.assertEqual({len(same) for same in plans.values()}, {4})
        self.assertEqual({len(set(same)) for same in plans.values()}, {1})
        log = (self.folder / "out" / "planner_arena" / "a.log").read_text(encoding="utf-8")
        self.assertIn("\n2 runs per planner\n", log)

    def test_two_environments_whose_pictures_would_be_one_are_refused(self):
        self.write("environments/a_all.yaml", json.dumps(PILLAR))
        error = self.run_limber("experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
                                "--max-iterations", 10, "--out", "bad", code=2).stderr
        self.assertIn("environments a and a_all", error)

    def test_an_environment_whose_name_is_not_utf8_is_named(self):
        folder = os.fsencode(self.folder / "environments")
        with open(os.path.join(folder, b"\xff.yaml"), "w", encoding="utf-8") as file:
            file.write(json.dumps(PILLAR))
        error = self.run_limber("experiment", *ARM, "--model", "m.safetensors", "--environments", "environments",
                                "--max-iterations", 10, "--out", "bad", code=2).stderr
        self.assertIn("the name is not UTF-8; rename the file", error)

    def test_bad_input_is_named_before_any_work(self):
        for arguments, message in (
            (("--environments", "environments", "--planner", "fast"), "planner 'fast'"),
            (("--environments", "none"), "--environment none: no such file"),
            (("--environments", "environments", "--trials", 0), "--trials 0"),
            (("--environments", "environments", "--motion-queries", 500), "are of closed loop"),
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
