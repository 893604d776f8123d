"""Whose arm a file is: what another machine's bench test makes of the same arm is the same arm, what
a user changes is another, and files of before arms were described keep to their hash."""

import json
import re
import struct
import unittest

from program import ROOT, InFolder, cpu_levels, limber

ARM = "two_segment"
BUDGET = ("--max-queries", 30000, "--cost-threshold", 1e6)
CODES = {"execute": 1}  # it runs, and misses: the no-load model is wrong
ENVIRONMENT = {
    "schema": "limber/environment/1",
    "name": "free",
    "obstacles": [{"circle": {"x_m": -0.3, "y_m": 0.3, "radius_m": 0.05}}],
    "start": "rest",
    "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03},
}


def without_description(path):
    """The model or forest as it was written before arms were described."""
    content = path.read_bytes()
    (size,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8 : 8 + size])
    del header["__metadata__"]["arm_description"]
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(struct.pack("<Q", len(text)) + text + content[8 + size :])


class SameArm(InFolder):
    def setUp(self):
        super().setUp()
        self.own = ROOT / "arms" / f"{ARM}.yaml"
        text = self.own.read_text(encoding="utf-8")
        # The last digit of c1, as another machine's bench test once had it: 1e-7 of strain.
        self.elsewhere = self.write("elsewhere.yaml", text.replace("0.001638291", "0.001638292"))
        self.wider = self.write("wider.yaml", text.replace("width_m: 0.0300", "width_m: 0.0320"))
        self.environment = self.write("e.yaml", json.dumps(ENVIRONMENT))
        self.assertEqual(len({self.hash_of(f) for f in (self.own, self.elsewhere, self.wider)}), 3)

    def hash_of(self, arm):
        return self.run_json("inspect", arm)["hash"]

    def make_chain(self):
        """A recording, a model, a plan and a forest of limber's own arm."""
        self.run_limber("collect", "--arm", ARM, "--schedule", "random", "--count", 6, "--episodes",
                        2, "--out", "r.h5")
        self.run_limber("train", "--arm", ARM, "--data", "r.h5", "--epochs", 3, "--out",
                        "m.safetensors")
        self.run_limber("plan", "--arm", ARM, "--no-load", "--environment", self.environment,
                        *BUDGET, "--out", "p.json")
        self.run_limber("plan", "--arm", ARM, "--no-load", "--build-forest", "--forest", "f",
                        "--forest-nodes", 300)

    def commands(self, arm):
        """Every verb that takes such a file and an arm."""
        plan = ("--plan", "p.json", "--environment", self.environment)
        return {
            "inspect model": ("inspect", "m.safetensors", "--arm", arm),
            "inspect plan": ("inspect", "p.json", "--arm", arm),
            "inspect forest": ("inspect", "f", "--arm", arm),
            "bench": ("bench", "--model", "m.safetensors", "--arm", arm, "--queries", 1000),
            "evaluate": ("evaluate", "--model", "m.safetensors", "--data", "r.h5", "--arm", arm),
            "train": ("train", "--from", "m.safetensors", "--data", "r.h5", "--epochs", 1, "--arm",
                      arm, "--out", "again.safetensors", "--force"),
            "verify": ("verify", *plan, "--no-load", "--arm", arm),
            "execute": ("execute", *plan, "--arm", arm),
            "export": ("export", "p.json", "--csv", "csv", "--force", "--arm", arm),
        }

    def test_another_machines_fit_is_the_same_arm(self):
        self.make_chain()
        for name, command in self.commands(self.elsewhere).items():
            with self.subTest(name):
                self.run_limber(*command, code=CODES.get(name, 0))
        said = self.run_limber("plan", "--arm", self.elsewhere, "--no-load", "--environment",
                               self.environment, *BUDGET, "--forest", "f").stderr
        self.assertNotIn("growing", said)

    def test_a_changed_arm_is_another_and_the_message_names_the_key(self):
        self.make_chain()
        for name, command in self.commands(self.wider).items():
            with self.subTest(name):
                error = self.run_limber(*command, code=2).stderr
                self.assertIn("segments[1].width_m: 0.03 there, 0.032 here", error)

    def test_files_of_before_keep_to_their_hash(self):
        self.make_chain()
        without_description(self.folder / "m.safetensors")
        without_description(self.folder / "f")
        plan = json.loads((self.folder / "p.json").read_text(encoding="utf-8"))
        del plan["arm"]["description"], plan["certificate"]
        self.write("p.json", json.dumps(plan))
        for name, command in self.commands(ARM).items():
            with self.subTest(name):
                self.run_limber(*command, code=CODES.get(name, 0))
        for name in ("inspect model", "inspect plan", "inspect forest", "bench", "verify"):
            with self.subTest(name):
                error = self.run_limber(*self.commands(self.elsewhere)[name], code=2).stderr
                self.assertIn("kept only a hash", error)

    def test_characterising_again_keeps_the_arm_on_every_cpu(self):
        for name in ("two_segment", "three_segment", "five_segment"):
            before = self.hash_of(ROOT / "arms" / f"{name}.yaml")
            self.run_limber("characterize", "--arm", name, "--out", f"{name}.yaml")
            self.assertEqual(self.hash_of(f"{name}.yaml"), before)
        unfitted = re.sub(r"strain_polynomial: \[.*\]", "strain_polynomial: []",
                          self.own.read_text(encoding="utf-8"))
        self.write("unfitted.yaml", unfitted)
        fitted = set()
        for level in cpu_levels():
            result = limber("characterize", "--arm", "unfitted.yaml", "--out", "fitted.yaml",
                            "--force", folder=self.folder, environment={"LIMBER_CPU": level})
            self.assertEqual(result.returncode, 0, result.stderr)
            fitted.add((self.folder / "fitted.yaml").read_text(encoding="utf-8"))
        self.assertEqual(len(fitted), 1)
        # And what is fitted afresh is the arm that the file describes.
        self.run_limber("plan", "--arm", ARM, "--no-load", "--environment", self.environment,
                        *BUDGET, "--out", "p.json")
        self.run_limber("inspect", "p.json", "--arm", "fitted.yaml")


if __name__ == "__main__":
    unittest.main()
