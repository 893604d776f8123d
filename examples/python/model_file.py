"""Writes a network that was trained elsewhere as a model that limber reads: safetensors,
docs/formats.md.

Layout base_poses, output compensation: the network is asked with (pressures before, pressures now,
backbone before, no-load backbone now), n + n + 3m + 3m numbers, and answers with what the backbone
has beside the no-load one, 3m numbers. ReLU is behind every layer but the last.

Of an arm in space the layout is gap_poses: 6 (m - 1) numbers for 3m, each plate's place about the
plate before and the rotation vector to it, and of the no-load backbone 6 for each segment.
"""

import json
import pathlib
import struct

import numpy as np
import numpy.typing as npt

import limber

Floats = npt.NDArray[np.float32]


def scaling(x: Floats) -> tuple[Floats, Floats]:
    """Offset and scale to mean 0 and deviation 1; numbers that never change stay."""
    offset, deviation = x.mean((0, 1)), x.std((0, 1))
    return offset, (1 / np.where(deviation > 1e-6, deviation, 1)).astype(np.float32)


def write_network(path: str, arm: limber.ArmDescription, layers: list[tuple[Floats, Floats]],
                  inputs: tuple[Floats, Floats], outputs: tuple[Floats, Floats]) -> None:
    """`layers`: weight (out, in) and bias (out,) of each. `inputs` and `outputs`: offset and scale,
    a number x being normalised as (x - offset) * scale."""
    tensors = {}
    for k, (weight, bias) in enumerate(layers):
        tensors[f"layers.{k}.weight"], tensors[f"layers.{k}.bias"] = weight, bias
    for name, (offset, scale) in (("input", inputs), ("output", outputs)):
        tensors[f"normalisation.{name}.offset"] = offset
        tensors[f"normalisation.{name}.scale"] = scale
    metadata = {
        "schema": "limber/model/1", "arm_name": arm.name, "arm_hash": arm.hash(),
        "segment_count": str(arm.segment_count), "point_count": str(arm.point_count),
        "preset": "paper", "layout": "base_poses", "output_form": "compensation"}
    if arm.dimension == 3:
        metadata.update(layout="gap_poses", dimension="3", chamber_count=str(arm.channel_count))
    header: dict[str, object] = {"__metadata__": metadata}
    content = b""
    for name, values in tensors.items():
        data = np.ascontiguousarray(values, "<f4").tobytes()
        header[name] = {"dtype": "F32", "shape": list(values.shape),
                        "data_offsets": [len(content), len(content) + len(data)]}
        content += data
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)  # tensors begin at a multiple of eight bytes
    pathlib.Path(path).write_bytes(struct.pack("<Q", len(text)) + text + content)
