"""`limber improve`: rounds on the virtual arm and on a driver, killed and resumed, and what is refused."""

import json
import os
import signal
import subprocess
import time
import unittest

from program import PROGRAM, InFolder

ARM = ("--arm", "two_segment")
TINY = {"--rounds": 2, "--round-min": 0.6, "--selection": 3, "--reported": 3, "--epochs": 2,
        "--max-queries": 3000, "--margin-m": 0.001, "--goal-margin-m": 0.001, "--chain": 2}


class Improve(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 10, "--episodes", 6, "--out", "t.h5")
        self.run_limber("train", *ARM, "--data", "t.h5", "--epochs", 20, "--out", "m.safetensors")

    def command(self, out, *arguments):
        tiny = [word for flag, value in TINY.items() if flag not in arguments for word in (flag, value)]
        return ["improve", *ARM, "--model", "m.safetensors", "--data", "t.h5", *tiny, "--out", out, *arguments]

    def files(self, out):
        """Every file with its bytes; the arm's recordings among them."""
        folder = self.folder / out
        return {str(path.relative_to(folder)): path.read_bytes()
                for path in sorted(folder.rglob("*")) if path.is_file()}

    def kill_when(self, out, is_there, *arguments):
        """Kills the program with SIGKILL as soon as `is_there(folder)`. @return whether it still ran."""
        with subprocess.Popen([PROGRAM, *map(str, self.command(out, *arguments))], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while process.poll() is None and not is_there(self.folder / out):
                time.sleep(0.002)
            running = process.poll() is None
            if running:
                os.kill(process.pid, signal.SIGKILL)
            process.wait()
        return running

    def test_killed_runs_end_with_the_bytes_of_an_unbroken_one_whatever_the_jobs(self):
        summary = self.run_json(*self.command("whole", "--jobs", 2))
        whole = self.files("whole")
        self.assertEqual(len(summary["rounds"]), 3)
        for round_ in summary["rounds"]:
            self.assertEqual(round_["reported"]["environments"], 3)
            self.assertEqual(round_["selection"]["environments"], 3)
        half_a_motion_min = 1.5 / 60  # what a round may fall short by
        self.assertGreaterEqual(summary["rounds"][2]["learning_arm_time_min"],
                                1.2 - 2 * half_a_motion_min)
        for name in ("model.safetensors", "summary.json", "report.html", "distance.svg", "round_1/plans.h5",
                     "round_1/exploration.h5", "round_2/model.safetensors", "round_2/random.h5"):
            self.assertIn(name, whole)
        self.assertFalse([name for name in whole if ".parts" in name or ".tmp" in name])
        kills = 0
        for is_there in (
            lambda folder: list(folder.glob("round_0/selection.parts/*.json")),
            lambda folder: list(folder.glob("round_1/plans.parts/*.h5")),
            lambda folder: (folder / "round_1/exploration.h5").exists(),
            lambda folder: (folder / "round_1/model.safetensors").exists(),
            lambda folder: list(folder.glob("round_2/plans.parts/*.json")),
        ):
            kills += self.kill_when("killed", is_there, "--resume", "--jobs", 1)
        self.assertGreater(kills, 2)
        again = self.run_json(*self.command("killed", "--resume", "--jobs", 1))
        self.assertEqual(again, summary)
        found = self.files("killed")
        self.assertEqual(sorted(found), sorted(whole))
        self.assertEqual([name for name in whole if found[name] != whole[name]], [])

    def test_the_model_works_with_plan_as_it_is(self):
        self.run_limber(*self.command("out"))
        found = self.run_json("inspect", "out/round_1/model.safetensors")
        self.assertIsNotNone(found["prediction_error"])
        self.assertIn("learnt", found)
        self.assertIn("round_1/plans.h5", found["training"]["data"])
        self.assertIn("t.h5", found["training"]["data"])
        self.run_limber("environment", *ARM, "--random", "--out", "envs", "--seed", 4)
        environment = next((self.folder / "envs").glob("*.yaml"))
        result = self.run_limber("plan", *ARM, "--model", "out/model.safetensors", "--environment", environment,
                                 "--max-queries", 5000, code=None)
        self.assertIn(result.returncode, (0, 1), result.stderr)

    def test_without_plans_it_learns_from_random_motions_alone(self):
        self.run_limber(*self.command("out", "--plan-share", 0))
        self.assertFalse((self.folder / "out" / "round_1" / "plans.h5").exists())
        self.assertTrue((self.folder / "out" / "round_2" / "model.safetensors").exists())

    def test_training_from_the_start_learns_from_everything(self):
        self.run_limber(*self.command("out", "--from-start", "--rounds", 1))
        found = self.run_json("inspect", "out/round_1/model.safetensors")
        self.assertIn("round_1/plans.h5", found["training"]["data"])
        self.assertIn("t.h5", found["training"]["data"])
        self.run_limber(*self.command("out", "--from-start", "--rounds", 2, "--resume"))
        refused = self.run_limber(*self.command("out", "--rounds", 2, "--resume"), code=2)
        self.assertIn("training", refused.stderr)
        self.run_limber(*self.command("new", "--from-start", "--replay", 0.5), code=2)

    def test_rounds_go_on_from_a_network_that_learnt_from_related_arms(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 10, "--episodes", 6,
                        "--vary-physics", 2, "--out", "related.h5")
        self.assertIn("varied by up to 2", self.run_json("inspect", "related.h5")["settings"])
        self.run_limber("train", *ARM, "--data", "related.h5", "--epochs", 20, "--out", "prior.safetensors")
        self.run_limber(*self.command("out", "--prior", "prior.safetensors", "--rounds", 1))
        found = self.run_json("inspect", "out/round_1/model.safetensors")
        self.assertIn("round_1/plans.h5", found["training"]["data"])
        settings = json.loads((self.folder / "out/improve.json").read_text())
        self.assertEqual(found["training"]["from"], settings["prior"])
        self.run_limber(*self.command("without", "--rounds", 1))
        self.assertNotEqual((self.folder / "out/round_1/model.safetensors").read_bytes(),
                            (self.folder / "without/round_1/model.safetensors").read_bytes())
        other = self.run_limber(*self.command("out", "--prior", "m.safetensors", "--rounds", 2, "--resume"), code=2)
        self.assertIn("prior", other.stderr)
        self.run_limber(*self.command("bad", "--prior", "prior.safetensors", "--from-start"), code=2)
        self.run_limber(*self.command("bad", "--prior", "none.safetensors"), code=2)
        driver = f"exec:{PROGRAM} virtual-arm --serve --fast --arm two_segment"
        refused = self.run_limber("collect", *ARM, "--vary-physics", 2, "--driver", driver, "--out", "no.h5", code=2)
        self.assertIn("--vary-physics", refused.stderr)

    def test_learns_on_a_driver(self):
        driver = f"exec:{PROGRAM} virtual-arm --serve --arm two_segment"
        summary = self.run_json("improve", *ARM, "--model", "m.safetensors", "--data", "t.h5", "--rounds", 1,
                                "--round-min", 0.2, "--selection", 2, "--reported", 2, "--epochs", 1,
                                "--max-queries", 3000, "--margin-m", 0.001, "--goal-margin-m", 0.001,
                                "--driver", driver, "--out", "out")
        self.assertEqual(len(summary["rounds"]), 2)
        self.assertTrue(summary["driver"]["vent"]["confirmed"])

    def test_plans_follow_one_another_between_ventings(self):
        self.run_limber(*self.command("out", "--rounds", 1, "--chain", 3))
        runs = json.loads((self.folder / "out/round_1/plans.json").read_text())["runs"]
        self.assertEqual([run["environment"] for run in runs], list(range(len(runs))))
        for first in range(0, len(runs), 3):
            executed = [run["was_vented"] for run in runs[first:first + 3] if run["executed"]]
            self.assertEqual(executed, ([True] + 2 * [False])[:len(executed)])
        recorded = self.run_json("inspect", "out/round_1/plans.h5")
        ventings = sum(run["was_vented"] for run in runs)
        self.assertEqual(recorded["episodes"], ventings)
        moves = sum(run["duration_s"] for run in runs) * recorded["rate_hz"]  # a frame more in each episode
        self.assertEqual(recorded["frames"], round(moves) + ventings)
        figures = json.loads((self.folder / "out/round_1/round.json").read_text())
        self.assertGreaterEqual(figures["learning_ventings"], ventings)
        self.assertIn("--chain 0", self.run_limber(*self.command("bad", "--chain", 0), code=2).stderr)

    def test_ctrl_c_says_how_to_go_on(self):
        with subprocess.Popen([PROGRAM, *map(str, self.command("out", "--round-min", 60))], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8") as process:
            while process.poll() is None and not list(self.folder.glob("out/round_1/plans.parts/*.json")):
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            error = process.communicate()[1]
        self.assertEqual(process.returncode, 1, error)
        self.assertIn("what was finished is in out: the same command with --resume goes on", error)

    def test_what_does_not_fit_is_refused_before_any_work(self):
        for arguments, message in (
            (("--rounds", 0), "--rounds 0"),
            (("--plan-share", 1.5), "--plan-share 1.5"),
            (("--round-min", 0), "--round-min 0"),
            (("--selection", 1), "--selection 1"),
            (("--dry-run",), "--dry-run"),
            (("--driver", "fast"), "--driver fast"),
            (("--data", "none.h5"), "none.h5"),
        ):
            with self.subTest(message=message):
                error = self.run_limber(*self.command("bad", *arguments), code=2).stderr
                self.assertIn(message, error)
                self.assertFalse((self.folder / "bad").exists())

    def test_another_run_is_not_continued_and_none_is_replaced(self):
        self.run_limber(*self.command("out", "--rounds", 1))
        self.assertIn("--resume goes on with it", self.run_limber(*self.command("out"), code=2).stderr)
        error = self.run_limber(*self.command("out", "--resume", "--seed", 2), code=2).stderr
        self.assertIn("seed = 1; this run has 2", error)
        before = self.files("out")
        more = self.run_json(*self.command("out", "--resume", "--rounds", 2))
        self.assertEqual(len(more["rounds"]), 3)
        for name, content in before.items():
            if name.startswith("round_"):
                self.assertEqual((self.folder / "out" / name).read_bytes(), content, name)


if __name__ == "__main__":
    unittest.main()
