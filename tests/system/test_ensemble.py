"""An ensemble of networks: plans with its mean, what its networks say of a plan, what is refused."""

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

    def test_plans_with_the_mean_say_so_and_are_certified_so(self):
        found = self.plan("--ensemble", "mean")
        self.assertEqual(found["status"], "solved")
        self.assertEqual(found["ensemble"], "mean")
        self.assertTrue(found["certificate"]["certified"])
        self.assertEqual(self.read("p.json")["model"]["ensemble"], "mean")
        self.assertEqual(self.verify()["status"], "certified")  # without a flag: the plan says it
        self.assertEqual(self.run_json("inspect", "p.json")["ensemble"], "mean")
        self.run_json("execute", *ARM, "--plan", "p.json", "--environment", self.environment,
                      "--replan", "--model", "three.safetensors", "--max-replans", 1,
                      "--replan-queries", 500)

    def test_without_the_flag_the_first_network_plans_as_it_would_alone(self):
        self.plan(out="first.json")
        self.plan("--ensemble", "first", out="asked.json")
        first = self.read("first.json")
        self.assertEqual(first, self.read("asked.json"))
        self.assertNotIn("ensemble", first["model"])

    def test_the_spread_is_that_of_the_networks_by_themselves(self):
        for answer in ("first", "mean"):
            with self.subTest(answer=answer):
                found = self.plan("--ensemble", answer)
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

    def test_a_forest_of_the_first_network_is_grown_again_for_the_mean(self):
        grow = ("--forest", "f.forest", "--forest-nodes", 200)
        self.plan(*grow)
        first = self.run_json("inspect", "f.forest")["model_hash"]
        self.plan(*grow, "--ensemble", "mean")
        self.assertEqual(self.run_json("inspect", "f.forest")["model_hash"], first + " mean")

    def test_what_is_no_ensemble_has_no_mean(self):
        arguments = (*PLAN, "--environment", self.environment, "--ensemble", "mean")
        one = self.run_limber(*arguments, "--model", "one.safetensors", code=2).stderr
        self.assertIn("--ensemble mean: one.safetensors holds one network", one)
        none = self.run_limber(*arguments, "--no-load", code=2).stderr
        self.assertIn("--ensemble mean: the no-load model is no ensemble", none)
        self.plan("--ensemble", "mean")
        plan = self.read("p.json")
        plan["model"]["hash"] = ""
        del plan["certificate"]
        (self.folder / "p.json").write_text(json.dumps(plan), encoding="utf-8")
        message = self.run_limber("verify", *ARM, "--plan", "p.json", "--environment",
                                  self.environment, "--model", "one.safetensors", code=2).stderr
        self.assertIn("made with the mean of an ensemble; one.safetensors holds one network",
                      message)

    def test_evaluate_and_experiment_use_the_mean(self):
        self.run_limber("collect", *ARM, "--schedule", "random", "--count", 5, "--seed", 9, "--out",
                        "test.h5")
        errors = {
            answer: self.run_json("evaluate", *ARM, "--model", "three.safetensors", "--data",
                                  "test.h5", "--ensemble", answer)
            for answer in ("first", "mean")
        }
        self.assertNotEqual(errors["first"]["network"], errors["mean"]["network"])
        self.assertEqual(errors["first"]["ensemble"], errors["mean"]["ensemble"])
        message = self.run_limber("evaluate", *ARM, "--model", "three.safetensors", "--data",
                                  "test.h5", "--ensemble", "mean", "--out", "m.safetensors",
                                  code=2).stderr
        self.assertIn("--out: a model stores the error of its first network", message)
        (self.folder / "environments").mkdir()
        self.write("environments/e.yaml", json.dumps(NOTHING_IN_THE_WAY))
        run = ("experiment", *ARM, "--model", "three.safetensors", "--environments", "environments",
               "--trials", 1, "--max-iterations", 300, "--network-only", "--margin-m", 0,
               "--goal-margin-m", 0, "--out", "x")
        self.run_limber(*run, "--ensemble", "mean")
        self.assertEqual(self.read("x/experiment.json")["ensemble"], "mean")
        message = self.run_limber(*run, "--resume", code=2).stderr
        self.assertIn("ensemble", message)


if __name__ == "__main__":
    unittest.main()
