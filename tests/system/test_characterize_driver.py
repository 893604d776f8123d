"""`limber characterize --driver exec:…`: the bench test of one mounted segment, here a virtual one on its table."""

import json
import unittest

import h5py
import yaml

from program import PROGRAM, InFolder

ARM = {
    "schema": "limber/arm/1", "name": "one", "frame_rate_hz": 20, "pressure_rate_limit_kpa_per_s": 100,
    "actuator_radius_m": 0.006,
    "segments": [{"length_m": 0.235, "width_m": 0.05, "gaps": 5, "pressure_limit_kpa": 100, "strain_polynomial": []}],
    "virtual_arm": {"friction_coefficient": 0.0, "strength_spread": 0.0, "hysteresis_fraction": 0.0,
                    "hysteresis_floor_n": 0.0},
}


class Characterizing(InFolder):
    def setUp(self):
        super().setUp()
        self.write("one.yaml", json.dumps(ARM))

    def on_driver(self, *flags, arm="one.yaml", serve=(), code=0):
        words = [PROGRAM, "virtual-arm", "--serve", "--fast", "--arm", arm, *serve]
        return self.run_limber("characterize", "--arm", arm, "--driver", "exec:" + " ".join(f"'{w}'" for w in words),
                               "--simulated", "--steps", 5, *flags, code=code)

    def test_finds_what_the_bench_test_in_process_finds(self):
        found = json.loads(self.on_driver("--out", "fitted.yaml", "--json").stdout)
        bench = self.run_json("characterize", "--arm", "one.yaml", "--steps", 5)
        ours, theirs = found["segments"][0], bench["segments"][0]
        # The driver's segment is measured by its plates, with friction in its chain's bends; the other by its sides.
        self.assertAlmostEqual(ours["full_strain"], theirs["full_strain"], delta=0.06 * theirs["full_strain"])
        self.assertEqual(len(ours["points"]), 19)
        self.assertIn("started by", found["source"])
        fitted = yaml.safe_load((self.folder / "fitted.yaml").read_text())
        self.assertEqual(len(fitted["segments"][0]["strain_polynomial"]), 4)
        with h5py.File(self.folder / "fitted.bench.h5") as file:
            episode = file["episodes"][sorted(file["episodes"])[0]]
            self.assertAlmostEqual(episode["setpoint_kpa"][()].max(), 100.0, places=3)
            self.assertAlmostEqual(episode["setpoint_kpa"][()].min(), -100.0, places=3)
        self.assertTrue((self.folder / "fitted.bench.h5.driver.jsonl").exists())

    def test_a_fault_leaves_what_was_recorded(self):
        result = self.on_driver("--out", "fitted.yaml", serve=("--fault", "die@60"), code=3)
        self.assertIn("exit code 9", result.stderr)
        self.assertFalse((self.folder / "fitted.yaml").exists())
        self.assertFalse((self.folder / "fitted.bench.h5").exists())
        with h5py.File(self.folder / "fitted.bench.partial.h5") as file:
            self.assertEqual(len(file["episodes"]), 1)

    def test_what_was_recorded_before_the_bench_test_is_read(self):
        self.run_limber("collect", "--arm", "one.yaml", "--schedule", "random", "--count", 2, "--out", "r.h5")
        self.assertIn("nothing suspicious", self.run_limber("inspect", "r.h5").stdout)
        (self.folder / "csv").mkdir()
        self.run_limber("export", "r.h5", "--csv", "csv")
        self.assertTrue((self.folder / "csv/mapping.yaml").exists())

    def test_an_arm_that_is_written_anew_keeps_its_safety(self):
        self.write("safe.yaml", yaml.safe_dump({**ARM, "safety": {"jump_m": 0.05}, "virtual_arm": {}}))
        self.write("fence.yaml", (self.folder / "safe.yaml").read_text().replace("strain_polynomial: []", "strain_polynomial:"))
        for arm in ("safe.yaml", "fence.yaml"):
            self.run_limber("characterize", "--arm", arm, "--out", "fitted.yaml", "--force", "--steps", 5)
            self.assertEqual(yaml.safe_load((self.folder / "fitted.yaml").read_text())["safety"], {"jump_m": 0.05})

    def test_refusals(self):
        whole = self.on_driver("--out", "f.yaml", arm="two_segment", code=2)
        self.assertIn("limber characterize --recording", whole.stderr)
        self.assertFalse((self.folder / "f.bench.h5.driver.jsonl").exists())
        for flag, value in (("--driver", "exec:none"), ("--dry-run", None)):
            csv = self.run_limber("characterize", "--csv", "points.csv", flag, *([value] if value else []), code=2)
            self.assertIn(f"{flag}: is for a bench test; --csv, --valves, --recording and --commands need none",
                          csv.stderr)
        steps = self.run_limber("characterize", "--csv", "points.csv", "--steps", 7, code=2)
        self.assertIn("--steps", steps.stderr)

    def test_a_dry_run_prints_what_would_be_sent(self):
        lines = self.run_limber("characterize", "--arm", "one.yaml", "--steps", 4, "--dry-run", "--limit-scale", 0.5)
        sets = [json.loads(line) for line in lines.stdout.splitlines()]
        sets = [line["pressure_kpa"][0] for line in sets if line["type"] == "set"]
        self.assertAlmostEqual(max(sets), 50.0, places=3)
        self.assertAlmostEqual(min(sets), -50.0, places=3)


if __name__ == "__main__":
    unittest.main()
