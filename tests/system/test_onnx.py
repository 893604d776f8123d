"""`limber export --onnx`: OpenCV's answers are limber's, bounds included."""

import json
import struct
import unittest

import numpy as np

from program import InFolder

ARM = ("--arm", "two_segment")


def read_tensors(path):
    """Tensors of a safetensors file, in double."""
    content = path.read_bytes()
    (length,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8:8 + length])
    header.pop("__metadata__")
    data = content[8 + length:]
    return {
        name: np.frombuffer(data[slice(*entry["data_offsets"])], "<f4")
        .reshape(entry["shape"]).astype(np.float64)
        for name, entry in header.items()
    }


def tighten_bounds(path):
    """Moves the bounds of the model file to a fiftieth of their range, so that they hold many gaps."""
    content = bytearray(path.read_bytes())
    (length,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8:8 + length])
    for what in ("length", "turn"):
        parts = [slice(*(8 + length + offset
                         for offset in header[f"bounds.{what}.{end}"]["data_offsets"]))
                 for end in ("min", "max")]
        low, high = (np.frombuffer(bytes(content[part]), "<f4") for part in parts)
        middle, half = (low + high) / 2, (high - low) / 100
        content[parts[0]] = (middle - half).astype("<f4").tobytes()
        content[parts[1]] = (middle + half).astype("<f4").tobytes()
    path.write_bytes(bytes(content))


def bounded_next(tensors, queries, answers, preset, segments=2):
    """(5) or (16) and then (20) of docs/model.md, and the share of gaps that a bound holds."""
    size = len(tensors["normalisation.output.scale"])
    queries = queries.astype(np.float64)
    if preset == "paper":
        steps = (queries[:, -size:] + answers).reshape(len(queries), -1, 3)
        steps[:, 0] = 0.0
        steps = np.diff(steps, axis=1)
    else:
        previous = queries[:, 2 * segments:2 * segments + size]
        gaps = size // 3 // segments
        no_load = queries[:, 2 * segments + size:5 * segments + size]  # velocities follow
        no_load = np.repeat(no_load.reshape(-1, segments, 3), gaps, axis=1)
        gate = 1.0 / (1.0 + np.exp(-answers[:, size:]))
        steps = previous + answers[:, :size] + gate * (no_load.reshape(-1, size) - previous)
        steps = steps.reshape(len(queries), -1, 3)
    length = np.hypot(steps[:, :, 0], steps[:, :, 1])
    kept = np.clip(length, tensors["bounds.length.min"], tensors["bounds.length.max"])
    turn = np.clip(steps[:, :, 2], tensors["bounds.turn.min"], tensors["bounds.turn.max"])
    held = np.mean((kept != length) | (turn != steps[:, :, 2]))
    bounded = np.dstack([steps[:, :, :2] * (kept / length)[:, :, None], turn])
    if preset == "paper":
        zero = np.zeros((len(queries), 1, 3))
        bounded = np.concatenate([zero, np.cumsum(bounded, axis=1)], axis=1)
    return bounded.reshape(len(queries), -1), held


class Onnx(InFolder):
    def test_opencv_gives_limbers_answers(self):
        try:
            import cv2
        except ImportError:
            self.skipTest("python3-opencv is not installed")
        if "missing" in self.run_json("doctor")["onnx"]:
            self.skipTest("limber was built without ONNX")
        self.run_limber("collect", *ARM, "--hold-s", 1.0, "--count", 12, "--out", "train.h5")
        for preset in ("best", "paper"):
            self.run_limber(
                "train", *ARM, "--data", "train.h5", "--preset", preset, "--epochs", 3,
                "--out", f"{preset}.safetensors",
            )
            tighten_bounds(self.folder / f"{preset}.safetensors")
            self.run_limber("export", f"{preset}.safetensors", "--onnx", f"{preset}.onnx",
                            "--csv", preset)
            with open(self.folder / preset / "reference_queries.csv", encoding="utf-8") as file:
                names = file.readline().strip().split(",")
                table = np.loadtxt(file, delimiter=",", dtype=np.float64)
            inputs = sum(name.startswith("query_") for name in names)
            queries = table[:, :inputs].astype(np.float32)
            answers = table[:, inputs:]
            network = cv2.dnn.readNetFromONNX(str(self.folder / f"{preset}.onnx"))
            for batch in (1, 7, len(queries)):
                network.setInput(queries[:batch], "query")
                found = network.forward("answer")
                self.assertEqual(found.shape, (batch, answers.shape[1]))
                # Single precision, sums of a hundred terms in another order.
                tolerance = 2e-6 + 2e-5 * np.abs(answers).max()
                self.assertLess(np.abs(found - answers[:batch]).max(), tolerance)
                wanted, held = bounded_next(
                    read_tensors(self.folder / f"{preset}.safetensors"), queries[:batch],
                    answers[:batch], preset)
                network.setInput(queries[:batch], "query")
                found = network.forward("next")
                self.assertEqual(found.shape, wanted.shape)
                self.assertLess(np.abs(found - wanted).max(), 3 * tolerance)
            self.assertGreater(held, 0.1, "bounds that hold nothing prove nothing")
            self.assertGreater(np.ptp(answers), 1e-3, "a comparison of constants proves nothing")


if __name__ == "__main__":
    unittest.main()
