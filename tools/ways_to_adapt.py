#!/usr/bin/env python3
"""Ways to make a family one arm's, from the same minute: e beside two others (docs/families.md).

    PYTHONPATH=build/release/python tools/ways_to_adapt.py --family F.safetensors --out OUT

  e           limber adapt's, no weights trained
  last layer  of the family's middle: least squares over windows that are predicted without correction; the gates
              stay
  low rank    of the family's middle, each layer's leading singular values, as many numbers as e has: least
              squares over windows that are predicted without correction, as e's

Mean tip error over the next 100 s, open loop, in cm: median; 90th percentile over unseen arms.
"""

import argparse
import json
import pathlib
import struct
import time

import numpy as np

import limber
from family_figures import FRAME_RATE_HZ, Family, both, piece

WINDOW_FRAMES = 64  # as limber adapt's
ITERATIONS = 8
STEP = 0.02  # of a singular value's relative change, for derivatives
FREEDOM = 0.3  # prior of a singular value's relative change
RIDGES = (1e6, 1e7)  # of the last layer's least squares: of 1e3 to 1e8 the best for single arms
ROUNDS = 2  # of them, each along the prediction of the one before
PLACE_M = 0.003  # error of a plate that counts as one, beside a change of its prior's size
INDEPENDENT_FRAMES = 20


