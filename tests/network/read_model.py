"""Reads limber's model files by the published safetensors format alone (struct, json, NumPy), evaluates
the network in float64 and compares with limber's answers. Usage: read_model.py WRITE_SAMPLE_MODEL FOLDER
"""

import json
import pathlib
import struct
import subprocess
import sys

try:
    import numpy as np
except ImportError:
    sys.exit(77)  # ctest counts it as skipped

RELATIVE_TOLERANCE = 5e-6  # of the largest output: float32 sums of about 100 products, four layers


def read_safetensors(path):
    content = path.read_bytes()
    (length,) = struct.unpack("<Q", content[:8])
    assert length % 8 == 0, "data are not aligned"
    assert content[8:9] == b"{", "header does not begin with {"
    header = json.loads(content[8 : 8 + length].decode("utf-8"))
    metadata = header.pop("__metadata__")
    assert all(isinstance(v, str) for v in metadata.values())
    data = content[8 + length :]
    tensors, end = {}, 0
    for name, entry in sorted(header.items(), key=lambda item: item[1]["data_offsets"]):
        assert set(entry) == {"dtype", "shape", "data_offsets"}, name
        assert entry["dtype"] == "F32", name
        begin, stop = entry["data_offsets"]
        assert begin == end, f"{name}: overlap or hole"
        tensors[name] = np.frombuffer(data[begin:stop], "<f4").reshape(entry["shape"])
        end = stop
    assert end == len(data), "bytes behind the last tensor"
    return metadata, tensors


def evaluate(tensors, inputs):
    t = {name: value.astype(np.float64) for name, value in tensors.items()}
    x = (inputs - t["normalisation.input.offset"]) * t["normalisation.input.scale"]
    layers = sum(name.endswith(".weight") for name in t)
    for layer in range(layers):
        x = x @ t[f"layers.{layer}.weight"].T + t[f"layers.{layer}.bias"]
        if layer < layers - 1:
            x = np.maximum(x, 0.0)
    size = len(t["normalisation.output.scale"])  # behind it, gates as they are
    x[:, :size] = x[:, :size] / t["normalisation.output.scale"] + t["normalisation.output.offset"]
    return x


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    subprocess.run([program, str(folder)], check=True)
    for layout, form, sizes in (
        ("base_poses", "compensation", (102, 48)),
        ("gap_poses", "compensation", (60, 45)),
        ("gap_poses", "gated_change", (60, 90)),
    ):
        name = f"{layout}_{form}"
        metadata, tensors = read_safetensors(folder / f"{name}.safetensors")
        assert metadata["schema"] == "limber/model/1"
        assert metadata["layout"] == layout
        assert metadata["output_form"] == form
        assert metadata["arm_name"] == "sample3" and len(metadata["arm_hash"]) == 32
        assert metadata["training.note"] == "sample"
        inputs = np.loadtxt(folder / f"{name}.inputs")
        outputs = np.loadtxt(folder / f"{name}.outputs")
        assert (inputs.shape[1], outputs.shape[1]) == sizes
        wanted = evaluate(tensors, inputs)
        scale = np.abs(wanted).max(axis=0)
        error = (np.abs(outputs - wanted) / scale).max()
        assert wanted.std(axis=0).min() > 0.0, "outputs do not depend on the inputs"
        assert error < RELATIVE_TOLERANCE, f"{name}: off by {error} of the range"
        print(f"{name}: largest error {error:.1e} of the output's range")


main()
