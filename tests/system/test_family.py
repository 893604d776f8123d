"""`limber family`, `train --family` and `limber adapt`: one network for many arms becomes one arm's."""

import json
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ROOT, WithFiles
from test_plan import PILLAR

ARM = ("--arm", "two_segment")
SMALL = ("--hours", 0.25, "--epochs", 60, "--family-size", 3, "--vary-physics", 1.5, "--tube-runs", 0)


class Family(WithFiles):
    FILES = (
        ("family.safetensors", ("family", *ARM, *SMALL)),
        ("minute.h5", ("collect", *ARM, "--schedule", "identify", "--seed", 5)),
    )

    def adapt(self, *arguments, code=0):
        return self.run_json("adapt", *ARM, "--model", "family.safetensors", "--recording", "minute.h5",
                             "--out", "mine.safetensors", *arguments, code=code)

    def test_a_minute_makes_it_one_arms(self):
        found = self.adapt()
        self.assertEqual(len(found["e"]), 3)
        self.assertGreater(found["seconds"], 45)
        self.assertAlmostEqual(found["held_back_s"], found["seconds"] / 5, delta=0.1)
        errors = found["error_cm"]
        self.assertLess(errors["e_alone"], errors["family_middle"])
        self.assertLess(found["uncertainty"]["mean"], 0.7)
        model = self.run_json("inspect", "mine.safetensors")
        self.assertEqual(model["family"]["e"], found["e"])
        environment = self.write("e.yaml", json.dumps({**PILLAR, "obstacles": []}))
        self.run_json("plan", *ARM, "--model", "mine.safetensors", "--environment", environment,
                      "--max-queries", 20000, "--goal-margin-m", 0, "--margin-m", 0, "--out", "p.json")
        self.run_json("verify", *ARM, "--model", "mine.safetensors", "--environment", environment,
                      "--plan", "p.json")

    def test_its_vector_is_fitted_again_from_its_own_file(self):
        first = self.adapt("--weights", "never")
        again = self.run_json("adapt", *ARM, "--model", "mine.safetensors", "--recording", "minute.h5",
                              "--weights", "never", "--out", "again.safetensors")
        for one, other in zip(first["e"], again["e"]):
            self.assertAlmostEqual(one, other, places=2)
        self.assertEqual(self.run_json("inspect", "again.safetensors")["family"]["hash"],
                         self.run_json("inspect", "mine.safetensors")["family"]["hash"])

    def test_a_family_is_refused_where_one_arm_is_asked_for(self):
        environment = self.write("e.yaml", json.dumps(PILLAR))
        for command in (("plan", "--environment", environment), ("evaluate", "--data", "minute.h5"),
                        ("export", "family.safetensors", "--onnx", "x.onnx")):
            arguments = command if command[0] == "export" else (*command, "--model", "family.safetensors")
            error = self.run_limber(*arguments, *(ARM if command[0] != "export" else ()), code=2).stderr
            self.assertIn("family.safetensors: a family of", error)
            self.assertIn("limber adapt --model family.safetensors", error)
        self.run_limber("train", *ARM, "--data", "minute.h5", "--epochs", 3, "--out", "one.safetensors")
        error = self.run_limber("adapt", *ARM, "--model", "one.safetensors", "--recording", "minute.h5",
                                "--out", "x.safetensors", code=2).stderr
        self.assertIn("one.safetensors: a network of one arm", error)

    def test_limbers_own_is_found_by_its_name(self):
        found = self.run_json("adapt", *ARM, "--model", "two_segment", "--recording", "minute.h5",
                              "--out", "mine.safetensors")
        self.assertLess(found["error_cm"]["e_alone"], 1.0)
        self.assertTrue(found["of_family"])
        error = self.run_limber("adapt", *ARM, "--model", "six_segment", "--recording", "minute.h5",
                                "--out", "x.safetensors", code=2).stderr
        self.assertIn("--model six_segment: no such file, and none of limber's own families", error)
        error = self.run_limber("adapt", *ARM, "--model", "two_segment", "--recording", "minute.h5", "--recording",
                                "minute.h5", "--out", "x.safetensors", code=2).stderr
        self.assertIn("minute.h5: the same recording as minute.h5; give it once", error)

    def test_a_minute_tells_what_the_arm_bears(self):
        text = (ROOT / "arms/two_segment.yaml").read_text(encoding="utf-8")
        self.write("loaded.yaml", text + "\n  tip_load_kg: 0.06\n")  # its last section is the virtual arm
        self.run_limber("collect", "--arm", "loaded.yaml", "--schedule", "identify", "--seed", 6, "--out", "loaded.h5")
        adapt = ("adapt", *ARM, "--model", "two_segment", "--out", "mine.safetensors", "--force", "--recording")
        load = next(trait for trait in self.run_json(*adapt, "loaded.h5")["traits"] if trait["name"] == "tip_load_kg")
        self.assertEqual(load["reference"], 0.0)
        self.assertAlmostEqual(load["value"], 0.06, delta=3 * load["sd"])
        self.assertGreater(load["value"], 3 * load["sd"])
        self.assertRegex(self.run_limber(*adapt, "loaded.h5").stdout, r"moves like arms with: .*load at the tip \d+\.?\d* ± ")
        for trait in self.run_json(*adapt, "minute.h5")["traits"]:
            self.assertLess(abs(trait["value"] - trait["reference"]), 3 * trait["sd"], trait)

    def test_in_closed_loop_which_arm_it_is_is_fitted_again_while_it_moves(self):
        self.run_json("adapt", *ARM, "--model", "two_segment", "--recording", "minute.h5", "--out", "mine.safetensors")
        environment = self.write("e.yaml", json.dumps({**PILLAR, "obstacles": []}))
        self.run_json("plan", *ARM, "--model", "mine.safetensors", "--environment", environment,
                      "--max-queries", 20000, "--margin-m", 0, "--out", "p.json")
        run = ("execute", *ARM, "--plan", "p.json", "--environment", environment, "--model", "mine.safetensors",
               "--disturbance", "friction=1")
        closed = ("--replan", "--margin-m", 0, "--motion-queries", 500)
        found = self.run_json(*run, *closed, "--adapted-out", "now.safetensors", "--plans-out", "plans")
        self.assertLess(found["arm"]["last_window_error_cm"], 0.5 * found["arm"]["largest_window_error_cm"])
        self.assertLess(found["arm"]["changed_s"], found["frames"] / 20)
        friction = [trait for change in found["arm"]["changes"] for trait in change
                    if trait["name"] == "friction_coefficient"]
        self.assertAlmostEqual(friction[0]["value"] - friction[0]["reference"], 0.25, delta=0.1)
        before = self.run_json("inspect", "mine.safetensors")["family"]
        now = self.run_json("inspect", "now.safetensors")["family"]
        self.assertEqual(now["e"], found["arm"]["e"])
        self.assertNotEqual(now["e"], before["e"])
        self.assertEqual(now["hash"], before["hash"])
        self.verify_further_plans(found["replans"] + found["switches"], before["e"])
        self.assertNotIn("arm", self.run_json(*run, *closed, "--no-adapt"))
        error = self.run_limber(*run, "--adapted-out", "x.safetensors", code=2).stderr
        self.assertIn("--adapted-out: nothing would be adapted", error)

    def verify_further_plans(self, count, e_before):
        """What was certified in the run, of the arm as it was known then, is certified again from the files."""
        plans = sorted((self.folder / "plans").glob("*.json"))
        self.assertEqual(len(plans), count)
        self.assertGreater(count, 0)
        verify = ("verify", *ARM, "--model", "mine.safetensors")
        for path in plans:
            self.assertNotEqual(json.loads(path.read_text())["model"]["e"], e_before)
            self.run_json(*verify, "--plan", path, "--environment", path.with_suffix(".yaml"))
        plan = json.loads(plans[0].read_text())
        plan["model"]["e"] = e_before[:2]
        self.write("cut.json", json.dumps(plan))
        error = self.run_limber(*verify, "--plan", "cut.json", "--environment", plans[0].with_suffix(".yaml"),
                                code=2).stderr
        self.assertIn("model.e: 2 numbers", error)

    def test_a_trackers_noise_hides_little_of_the_arm(self):
        self.run_limber("collect", "--schedule", "random", "--count", 20, "--seed", 8, "--out", "other.h5")
        errors = []
        for noise in ((), ("--noise-m", 0.0005, "--noise-rad", 0.005)):
            self.run_limber("collect", "--schedule", "identify", "--seed", 7, *noise, "--out", "seen.h5", "--force")
            self.run_limber("adapt", "--model", "three_segment", "--recording", "seen.h5", "--weights", "never",
                            "--out", "mine.safetensors", "--force")
            found = self.run_json("evaluate", "--model", "mine.safetensors", "--data", "other.h5")
            errors.append(found["network"]["open_loop"]["position_error_cm"]["mean"])
            self.assertLess(found["noise_multiplied"], 10.0)
        self.assertLess(errors[1], 1.4 * errors[0])

    def test_the_small_one_is_found_by_its_name_too(self):
        self.run_limber("collect", "--vary-physics", 1.5, "--schedule", "identify", "--seed", 6, "--out", "like.h5")
        found = self.run_json("adapt", "--model", "three_segment_small", "--recording", "like.h5",
                              "--weights", "never", "--out", "like.safetensors")
        self.assertEqual(len(found["e"]), 12)
        self.assertLess(found["error_cm"]["e_alone"], 0.5 * found["error_cm"]["family_middle"])

    def test_recordings_of_five_builds_make_one_too(self):
        for build in range(5):
            self.run_limber("collect", *ARM, "--vary-physics", 1.5, "--schedule", "identify", "--seed",
                            90 + build, "--out", f"build_{build}.h5")
        data = [part for build in range(5) for part in ("--data", f"build_{build}.h5")]
        self.run_limber("train", *ARM, "--family", "--family-size", 2, *data, "--epochs", 30, "--out",
                        "five.safetensors")
        self.assertEqual(self.run_json("inspect", "five.safetensors")["family"]["arms"], 5)
        found = self.run_json("adapt", *ARM, "--model", "five.safetensors", "--recording", "minute.h5",
                              "--weights", "never", "--out", "x.safetensors")
        self.assertEqual(len(found["e"]), 2)
        refused = self.run_limber("train", *ARM, "--from", "five.safetensors", "--data", "minute.h5",
                                  "--out", "y.safetensors", code=2).stderr
        self.assertIn("limber adapt --model five.safetensors", refused)
        self.run_limber("train", *ARM, "--family", "--family-size", 0, *data, "--epochs", 3, "--out",
                        "alike.safetensors")
        self.assertIsNone(self.run_json("inspect", "alike.safetensors")["family"])

    def test_more_frames_than_fit_are_read_in_slices(self):
        for shard in (0, 1):
            self.run_limber("collect", *ARM, "--schedule", "random", "--count", 3, "--episodes", 12,
                            "--vary-physics", 1.5, "--seed", shard, "--out", f"shard_{shard}.h5")
        train = ("train", *ARM, "--family", "--data", "shard_0.h5", "--data", "shard_1.h5", "--epochs", 4,
                 "--family-size", 2)
        models = {}
        for name, flags in (("one_job", ("--slice-frames", 1000, "--jobs", 1)),
                            ("two_jobs", ("--slice-frames", 1000, "--jobs", 2)), ("memory", ())):
            said = self.run_limber(*train, *flags, "--out", f"{name}.safetensors").stderr
            self.assertEqual("slices of about 1000" in said, name != "memory")
            self.assertIn("on 22 episodes, validating on 2;", said)
            models[name] = (self.folder / f"{name}.safetensors").read_bytes()
            self.assertEqual(self.run_json("inspect", f"{name}.safetensors")["family"]["arms"], 22)
        self.assertEqual(models["one_job"], models["two_jobs"])
        self.assertNotEqual(models["one_job"], models["memory"])

    def test_a_stopped_run_goes_on_to_the_same_bytes(self):
        process = subprocess.Popen(
            [PROGRAM, "family", *map(str, (*ARM, *SMALL)), "--out", "stopped.safetensors"],
            cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(1.5)
        process.send_signal(signal.SIGINT)
        self.assertNotEqual(process.wait(timeout=60), 0)
        error = self.run_limber("family", *ARM, *SMALL, "--out", "stopped.safetensors", code=2).stderr
        self.assertIn("--resume goes on with it", error)
        self.run_limber("family", *ARM, *SMALL, "--out", "stopped.safetensors", "--resume")
        self.assertEqual((self.folder / "stopped.safetensors").read_bytes(),
                         self.made["family.safetensors"])
        self.assertFalse((self.folder / "stopped.safetensors.parts").exists())
        error = self.run_limber("family", *ARM, *SMALL, "--out", "stopped.safetensors", "--resume", code=2).stderr
        self.assertIn("stopped.safetensors: exists already", error)

    def test_runs_of_another_tube_are_refused_and_stay(self):
        tube = self.folder / "kept.safetensors.parts/tube/calibration.json"
        tube.parent.mkdir(parents=True)
        tube.write_text('{"schema": "limber/calibration/6", "test_runs": 400}', encoding="utf-8")
        error = self.run_limber("family", *ARM, "--hours", 0.05, "--epochs", 2, "--vary-physics", 1.5, "--tube-runs", 100,
                                "--resume", "--out", "kept.safetensors", code=2).stderr
        self.assertIn("calibration.json", error)
        self.assertTrue(tube.exists())
        self.assertFalse((self.folder / "kept.safetensors").exists())


if __name__ == "__main__":
    unittest.main()
