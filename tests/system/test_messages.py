"""What is wrong in a file is said of that file, in a line that can be read, wherever it is used."""

import json
import unittest

import h5py

from program import InFolder
from test_plan import PILLAR, changed

ARM = ("--arm", "two_segment")
LONGEST = 600  # bytes of a message


def with_metadata(content, **changed_texts):
    """A safetensors file with other texts in its header."""
    size = int.from_bytes(content[:8], "little")
    header = json.loads(content[8:8 + size])
    header["__metadata__"].update(changed_texts)
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    return len(text).to_bytes(8, "little") + text + content[8 + size:]


class Messages(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 8, "--hold-s", 0.5, "--out", "r.h5")

    def refusal(self, *arguments):
        message = self.run_limber(*arguments, code=2).stderr
        self.assertLess(len(message), LONGEST)
        return message

    def model(self):
        self.run_limber("train", *ARM, "--data", "r.h5", "--epochs", 3, "--hidden", 8, "--out", "m.safetensors")
        return self.folder / "m.safetensors"

    def test_a_damaged_arm_in_a_model(self):
        content = self.model().read_bytes()
        (self.folder / "bad.safetensors").write_bytes(
            with_metadata(content, arm_description="name: two\nsegments: [{\n"))
        for command in (("inspect", "bad.safetensors"),
                        ("evaluate", *ARM, "--model", "bad.safetensors", "--data", "r.h5"),
                        ("export", "bad.safetensors", "--onnx", "bad.onnx")):
            with self.subTest(command=command[0]):
                self.assertIn("error: bad.safetensors: metadata arm_description:", self.refusal(*command))

    def test_a_damaged_arm_in_a_forest(self):
        self.write("e.yaml", json.dumps(PILLAR))
        self.run_limber("plan", *ARM, "--no-load", "--build-forest", "--forest-nodes", 20, "--forest", "a.forest")
        content = (self.folder / "a.forest").read_bytes()
        (self.folder / "bad.forest").write_bytes(with_metadata(content, arm_description="name: two\nsegments: [{\n"))
        self.assertIn("error: bad.forest: metadata arm_description:", self.refusal(
            "plan", *ARM, "--no-load", "--environment", "e.yaml", "--forest", "bad.forest", "--out", "p.json"))

    def test_a_plan_of_another_environment(self):
        self.write("e.yaml", json.dumps(PILLAR))
        self.write("other.yaml", json.dumps(changed(name="other", obstacles=[])))
        self.run_limber("plan", *ARM, "--no-load", "--environment", "e.yaml", "--max-queries", 20000, "--out", "p.json")
        self.assertIn("error: p.json: made for environment 'pillar'", self.refusal(
            "execute", *ARM, "--plan", "p.json", "--environment", "other.yaml"))

    def test_a_long_cell_of_a_table(self):
        self.model()
        self.write("path.csv", "time_s,x_m,y_m\n0,0.38,0.15\n1,0.38," + "9x" * 3000 + "\n")
        self.assertIn("error: path.csv:3:8: '9x9x", self.refusal(
            "execute", *ARM, "--model", "m.safetensors", "--track", "path.csv"))
        self.write("bench.csv", "pressure_kpa,strain\n0," + "9x" * 3000 + "\n")
        self.assertIn("error: bench.csv:2:3: '9x9x", self.refusal("characterize", *ARM, "--csv", "bench.csv", "--json"))

    def test_a_zero_byte_ends_no_message(self):
        self.write("bench.csv", "pressure_kpa,strain\n2\0x,0\n")
        self.assertIn(r"error: bench.csv:2:1: '2\x00x' found", self.refusal("characterize", *ARM, "--csv", "bench.csv"))
        self.write("p.json", json.dumps({"schema": "limber/plan/1\0x"}))
        self.assertIn(r"schema: 'limber/plan/1\x00x' found", self.refusal("inspect", "p.json"))

    def test_a_plate_that_no_arm_reaches_in_one_frame(self):
        self.model()
        with h5py.File(self.folder / "r.h5", "r+") as file:
            file["episodes/000000/backbone"][3, -1, 0] = 1e30
        for command in (("train", *ARM, "--data", "r.h5", "--epochs", 3, "--hidden", 8, "--out", "n.safetensors"),
                        ("evaluate", *ARM, "--model", "m.safetensors", "--data", "r.h5")):
            with self.subTest(command=command[0]):
                self.assertRegex(self.refusal(*command),
                                 r"error: r.h5: episodes/000000: frame 3: plate \d+ is 1e\+30 m from the base")
        self.assertFalse((self.folder / "n.safetensors").exists())


if __name__ == "__main__":
    unittest.main()
