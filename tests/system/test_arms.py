"""The whole chain on the shortest and the longest arm that files may describe: 1 and 12 segments."""

import json
import re
import unittest

from program import ROOT, InFolder

SEGMENT = (
    "  - {{length_m: 0.12, width_m: {width:.4f}, gaps: 3, pressure_limit_kpa: 100,\n"
    "     strain_polynomial: [0.0016, 3.8e-05, -5.2e-07, 1.8e-09]}}\n"
)


class Arms(InFolder):
    def arm_file(self, segments):
        text = (ROOT / "arms" / "three_segment.yaml").read_text(encoding="utf-8")
        head, rest = text.split("segments:\n", 1)
        virtual = rest[rest.index("# Physics of the virtual arm") :]
        rows = "".join(SEGMENT.format(width=0.05 - 0.002 * k) for k in range(segments))
        head = head.replace("name: three_segment", f"name: arm_{segments}")
        return self.write("arm.yaml", f"{head}segments:\n{rows}\n{virtual}")

    def chain(self, segments):
        arm = ("--arm", self.arm_file(segments))
        made = self.run_json(
            "collect", *arm, "--schedule", "random", "--count", 6, "--episodes", 2, "--out", "r.h5"
        )
        self.assertGreater(made["frames"], 300)
        trained = self.run_json(
            "train", *arm, "--data", "r.h5", "--epochs", 3, "--out", "m.safetensors"
        )
        self.assertEqual(trained["epochs"], 3)
        found = self.run_json("evaluate", *arm, "--model", "m.safetensors", "--data", "r.h5")
        rollout = found["long_rollout"]
        self.assertEqual(rollout["bounded"], rollout["held_share"] <= 0.1, "three epochs: its bounds may hold it")
        environment = {
            "schema": "limber/environment/1",
            "name": "beside",
            "obstacles": [{"circle": {"x_m": -0.3, "y_m": 0.3, "radius_m": 0.05}}],
            "start": "rest",
            "goal": {"x_m": 0.11 * segments, "y_m": 0.03, "position_tolerance_m": 0.03},
        }
        path = self.write("e.yaml", json.dumps(environment))
        plan = self.run_json(
            "plan", *arm, "--no-load", "--environment", path, "--max-queries", 30000,
            "--cost-threshold", 1e6, "--out", "p.json",
        )
        self.assertEqual(plan["status"], "solved")
        self.run_json("verify", *arm, "--no-load", "--plan", "p.json", "--environment", path)
        run = self.run_execution(*arm, "--plan", "p.json", "--environment", path)
        self.assertEqual(run["status"], "done")

    def test_one_segment(self):
        self.chain(1)

    def test_twelve_segments(self):
        self.chain(12)

    def test_an_arm_whose_no_load_model_is_far_off_gets_environments_that_it_reaches(self):
        text = (ROOT / "arms" / "two_segment.yaml").read_text(encoding="utf-8")
        stiff = re.sub(r"strain_polynomial: \[.*\]", "strain_polynomial: [0.0004, 0, 0, 0]", text)
        arm = ("--arm", self.write("stiff.yaml", stiff.replace("two_segment", "stiff")))
        many = self.run_json("environment", *arm, "--random", "--seed", 4, "--count", 3, "--out", "a")
        self.assertEqual(len(many["files"]), 3)
        self.run_limber("environment", *arm, "--random", "--seed", 4, "--jobs", 1, "--out", "b")
        self.assertEqual(*((self.folder / of / "random_4_001.yaml").read_text() for of in "ab"))
        error = self.run_limber("environment", *arm, "--random", "--model", "x", "--out", "c", code=2).stderr
        self.assertIn("asks no model", error)

    def test_an_arm_without_a_virtual_twin_has_its_model_as_a_witness(self):
        arm = ("--arm", "motor_driven")
        error = self.run_limber("environment", *arm, "--random", "--out", "a", code=2).stderr
        self.assertIn("has no virtual twin", error)
        self.assertIn("--witness model", error)
        self.run_limber("environment", *arm, "--random", "--witness", "model", "--out", "a")
        path = self.folder / "a" / "random_1_001.yaml"
        self.assertEqual(self.run_json("environment", "check", path, *arm)["status"], "ok")


if __name__ == "__main__":
    unittest.main()
