"""The simple model in `import`, `inspect`, `train`, `characterize --recording` and `evaluate`: broken logs
are named, arms are fitted to recordings, and networks are set beside yardsticks."""

import csv
import json
import re
import unittest

import h5py
from program import InFolder

ARM = ("--arm", "two_segment")
EPISODES = 8
BROKEN = 5
YARDSTICKS = ("hold", "constant_velocity", "linear_one_step", "simple_model")
HORIZONS = ("one_step", "one_step_moving", "window_32", "per_motion", "open_loop")


class SimpleModel(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 2,
                        "--episodes", EPISODES, "--seed", 4, "--out", "good.h5")
        self.run_limber("export", "good.h5", "--csv", "logs")

    def break_a_log(self):
        """Commands of another trial beside the motion of this one."""
        def table(number):
            with open(self.folder / "logs" / f"episode_{number:03}.csv", encoding="utf-8") as file:
                return [line for line in csv.reader(file) if line and not line[0].startswith("#")]

        own, other = table(BROKEN), table(BROKEN + 1)
        columns = [i for i, name in enumerate(own[0]) if name.startswith(("pressure", "setpoint"))]
        for row, wrong in zip(own[1:], other[1:]):
            for column in columns:
                row[column] = wrong[column]
        text = "\n".join(",".join(row) for row in own[: len(other)]) + "\n"
        self.write(f"logs/episode_{BROKEN:03}.csv", text)

    def import_all(self, out):
        logs = [f"logs/episode_{i:03}.csv" for i in range(EPISODES)]
        return self.run_json("import", "csv", *logs, *ARM, "--mapping", "logs/mapping.yaml",
                             "--out", out)

    def import_good(self):
        good = [f"logs/episode_{i:03}.csv" for i in range(EPISODES) if i != BROKEN]
        self.run_limber("import", "csv", *good, *ARM, "--mapping", "logs/mapping.yaml", "--out", "good.h5",
                        "--force")

    def test_broken_logs_are_named_everywhere(self):
        self.assertEqual(self.import_all("back.h5")["episode_errors"]["outliers"], [])
        self.break_a_log()
        report = self.import_all("broken.h5")
        self.assertEqual(report["episode_errors"]["outliers"], [BROKEN])
        self.assertLess(report["episode_errors"]["episodes"][BROKEN]["correlation"], 0.7)
        text = self.run_limber("inspect", "broken.h5").stdout
        self.assertIn(f"broken: episode {BROKEN}", text)
        self.assertNotIn("broken:", self.run_limber("inspect", "back.h5").stdout)

    def test_nothing_is_learnt_from_a_broken_log(self):
        self.break_a_log()
        self.import_all("broken.h5")
        self.import_good()
        models = {}
        for name, data, more in (("left_out", "broken.h5", ()), ("without", "good.h5", ()),
                                 ("kept", "broken.h5", ("--keep-broken",))):
            trained = self.run_json("train", *ARM, "--data", data, "--hidden", 8, "--epochs", 3, *more,
                                    "--out", f"{name}.safetensors")
            self.assertEqual(len(trained["broken_episodes"]), name == "left_out")
            models[name] = trained["loss"], trained["learnt"], trained["prediction_error"]
        self.assertEqual(models["left_out"], models["without"])
        self.assertNotEqual(models["left_out"], models["kept"])
        said = self.run_limber("train", *ARM, "--data", "broken.h5", "--hidden", 8, "--epochs", 3, "--force")
        self.assertIn(f"left out as broken: broken.h5, episode {BROKEN}", said.stderr)
        text = [self.run_limber("characterize", *ARM, "--recording", data).stdout.splitlines()[0]
                for data in ("broken.h5", "good.h5")]
        self.assertEqual(*text)

    def test_neither_old_data_nor_a_familys_arm_has_broken_logs_or_twins(self):
        self.break_a_log()
        self.import_all("broken.h5")
        self.import_good()
        with h5py.File(self.folder / "broken.h5", "r+") as file:
            file.copy("episodes/000001", file["episodes"], f"{EPISODES:06}")
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 2, "--episodes", 3,
                        "--seed", 6, "--out", "new.h5")
        self.run_limber("train", *ARM, "--data", "good.h5", "--hidden", 8, "--epochs", 3, "--out", "old.safetensors")
        train = ("train", *ARM, "--data", "new.h5", "--epochs", 3, "--out", "m.safetensors", "--force")
        family = ("--family", "--family-size", 2, "--hidden", 8, "--data")
        for more in (("--from", "old.safetensors", "--old-data"), family, ("--slice-frames", 300, *family)):
            found = {data: self.run_json(*train, *more, data) for data in ("broken.h5", "good.h5")}
            self.assertEqual(found["broken.h5"]["loss"], found["good.h5"]["loss"], more)
            broken, = found["broken.h5"]["broken_episodes"]
            self.assertIn(f"broken.h5, episode {BROKEN}", broken)
            self.assertTrue(any(said.startswith(f"left out: broken.h5, episode {EPISODES}")
                                for said in found["broken.h5"]["warnings"]))
            kept = self.run_json(*train, "--keep-broken", *more, "broken.h5")
            self.assertEqual(kept["broken_episodes"], [])
            self.assertNotEqual(kept["loss"], found["good.h5"]["loss"], more)

    def test_neither_broken_logs_nor_twins_count_in_the_errors(self):
        self.break_a_log()
        self.import_all("broken.h5")
        self.import_good()
        without = self.run_json("evaluate", *ARM, "--data", "good.h5")
        self.assertEqual((without["broken_episodes"], without["warnings"]), ([], []))
        with h5py.File(self.folder / "broken.h5", "r+") as file:
            file.copy("episodes/000001", file["episodes"], f"{EPISODES:06}")
        result = self.run_limber("evaluate", *ARM, "--data", "broken.h5", "--predictions", "tables", "--json")
        found = json.loads(result.stdout)
        for key in ("frames", "no_load", "baselines", "horizons"):
            self.assertEqual(found[key], without[key], key)
        self.assertEqual(len(found["broken_episodes"]), 1)
        twin, broken = found["warnings"]
        self.assertIn(f"left out: broken.h5, episode {EPISODES}", twin)
        self.assertIn(f"left out as broken: broken.h5, episode {BROKEN}", broken)
        self.assertEqual(found["warnings"], re.findall(r"^warning: (.*)$", result.stderr, flags=re.M))
        self.assertEqual([re.search(r"episode (\d+)", episode["name"])[1] for episode in found["episodes"]],
                         [str(i) for i in range(EPISODES) if i != BROKEN])
        kept = self.run_json("evaluate", *ARM, "--data", "broken.h5", "--keep-broken")
        self.assertEqual((kept["broken_episodes"], len(kept["warnings"])), ([], 1))
        self.assertGreater(kept["no_load"]["open_loop"]["position_error_cm"]["mean"],
                           found["no_load"]["open_loop"]["position_error_cm"]["mean"])
        with open(self.folder / "tables" / "open_loop.csv", encoding="utf-8") as file:
            self.assertEqual({row["episode"] for row in csv.DictReader(file)},
                             {str(i) for i in range(EPISODES + 1)})

    def test_an_arm_is_fitted_to_recordings(self):
        found = self.run_json("characterize", *ARM, "--recording", "good.h5", "--out", "fitted.yaml")
        self.assertEqual(len(found["segments"]), 2)
        for segment in found["segments"]:
            low, high = segment["gain_interval"]
            self.assertLess(low, segment["gain"])
            self.assertLess(segment["gain"], high)
            self.assertGreater(segment["correlation"], 0.8)
        error = {}
        for arm in ("two_segment", "fitted.yaml"):
            evaluated = self.run_json("evaluate", "--arm", arm, "--data", "good.h5")
            error[arm] = evaluated["no_load"]["open_loop"]["position_error_cm"]["mean"]
        self.assertLess(error["fitted.yaml"], error["two_segment"])
        self.run_limber("characterize", *ARM, "--recording", "good.h5", "--out", "fitted.yaml", code=2)
        error = self.run_limber("characterize", *ARM, "--recording", "good.h5", "--recording", "good.h5", code=2).stderr
        self.assertIn("good.h5: the same recording as good.h5; give it once", error)
        self.assertIn("95 % intervals",
                      self.run_limber("characterize", *ARM, "--recording", "good.h5").stdout)

    def test_yardsticks_stand_beside_a_network(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 2,
                        "--episodes", 2, "--seed", 5, "--out", "test.h5")
        self.run_limber("train", *ARM, "--data", "good.h5", "--hidden", 8, "--epochs", 3,
                        "--out", "m.safetensors")
        evaluated = self.run_json("evaluate", *ARM, "--model", "m.safetensors", "--data", "test.h5",
                                  "--fit", "good.h5", "--predictions", "tables", "--plots", "plots")
        for name in YARDSTICKS:
            for horizon in HORIZONS:
                errors = evaluated["baselines"][name][horizon]
                self.assertGreater(errors["position_error_cm"]["mean"], 0.0, f"{name} {horizon}")
                self.assertGreater(errors["plates_error_cm"]["mean"], 0.0, f"{name} {horizon}")
        self.assertEqual(evaluated["yardsticks_fitted_to"], f"{EPISODES} other episodes")
        self.assertIn("every frame after the first", evaluated["frames_counted"])
        curves = evaluated["horizons"]
        self.assertEqual(len(curves["tip_error_cm"]["network"]), len(curves["frames"]))
        self.assertEqual(len(evaluated["episodes"]), 2)
        self.assertIn("simple_model", evaluated["episodes"][1]["tip_error_cm"])
        simple = evaluated["baselines"]["simple_model"]["open_loop"]["position_error_cm"]["mean"]
        no_load = evaluated["no_load"]["open_loop"]["position_error_cm"]["mean"]
        self.assertLess(simple, no_load)
        self.assertIn("</svg>", (self.folder / "plots" / "error_over_horizon.svg").read_text("utf-8"))
        for name in ("one_step", "window_32", "per_motion", "open_loop"):
            with open(self.folder / "tables" / f"{name}.csv", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), sum(e["frames"] for e in evaluated["episodes"]))
            self.assertEqual(rows[0]["network_x3_m"], "", "the first frame is given")
            self.assertNotEqual(rows[1]["network_x3_m"], "")
        self.run_limber("evaluate", *ARM, "--data", "test.h5", "--predictions", "tables", code=2)
        said = self.run_limber("evaluate", *ARM, "--data", "test.h5")
        self.assertRegex(said.stderr, r"evaluating 100/100 %, .*/s, took ")
        self.assertEqual(self.run_limber("evaluate", *ARM, "--data", "test.h5", "--quiet").stderr, "")
        text = said.stdout
        self.assertIn("fitted simple model", text)
        self.assertIn("its episodes in 2 parts", text)


if __name__ == "__main__":
    unittest.main()
