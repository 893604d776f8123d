"""`limber import`, `limber export` and what becomes of bad logs, run as users do: round trips through
Motive's CSV and plain CSV, an arm that is not driven by pressures from its logs to a plan, and one
plain message for each kind of bad input."""

import json
import math
import os
import re
import subprocess
import unittest

import h5py
import numpy as np

from program import PROGRAM, ROOT, InFolder

ARM = ("--arm", "two_segment")
RATE_HZ = 20.0


def episodes_of(path):
    """time_s, pressure_kpa (or command), backbone, tracked of each episode."""
    with h5py.File(path, "r") as file:
        return [
            {name: data[:] for name, data in file["episodes"][key].items()}
            for key in sorted(file["episodes"])
        ]


class RoundTrip(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber(
            "collect", *ARM, "--schedule", "random", "--count", 12, "--seed", 4, "--out", "truth.h5"
        )

    def import_motive(self, *arguments):
        return self.run_json(
            "import", "motive", "logs/episode_000_motive.csv", *ARM,
            "--pressures", "logs/episode_000_pressures.csv", "--mapping", "logs/mapping.yaml",
            *arguments,
        )

    def test_motive_logs_come_back_within_their_noise(self):
        noise_m = 0.0005
        self.run_limber(
            "export", "truth.h5", "--motive", "logs", "--rate-hz", 120, "--time-offset-s", -17.3,
            "--noise-m", noise_m, "--noise-rad", 0.004, "--occlusions", 25,
        )
        report = self.import_motive("--out", "back.h5")
        clock = report["logs"][0]["clock"]
        # The arm follows its pressures late, but that lag is not in the offset: less than a frame is left.
        self.assertAlmostEqual(clock["time_offset_s"], -17.3, delta=0.05)
        self.assertGreater(clock["lag_s"], 0.04)
        self.assertGreater(clock["correlation"], 0.5)
        truth = episodes_of(self.folder / "truth.h5")[0]
        squares = []
        for back in episodes_of(self.folder / "back.h5"):
            frames = np.rint(back["time_s"] * RATE_HZ).astype(int)
            seen = back["tracked"] == 1
            self.assertLess(np.sum(~seen), 0.4 * len(seen))
            difference = back["backbone"][seen] - truth["backbone"][frames[seen]]
            squares.append(np.sum(difference[:, 1:, :2] ** 2, axis=2).ravel())
        rms = math.sqrt(np.mean(np.concatenate(squares)))
        self.assertAlmostEqual(rms, math.sqrt(2) * noise_m, delta=0.1 * noise_m)
        self.run_limber("evaluate", *ARM, "--data", "back.h5")

    def test_a_dry_run_reports_and_writes_nothing(self):
        self.run_limber("export", "truth.h5", "--motive", "logs", "--occlusions", 3)
        before = sorted(self.folder.iterdir())
        report = self.import_motive("--dry-run", "--time-offset-s", 0)
        self.assertIsNone(report["file"])
        self.assertGreater(report["frames_not_tracked"], 0)
        self.assertTrue(report["logs"][0]["notes"])
        self.assertEqual(sorted(self.folder.iterdir()), before)
        text = self.run_limber(
            "import", "motive", "logs/episode_000_motive.csv", *ARM, "--time-offset-s", 0,
            "--pressures", "logs/episode_000_pressures.csv", "--mapping", "logs/mapping.yaml",
            "--dry-run",
        ).stdout
        self.assertIn("Nothing was written", text)

    def test_csv_comes_back_to_the_bit(self):
        self.run_limber("export", "truth.h5", "--csv", "tables")
        self.run_json(
            "import", "csv", "tables/episode_000.csv", *ARM, "--mapping", "tables/mapping.yaml",
            "--out", "back.h5",
        )
        truth = episodes_of(self.folder / "truth.h5")[0]
        back = episodes_of(self.folder / "back.h5")[0]
        for name in ("pressure_kpa", "setpoint_kpa", "backbone", "motion_index", "tracked"):
            np.testing.assert_array_equal(truth[name], back[name], name)

    def test_a_log_is_given_once(self):
        self.run_limber("export", "truth.h5", "--csv", "tables")
        (self.folder / "copy.csv").write_bytes((self.folder / "tables/episode_000.csv").read_bytes())
        for again in ("tables/episode_000.csv", "copy.csv"):
            message = self.run_limber("import", "csv", "tables/episode_000.csv", again, *ARM, "--mapping",
                                      "tables/mapping.yaml", "--out", "twice.h5", code=2).stderr
            self.assertIn(f"{again}: the same recording as tables/episode_000.csv; give it once", message)

    def test_an_arm_without_polynomials_is_imported_and_then_fitted(self):
        text = (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8")
        unfitted = re.sub(r"strain_polynomial: \[.*\]", "strain_polynomial: []", text)
        self.write("unfitted.yaml", unfitted)
        self.run_limber("export", "truth.h5", "--csv", "tables")
        message = self.run_limber(
            "import", "csv", "tables/episode_000.csv", "--arm", "unfitted.yaml", "--mapping",
            "tables/mapping.yaml", "--out", "back.h5",
        ).stderr
        self.assertIn("without a usable strain polynomial", message)
        self.run_limber("characterize", "--arm", "unfitted.yaml", "--recording", "back.h5",
                        "--out", "fitted.yaml")
        fitted = (self.folder / "fitted.yaml").read_text(encoding="utf-8")
        self.assertNotIn("strain_polynomial: []", fitted)

    def test_files_are_kept_without_force(self):
        self.run_limber("export", "truth.h5", "--csv", "tables")
        message = self.run_limber("export", "truth.h5", "--csv", "tables", code=2).stderr
        self.assertIn("--force", message)
        self.run_limber("export", "truth.h5", "--csv", "tables", "--force")
        self.run_limber(
            "import", "csv", "tables/episode_000.csv", *ARM, "--mapping", "tables/mapping.yaml",
            "--out", "truth.h5", code=2,
        )

    def test_export_says_what_fits_which_file(self):
        message = self.run_limber("export", "truth.h5", "--onnx", "x.onnx", code=2).stderr
        self.assertIn("a recording; expected --csv or --motive", message)
        message = self.run_limber("export", "truth.h5", code=2).stderr
        self.assertIn("at least one of --csv DIR", message)
        arm = ROOT / "arms" / "two_segment.yaml"
        self.run_limber("export", arm, "--mjcf", "arm.xml")
        self.assertIn("<mujoco", (self.folder / "arm.xml").read_text(encoding="utf-8"))

    def test_the_example_runs(self):
        result = subprocess.run(
            [str(ROOT / "examples" / "import_logs.sh"), str(self.folder / "example")],
            env={**os.environ, "LIMBER_PROGRAM": PROGRAM}, capture_output=True, encoding="utf-8",
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("found by correlation", result.stdout)


def chain(turns, lengths):
    """Poses of plates along arcs that turn by `turns` over `lengths`, the base first."""
    poses = [(0.0, 0.0, 0.0)]
    for turn, length in zip(turns, lengths):
        x, y, theta = poses[-1]
        half = 0.5 * turn
        reach = length * (np.sinc(half / np.pi))
        poses.append((x + reach * math.cos(theta + half), y + reach * math.sin(theta + half),
                      theta + turn))
    return poses


class ArmDrivenByMotors(InFolder):
    """An arm whose command is an angle: arm file, logs, training, evaluation, plan."""

    GAPS = 4
    FACTORS = (4.0, -5.0)  # 1/m for a radian, as in arms/motor_driven.yaml
    LENGTHS = (0.2, 0.2)

    def write_log(self, name, seconds, seed):
        """What the motors were at, and an arm that bends less than they say, with play."""
        random = np.random.default_rng(seed)
        rate = 50.0
        angle = np.zeros(2)
        target = np.zeros(2)
        played = np.zeros(2)
        header = ["t_ms", "motor_1", "motor_2"]
        header += [f"{axis}{p}" for p in range(2 * self.GAPS + 1) for axis in "xy"]
        lines = [",".join(header)]
        for k in range(int(seconds * rate)):
            if k % 75 == 0:
                target = random.uniform(-1, 1, 2) * (1.4, 1.1)
            angle += np.clip(target - angle, -2.5 / rate, 2.5 / rate)
            played = np.clip(played, angle - 0.1, angle + 0.1)
            turns = []
            for segment in range(2):
                curvature = 0.9 * self.FACTORS[segment] * played[segment]
                turns += [curvature * self.LENGTHS[segment] / self.GAPS] * self.GAPS
            poses = chain(turns, [0.2 / self.GAPS] * (2 * self.GAPS))
            cells = [f"{1000 * k / rate:.3f}", f"{math.degrees(angle[0]):.4f}",
                     f"{math.degrees(angle[1]):.4f}"]
            noise = random.normal(0, 3e-4, (len(poses), 2))  # m
            cells += [f"{100 * (value + error):.5f}" for pose, errors in zip(poses, noise)
                      for value, error in zip(pose[:2], errors)]
            lines.append(",".join(cells))
        self.write(name, "\n".join(lines) + "\n")

    def mapping(self):
        points = "".join(f"    - {{x: x{p}, y: y{p}}}\n" for p in range(2 * self.GAPS + 1))
        return self.write(
            "map.yaml",
            "schema: limber/import/1\ntime: {column: t_ms, unit: ms}\n"
            "commands:\n  unit: deg\n  columns: [motor_1, motor_2]\n"
            f"backbone:\n  unit: cm\n  points:\n{points}",
        )

    def test_from_its_logs_to_a_plan(self):
        self.mapping()
        self.write_log("train.csv", 120, 1)
        self.write_log("test.csv", 30, 2)
        text = (ROOT / "arms" / "motor_driven.yaml").read_text(encoding="utf-8")
        self.write("curvature.yaml", text)
        straight = text.replace("no_load: curvature", "no_load: straight")
        self.write("straight.yaml", straight.replace(", curvature_per_unit: 4.0", "")
                   .replace(", curvature_per_unit: -5.0", ""))
        for kind in ("curvature", "straight"):
            with self.subTest(no_load=kind):
                self.learn_and_plan(kind)

    def learn_and_plan(self, kind):
        arm = ("--arm", f"{kind}.yaml")
        for name in ("train", "test"):
            report = self.run_json("import", "csv", f"{name}.csv", *arm, "--mapping", "map.yaml",
                                   "--out", f"{kind}_{name}.h5")
            self.assertEqual(report["frames_not_tracked"], 0)
        inspected = self.run_json("inspect", f"{kind}_train.h5", *arm)
        self.assertEqual(inspected["command"], {"name": "motor angle", "unit": "rad"})
        self.assertEqual(inspected["suspicions"], [])
        self.assertIn("motor angle [rad]", self.run_limber("inspect", f"{kind}_train.h5").stdout)
        self.run_limber("train", *arm, "--data", f"{kind}_train.h5", "--hidden", 32, 32,
                        "--epochs", 200, "--out", f"{kind}.safetensors")
        errors = self.run_json("evaluate", *arm, "--model", f"{kind}.safetensors", "--data",
                               f"{kind}_test.h5")
        no_load = errors["no_load"]["open_loop"]["position_error_cm"]["mean"]
        kind_of_error = "open_loop" if kind == "curvature" else "window_32"
        network = errors["network"][kind_of_error]["position_error_cm"]["mean"]
        # Two minutes of data; where the unloaded arm says nothing, the network has all to learn.
        self.assertLess(network, 0.5 * no_load)
        self.write("goal.yaml", "schema: limber/environment/1\nname: a turn\nobstacles:\n"
                   "  - circle: {x_m: 0.2, y_m: -0.25, radius_m: 0.03}\nstart: rest\n"
                   "goal: {x_m: 0.36, y_m: 0.12, position_tolerance_m: 0.03}\n")
        # Two minutes of data are too few to leave the goal any room for the model's error.
        plan = self.run_json("plan", *arm, "--model", f"{kind}.safetensors", "--environment",
                             "goal.yaml", "--max-iterations", 5000, "--time-limit-s", 60,
                             "--goal-margin-m", 0, "--margin-m", 0,
                             "--out", f"{kind}.json")
        self.assertEqual(plan["status"], "solved")
        # A motor's angles are no pressures, so no name says kPa.
        self.assertNotIn("kpa", json.dumps(plan))

    def test_what_needs_pressures_says_so(self):
        for arguments in (
            ("characterize", "--arm", "motor_driven"),
            ("collect", "--arm", "motor_driven", "--count", 3, "--out", "x.h5"),
        ):
            message = self.run_limber(*arguments, code=2).stderr
            self.assertIn("driven by 'motor angle' in rad", message)


class BadInput(InFolder):
    """Each found by import, inspect or train, said in one message that says what to do."""

    def collect(self, arm, name, *arguments):
        self.run_limber("collect", "--arm", arm, "--schedule", "random", "--count", 3, "--hold-s", 1,
                        "--out", name, *arguments)

    def test_recordings_of_another_arm(self):
        self.collect("two_segment", "two.h5")
        text = (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8")
        self.write("other.yaml", text.replace("name: two_segment", "name: longer")
                   .replace("length_m: 0.235", "length_m: 0.30"))
        for verb in ("train", "evaluate"):
            message = self.run_limber(verb, "--arm", "other.yaml", "--data", "two.h5", code=2).stderr
            for part in ("two.h5", "'two_segment'", "'longer'", "Give the arm file"):
                self.assertIn(part, message)
            message = self.run_limber(verb, "--arm", "three_segment", "--data", "two.h5",
                                      code=2).stderr
            self.assertIn("Give the arm file that it was recorded with", message)
        found = self.run_json("inspect", "two.h5", "--arm", "other.yaml")["suspicions"]
        self.assertIn("recorded with another arm", found[0]["what"])

    def test_pressures_far_beyond_the_limits_and_other_rates(self):
        self.collect("two_segment", "good.h5")
        with h5py.File(self.folder / "good.h5", "r+") as file:
            pressures = file["episodes/000000/pressure_kpa"]
            pressures[...] = pressures[...] * 6.894757
        for verb in ("train", "evaluate"):
            message = self.run_limber(verb, *ARM, "--data", "good.h5", code=2).stderr
            for part in ("good.h5", "the limit of arm 'two_segment' is", "import it again"):
                self.assertIn(part, message)
        what = [s["what"] for s in self.run_json("inspect", "good.h5", *ARM)["suspicions"]]
        self.assertTrue(any("10 % beyond" in text for text in what), what)
        self.collect("two_segment", "fast.h5")
        with h5py.File(self.folder / "fast.h5", "r+") as file:
            file.attrs["rate_hz"] = 50.0
        message = self.run_limber("train", *ARM, "--data", "fast.h5", code=2).stderr
        self.assertIn("50 frames per second; arm 'two_segment' has 20", message)
        what = [s["what"] for s in self.run_json("inspect", "fast.h5")["suspicions"]]
        self.assertIn("frames at another rate than the file says", what)

    def test_recordings_that_were_never_tracked(self):
        self.collect("two_segment", "blind.h5")
        with h5py.File(self.folder / "blind.h5", "r+") as file:
            file["episodes/000000/tracked"][...] = 0
        for verb in ("train", "evaluate"):
            message = self.run_limber(verb, *ARM, "--data", "blind.h5", code=2).stderr
            self.assertIn("tracked in none of its", message)

    def test_names_that_are_not_utf8(self):
        self.collect("two_segment", "good.h5")
        bad = os.fsencode(self.folder) + b"/caf\xe9.h5"
        os.link(os.fsencode(self.folder / "good.h5"), bad)
        for command in ([b"train", b"--arm", b"two_segment", b"--data", bad, b"--epochs", b"3"],
                        [b"inspect", bad]):
            result = subprocess.run([os.fsencode(PROGRAM), *command], cwd=self.folder,
                                    capture_output=True, check=False)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(b"not UTF-8", result.stderr)
        text = (ROOT / "arms" / "two_segment.yaml").read_bytes()
        (self.folder / "latin.yaml").write_bytes(text.replace(b"name: two_segment", b"name: caf\xe9"))
        message = subprocess.run([PROGRAM, "inspect", "latin.yaml"], cwd=self.folder,
                                 capture_output=True, check=False)
        self.assertEqual(message.returncode, 2)
        self.assertRegex(message.stderr.decode("utf-8", "replace"), r"latin.yaml:\d+: a byte")

    def test_recordings_of_three_frames(self):
        self.collect("two_segment", "good.h5")
        self.run_limber("export", "good.h5", "--csv", "t")
        table = (self.folder / "t" / "episode_000.csv").read_text(encoding="utf-8").splitlines()
        self.write("three.csv", "\n".join(table[:4]) + "\n")
        message = self.run_limber("import", "csv", "three.csv", *ARM, "--mapping", "t/mapping.yaml",
                                  "--dry-run", code=2).stderr
        self.assertIn("three.csv", message)
        with h5py.File(self.folder / "good.h5", "r+") as file:
            episode = file["episodes/000000"]
            for name in list(episode):
                unit = episode[name].attrs["unit"]
                values = episode[name][:3]
                del episode[name]
                episode.create_dataset(name, data=values).attrs["unit"] = unit
        message = self.run_limber("train", *ARM, "--data", "good.h5", code=2).stderr
        self.assertIn("3 frames", message)
        what = [s["what"] for s in self.run_json("inspect", "good.h5")["suspicions"]]
        self.assertIn("an episode shorter than a training window", what)


if __name__ == "__main__":
    unittest.main()