class ModelFile:
    """Tensors of a safetensors file, to be changed and read again by limber."""

    def __init__(self, path):
        content = path.read_bytes()
        end = 8 + struct.unpack("<Q", content[:8])[0]
        self.header = json.loads(content[8:end])
        self.data = np.frombuffer(content[end:], np.float32)
        self.scratch = path.with_suffix(".changed")

    def __getitem__(self, name):
        first, last = self.header[name]["data_offsets"]
        return self.data[first // 4:last // 4].reshape(self.header[name]["shape"])

    def changed(self, tensors):
        data = self.data.copy()
        for name, values in tensors.items():
            first, last = self.header[name]["data_offsets"]
            data[first // 4:last // 4] = np.asarray(values, np.float32).ravel()
        head = json.dumps(self.header).encode()
        head += b" " * (-len(head) % 8)
        self.scratch.write_bytes(struct.pack("<Q", len(head)) + head + data.tobytes())
        return limber.read_model(self.scratch)

    def layers(self):
        count = sum(name.startswith("layers.") for name in self.header) // 2
        return [(self[f"layers.{k}.weight"], self[f"layers.{k}.bias"]) for k in range(count)]


def gap_poses(backbones):
    """Each plate's pose about the plate before it: (15)."""
    apart = np.diff(backbones, axis=1)
    cos, sin = np.cos(backbones[:, :-1, 2]), np.sin(backbones[:, :-1, 2])
    return np.stack([cos * apart[..., 0] + sin * apart[..., 1], cos * apart[..., 1] - sin * apart[..., 0],
                     apart[..., 2]], axis=2).reshape(len(backbones), -1)


def windows_of(minute):
    return [piece(minute, first, first + WINDOW_FRAMES + 1)
            for first in range(0, len(minute.time_s) - WINDOW_FRAMES, WINDOW_FRAMES)]


def read_by_last_layer(arm, file, window, predicted):
    """What the last layer reads along a prediction, a row for each frame but the first, and its gates: (16)."""
    pressure = np.asarray(window.pressure_kpa, float)
    no_load = limber.NoLoadModel(arm)
    unloaded = gap_poses(np.array([no_load.backbone(kpa) for kpa in np.asarray(window.pressure_kpa)], float))
    first_gaps = np.cumsum([0] + [segment.gaps for segment in arm.segments[:-1]])
    unloaded = unloaded.reshape(len(unloaded), -1, 3)[:, first_gaps].reshape(len(unloaded), -1)
    before = np.vstack([predicted[:1], predicted[:-2]])
    x = np.hstack([pressure[:-1], pressure[1:], predicted[:-1], unloaded[1:], predicted[:-1] - before])
    x = (x - file["normalisation.input.offset"]) * file["normalisation.input.scale"]
    *inner, (weight, bias) = file.layers()
    for w, b in inner:
        x = np.maximum(x @ w.T + b, 0.0)
    gates = 1.0 / (1.0 + np.exp(-(x @ weight.T + bias)[:, predicted.shape[1]:]))
    return np.hstack([x, np.ones((len(x), 1))]), gates


def last_layer(arm, file, minute, ridge):
    """Each number of the change has its own least squares: what a change of its weights does in a frame decays with
    the gate in those after it."""
    name = f"layers.{len(file.layers()) - 1}"
    scale = file["normalisation.output.scale"]
    for _ in range(ROUNDS):
        model = file.changed({})
        forward = limber.ForwardModel(arm, model)
        slopes, errors = [], []
        for window in windows_of(minute):
            backbones = np.asarray(limber.predict(forward, window, limber.Restart.at_the_start_only), float)
            backbones[0] = window.backbone[0]
            predicted = gap_poses(backbones)
            read, gates = read_by_last_layer(arm, file, window, predicted)
            slope = np.zeros((predicted.shape[1], read.shape[1]))
            for row, gate in zip(read, gates, strict=True):
                slope = (1.0 - gate)[:, None] * slope + row
                slopes.append(slope)
            errors.append((gap_poses(np.asarray(window.backbone, float)) - predicted)[1:] * scale)
        slopes = np.ascontiguousarray(np.transpose(slopes, (1, 2, 0)), np.float32)
        errors = np.concatenate(errors)
        change = np.linalg.solve(slopes @ np.swapaxes(slopes, 1, 2) + ridge * np.eye(slopes.shape[1]),
                                 (slopes @ errors.T[..., None].astype(np.float32)))[..., 0]
        weight, bias = file[f"{name}.weight"].copy(), file[f"{name}.bias"].copy()
        weight[:len(change)] += change[:, :-1]
        bias[:len(change)] += change[:, -1]
        model = file.changed({f"{name}.weight": weight, f"{name}.bias": bias})
        file = ModelFile(file.scratch)
    return model


def low_rank(arm, file, minute, freedom):
    layers = file.layers()
    parts = [np.linalg.svd(weight, full_matrices=False) for weight, _ in layers]
    each = file["family.columns"].shape[1] // len(layers)
    windows = windows_of(minute)
    weight_of_a_number = 1.0 / np.sqrt(INDEPENDENT_FRAMES * (arm.point_count - 1))

    def model(z):
        return file.changed({
            f"layers.{k}.weight": weight + (u[:, :each] * (s[:each] * freedom * z[k * each:(k + 1) * each])) @ v[:each]
            for k, ((weight, _), (u, s, v)) in enumerate(zip(layers, parts, strict=True))})

    def offsets(z):
        forward = limber.ForwardModel(arm, model(z))
        off = [np.asarray(limber.predict(forward, window, limber.Restart.at_the_start_only))[1:, 1:, :2]
               - np.asarray(window.backbone)[1:, 1:, :2] for window in windows]
        return np.nan_to_num(np.concatenate(off), nan=1.0).reshape(-1, 2)

    def weighted(off, scale):
        """Errors beyond PLACE_M count by their length, in units of the mean error: as e's."""
        length = np.maximum(np.linalg.norm(off, axis=1), PLACE_M)
        return weight_of_a_number / np.sqrt(scale * length)

    z = np.zeros(each * len(layers))
    off, damping = offsets(z), 1e-3
    for _ in range(ITERATIONS):
        scale = np.linalg.norm(off, axis=1).mean()
        step = STEP / freedom
        slope = np.stack([(offsets(z + step * unit) - off) / step for unit in np.eye(len(z))], axis=-1)
        weight = weighted(off, scale)[:, None]
        jacobian = (weight[..., None] * slope).reshape(-1, len(z))
        gradient = jacobian.T @ (weight * off).ravel() + z
        precision = jacobian.T @ jacobian + np.eye(len(z))

        def cost(off, z, scale=scale):
            length = np.linalg.norm(off, axis=1)
            loss = np.where(length < PLACE_M, 0.5 * length**2 / PLACE_M, length - 0.5 * PLACE_M)
            return weight_of_a_number**2 * loss.sum() / scale + 0.5 * z @ z

        while damping < 1e4:
            tried = z - np.linalg.solve(precision + damping * np.trace(precision) / len(z) * np.eye(len(z)), gradient)
            there = offsets(tried)
            if cost(there, tried) < cost(off, z):
                z, off, damping = tried, there, 0.1 * damping
                break
            damping *= 10.0
        else:
            break
    return model(z)


def best_last_layer(family, file, minute):
    """With the ridge that is best on the last fifth."""
    split = int(0.8 * len(minute.time_s))
    first, last = piece(minute, 0, split), piece(minute, split, 10**9)
    best = min(RIDGES, key=lambda ridge: family.error_cm(last_layer(family.arm, file, first, ridge), last))
    return last_layer(family.arm, file, minute, best)


def errors(family, minute, test):
    found = {"not adapted": family.error_cm(family.family, test)}
    file = ModelFile(family.copy)
    with_e = limber.adapt(family.arm, family.family, [minute], train_weights=False, jobs=1).model
    found["e"] = family.error_cm(with_e, test)
    begun = time.monotonic()
    found["last layer"] = family.error_cm(best_last_layer(family, file, minute), test)
    found["low rank"] = family.error_cm(low_rank(family.arm, file, minute, FREEDOM), test)
    print(", ".join(f"{name} {error:.2f}" for name, error in found.items()), f"({time.monotonic() - begun:.0f} s)",
          flush=True)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limber", type=pathlib.Path, default="build/release/bin/limber")
    parser.add_argument("--family", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--arm", default="three_segment")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--arms", type=int, default=12)
    parser.add_argument("--vary-physics", default="wide")
    options = parser.parse_args()
    family = Family(options)
    family.copy = options.out / "family.safetensors"
    family.copy.write_bytes(options.family.read_bytes())
    rows = family.parts.kept("ways", lambda: [
        errors(family, piece(minute, 0, 60 * FRAME_RATE_HZ), piece(test, 0, 100 * FRAME_RATE_HZ))
        for minute, test in family.minute_and_test("ways", options.seed, options.arms, "--arm", options.arm,
                                                   "--vary-physics", options.vary_physics)])
    print("| way | median; 90 % |\n|---|---|")
    for name in rows[0]:
        print(f"| {name} | {both([row[name] for row in rows])} |")


if __name__ == "__main__":
    main()
