"""`--disturbance` and `--controller`: rows of their own, the same for any number of jobs; what there is
not is refused by name."""

import json
import subprocess
import sys
import unittest

from program import PROGRAM, ROOT, InFolder
from test_plan import PILLAR

ARM = ("--arm", "two_segment")


class Disturbance(InFolder):
    def setUp(self):
        super().setUp()
        self.write("e.yaml", json.dumps(PILLAR))

    def plan(self):
        self.run_limber("plan", *ARM, "--no-load", "--max-iterations", 300, "--environment",
                        "e.yaml", "--out", "p.json")

    def execute(self, *arguments):
        return self.run_execution(*ARM, "--plan", "p.json", "--environment", "e.yaml", *arguments)

    def test_a_disturbed_arm_ends_elsewhere_and_its_seed_repeats_it(self):
        self.plan()
        calm = self.execute()
        self.assertNotIn("disturbance", calm)
        for kind in ("tip_load=0.2", "friction", "weak_actuator"):
            found = self.execute("--disturbance", kind, "--seed", 4)
            self.assertEqual(found["disturbance"], kind)
            self.assertNotEqual(found["final_backbone"], calm["final_backbone"], kind)
            self.assertEqual(found, self.execute("--disturbance", kind, "--seed", 4))
        self.execute("--disturbance", "friction", "--seed", 4, "--out", "run.h5")
        self.assertEqual(self.run_json("inspect", "run.h5")["seed"], 4)
        # Noise and lost tracking are the sensor's: the arm itself moves as it did.
        for kind in ("noise", "lost_tracking", "noise,lost_tracking"):
            found = self.execute("--disturbance", kind)
            self.assertEqual(found["final_backbone"], calm["final_backbone"], kind)

    def served(self, *flags):
        words = [str(PROGRAM), "virtual-arm", "--serve", "--fast", *flags]
        return "exec:" + " ".join(f"'{word}'" for word in words)

    def test_behind_the_driver_protocol_the_arm_is_disturbed_alike(self):
        self.plan()
        for kind, more in (("friction", ARM), ("weak_actuator", ARM),
                           ("noise,lost_tracking", (*ARM, "--plan", "p.json"))):
            flags = ("--disturbance", kind, "--seed", "4")
            served = self.execute("--driver", self.served(*flags, *more), "--simulated", "--out", f"{kind}.h5")
            direct = self.execute(*flags)
            if kind == "noise,lost_tracking":
                # Seen late and noisy, where the virtual arm's true shape is known in `direct`.
                self.assertLess(abs(served["distance_to_goal_cm"] - direct["distance_to_goal_cm"]), 0.5)
                frames = self.run_json("inspect", f"{kind}.h5")["frames_dropped"]
                self.assertEqual(frames, 10, "half a second")
                continue
            for a, b in zip(served["final_backbone"], direct["final_backbone"]):
                for x, y in zip(a, b):
                    self.assertAlmostEqual(x, y, places=5, msg=kind)

    def test_an_obstacle_appears_for_limber_alone(self):
        self.run_limber("plan", "--no-load", "--max-queries", 20000, "--environment", "01_pillar",
                        "--out", "long.json")
        command = ("--plan", "long.json", "--environment", "01_pillar",
                   "--disturbance", "obstacle", "--seed", "4")
        direct = self.run_execution(*command)
        served = self.run_execution(*command, "--driver", self.served(), "--simulated", "--out", "o.h5")
        self.assertIsNotNone(direct["obstacle_appeared"])
        for key, value in direct["obstacle_appeared"].items():
            self.assertAlmostEqual(served["obstacle_appeared"][key], value, places=5, msg=key)

    def test_what_a_served_arm_cannot_have_is_refused(self):
        for flags, said in ((("--disturbance", "obstacle"), "does not know obstacles"),
                            (("--disturbance", "lost_tracking"), "in which plan's motion?"),
                            (("--disturbance", "picked_up"), "in which plan's motion?"),
                            (("--disturbance", "leak"), "in which plan's motion?"),
                            (("--plan", "p.json"), "goes with --disturbance lost_tracking"),
                            (("--disturbance", "wind"), "no such kind")):
            error = self.run_limber("virtual-arm", "--serve", *ARM, *flags, code=2).stderr
            self.assertIn(said, error)

    def test_what_there_is_not_is_refused(self):
        self.plan()
        command = ("execute", *ARM, "--plan", "p.json", "--environment", "e.yaml")
        error = self.run_limber(*command, "--disturbance", "wind", code=2).stderr
        self.assertIn("disturbance 'wind': no such kind; expected tip_load", error)
        error = self.run_limber(*command, "--disturbance", "noise", "--driver", "exec:true",
                                code=2).stderr
        self.assertIn("only the virtual arm can be disturbed", error)

    def test_an_experiment_has_a_row_for_each_and_can_be_resumed_with_more(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 20, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 3, "--out", "m.safetensors")
        (self.folder / "environments").mkdir()
        self.write("environments/a.yaml", json.dumps(PILLAR))
        command = ("experiment", *ARM, "--model", "m.safetensors", "--environments",
                   "environments", "--max-iterations", 150, "--trials", 2)
        more = ("--controller", "open", "--controller", "replan", "--disturbance", "none",
                "--disturbance", "friction", "--motion-queries", 500)
        self.run_json(*command, "--out", "one", "--disturbance", "friction")
        one = json.loads((self.folder / "one/runs.json").read_text(encoding="utf-8"))
        self.assertEqual([(row["model"], row["disturbance"]) for row in one],
                         [("no_load", "friction"), ("network", "friction")])
        self.run_json(*command, "--out", "one", *more, "--resume", "--jobs", 2)
        self.run_json(*command, "--out", "two", *more, "--jobs", 1)
        runs = [(self.folder / out / "runs.json").read_text(encoding="utf-8")
                for out in ("one", "two")]
        self.assertEqual(*runs)
        rows = json.loads(runs[0])
        self.assertEqual(
            [(row["model"], row["controller"], row["disturbance"]) for row in rows],
            [(model, controller, disturbance) for disturbance in ("", "friction")
             for controller, model in (("open", "no_load"), ("open", "network"),
                                       ("replan", "network"))])
        error = self.run_limber(*command, "--out", "one", *more[:-1], 600, "--resume", code=2).stderr
        self.assertIn("motion_queries = 500; this run has 600", error)
        self.assertTrue(all(row["replans"]["mean"] in (0, None) for row in rows
                            if row["controller"] == "open"))
        error = self.run_limber(*command, "--out", "x", "--controller", "magic", code=2).stderr
        self.assertIn("controller 'magic': no such one; expected open, replan", error)

    def test_the_long_table_is_written_by_its_script(self):
        """Two trials of it, and two random environments; the second time nothing is run again."""
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 20, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 3, "--out", "m.safetensors")
        (self.folder / "environments").mkdir()
        self.write("environments/a.yaml", json.dumps(PILLAR))
        command = [sys.executable, str(ROOT / "tools" / "closed_loop_table.py"), "--limber", PROGRAM,
                   "--model", "m.safetensors", "--out", "table",
                   "--trials", "2", "--max-queries", "5000", "--controller", "replan", "jacobian",
                   "--disturbance", "none", "noise", *ARM, "--environments", "environments",
                   "--random", "2"]
        first, second = (subprocess.run([*command, *commit], cwd=self.folder, check=True,
                                        stdout=subprocess.PIPE, encoding="utf-8").stdout
                         for commit in (("--commit", "0000fe" + 34 * "0"), ()))
        self.assertEqual(first, second, "the folder knows its seed")
        self.assertIn("seed 254,", first)
        rows = [line.split(" | ") for line in first.splitlines()[4:]]
        self.assertEqual([" ".join(row[:3]).strip("| ") for row in rows],
                         [f"{kind} {run}" for kind in ("own", "random") for run in (
                             "replan none", "replan noise", "jacobian none", "jacobian noise")])
        self.assertTrue(all(row[3].endswith(" of 2") for row in rows))
        rows = subprocess.run(
            [sys.executable, str(ROOT / "tools" / "real_time_rows.py"), "--limber", PROGRAM, *ARM,
             "--model", "m.safetensors", "--table", "table", "--out", "real", "--runs", "1",
             "--environments", "environments", "--disturbance", "noise", "--max-replans", "1"],
            cwd=self.folder, check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        self.assertRegex(rows.splitlines()[-1], r"^\| noise \| [01] of 1 \([01]\) \|")


if __name__ == "__main__":
    unittest.main()
