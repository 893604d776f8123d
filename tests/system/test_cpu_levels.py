"""What a seed promises (docs/architecture.md, Threads and chance): the same bits for any number of
threads on one kind of CPU, and recordings of the virtual arm that are the same on every kind."""

import json
import unittest

from program import ROOT, InFolder, cpu_levels, limber

ARM = ("--arm", ROOT / "arms" / "two_segment.yaml")
ENVIRONMENT = {
    "schema": "limber/environment/1", "name": "free", "obstacles": [], "start": "rest",
    "goal": {"x_m": 0.38, "y_m": 0.2, "position_tolerance_m": 0.03},
}


class CpuLevels(InFolder):
    def made(self, level, jobs):
        """A recording, a network trained on the first one, and a plan by it."""
        name = f"{level}_{jobs}"
        (self.folder / "e.yaml").write_text(json.dumps(ENVIRONMENT), encoding="utf-8")
        outputs = [self.folder / f"{name}{end}" for end in (".h5", ".safetensors", ".json")]
        for command in (
            ("collect", *ARM, "--schedule", "random", "--count", 3, "--hold-s", 0.5, "--seed", 3,
             "--out", outputs[0]),
            ("train", *ARM, "--data", "first.h5", "--hidden", 16, "--epochs", 60, "--windows", 2, 8,
             "--out", outputs[1]),
            ("plan", *ARM, "--model", outputs[1], "--environment", "e.yaml", "--max-queries", 8000,
             "--margin-m", 0, "--goal-margin-m", 0, "--out", outputs[2]),
        ):
            result = limber(*command, "--jobs", jobs, "--quiet", folder=self.folder,
                            environment={"LIMBER_CPU": level})
            self.assertEqual(result.returncode, 0, result.stderr)
            if not (self.folder / "first.h5").exists():
                (self.folder / "first.h5").write_bytes(outputs[0].read_bytes())
        recording, model, plan = outputs
        frames = json.loads(plan.read_text(encoding="utf-8"))["frames"]
        return recording.read_bytes(), self.weights_of(model), frames

    def weights_of(self, model):
        """Its tensors; the record beside them has seconds."""
        content = model.read_bytes()
        size = int.from_bytes(content[:8], "little")
        return content[8 + size:]

    def test_a_seed_gives_the_same_bits_on_one_level(self):
        levels = cpu_levels()
        self.assertIn("baseline", levels)
        recordings = set()
        for level in levels:
            one, other = self.made(level, 1), self.made(level, 3)
            self.assertEqual(one[0], other[0], f"recordings, {level}")
            self.assertEqual(one[1], other[1], f"networks, {level}")
            self.assertEqual(one[2], other[2], f"plans, {level}")
            recordings.add(one[0])
        self.assertEqual(len(recordings), 1, "the virtual arm knows no levels")


if __name__ == "__main__":
    unittest.main()
