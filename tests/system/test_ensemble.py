"""An ensemble of networks: the first one plans, the others have to agree, and what each says of a plan."""

import json
import struct
import unittest

from program import InFolder

ARM = ("--arm", "two_segment")
NOTHING_IN_THE_WAY = {
    "schema": "limber/environment/1",
    "name": "free",
    "obstacles": [{"circle": {"x_m": -0.3, "y_m": -0.25, "radius_m": 0.04}}],
    "start": "rest",
    "goal": {"x_m": 0.40, "y_m": 0.15, "position_tolerance_m": 0.05},
}
PLAN = ("plan", *ARM, "--max-iterations", 400, "--margin-m", 0, "--goal-margin-m", 0)


def read_tensors(path):
    data = path.read_bytes()
    size = struct.unpack("<Q", data[:8])[0]
    header = json.loads(data[8 : 8 + size])
    metadata = header.pop("__metadata__")
    body = data[8 + size :]
    return metadata, {
        name: (entry, body[slice(*entry["data_offsets"])]) for name, entry in header.items()
    }


def write_tensors(path, metadata, tensors):
    header, body = {"__metadata__": metadata}, b""
    for name, (entry, data) in tensors.items():
        header[name] = {**entry, "data_offsets": [len(body), len(body) + len(data)]}
        body += data
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(struct.pack("<Q", len(text)) + text + body)


def nudged(data, by):
    values = struct.unpack(f"<{len(data) // 4}f", data)
    return struct.pack(f"<{len(values)}f", *(value + by for value in values))


class Ensemble(InFolder):
    def setUp(self):
        super().setUp()
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 60, "--out", "train.h5")
        self.run_limber("train", *ARM, "--data", "train.h5", "--hidden", 8, "--epochs", 30,
                        "--out", "one.safetensors")
        metadata, tensors = read_tensors(self.folder / "one.safetensors")
        layers = {name: value for name, value in tensors.items() if name.startswith("layers.")}
        last = max(name for name in layers if name.endswith("bias"))
        for member, by in ((1, 0.002), (2, -0.004)):  # three networks that differ a little
            for name, (entry, data) in layers.items():
                tensors[f"members.{member}.{name}"] = (
                    entry, nudged(data, by) if name == last else data)
        write_tensors(self.folder / "three.safetensors", metadata, tensors)
        self.environment = self.write("e.yaml", json.dumps(NOTHING_IN_THE_WAY))

    def plan(self, *arguments, model="three.safetensors", out="p.json", **options):
        return self.run_json(*PLAN, "--environment", self.environment, "--model", model, "--out",
                             out, "--force", *arguments, **options)

    def read(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def verify(self, *arguments, model="three.safetensors", code=0, plan="p.json"):
        return self.run_json("verify", *ARM, "--plan", plan, "--environment", self.environment,
                             "--model", model, *arguments, code=code)

    def test_the_spread_is_that_of_the_networks_by_themselves(self):
        found = self.plan()
        spread = found["spread"]
        self.assertEqual(spread["members"], 3)
        distance = spread["end"]["distance_to_goal_cm"]
        self.assertLess(distance["min"], distance["max"])
        self.assertGreater(spread["end"]["largest_distance_cm"], 0)
        closest = spread["closest_approach"]
        self.assertEqual(closest["obstacle"], 0)
        self.assertLess(closest["clearance_cm"]["min"], closest["clearance_cm"]["max"])
        self.assertEqual(self.verify()["spread"], spread)
        also = self.verify("--also", "three.safetensors", code=None)["also"][0]
        self.assertEqual(also["spread"], spread)
        text = self.run_limber(*PLAN, "--environment", self.environment, "--model",
                               "three.safetensors").stdout
        self.assertRegex(text, r"the 3 networks of this model, each by itself, put the end "
                               r"\d+\.\d\d to \d+\.\d\d cm from the goal")
        self.assertNotIn("spread", self.plan(model="one.safetensors"))

    def test_evaluate_shows_each_network_and_their_mean(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 5, "--seed", 9, "--out",
                        "test.h5")
        found = self.run_json("evaluate", *ARM, "--model", "three.safetensors", "--data", "test.h5")
        self.assertEqual(found["ensemble"]["members"], 3)
        alone = self.run_json("evaluate", *ARM, "--model", "one.safetensors", "--data", "test.h5")
        self.assertEqual(found["network"], alone["network"], "the first one answers")
        self.assertNotIn("ensemble", alone)


if __name__ == "__main__":
    unittest.main()
