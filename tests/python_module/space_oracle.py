"""Arms in space in NumPy and double precision, written from docs/model.md alone: quaternions are
x, y, z, w, a pose has 7 numbers, a gap 6. The first axis is that of the queries."""

import json
import struct

import numpy as np

LAYERS = "layers.{}.{}"


def product(a, b):
    av, aw, bv, bw = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    return np.concatenate([aw * bv + bw * av + np.cross(av, bv),
                           aw * bw - np.sum(av * bv, -1, keepdims=True)], -1)


def conjugate(q):
    return q * [-1, -1, -1, 1]


def rotated(q, v):
    """By the matrix of q, row by row."""
    x, y, z, w = np.moveaxis(q, -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    matrix = np.moveaxis(np.array(rows), (0, 1), (-2, -1))
    return np.einsum("...ij,...j->...i", matrix, v)


def rotation_of(omega):
    angle = np.linalg.norm(omega, axis=-1, keepdims=True)
    return np.concatenate([omega * np.sinc(angle / (2 * np.pi)) / 2, np.cos(angle / 2)], -1)


def rotation_vector(q):
    q = np.where(q[..., 3:] < 0, -q, q)
    sine = np.linalg.norm(q[..., :3], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(sine, q[..., 3:])
    return q[..., :3] * np.where(sine > 1e-12, angle / np.maximum(sine, 1e-12), 2.0)


def gaps_of(backbones):
    """(k, m, 7) to (k, m - 1, 6)."""
    backbones = np.asarray(backbones, np.float64)
    back = conjugate(backbones[:, :-1, 3:])
    d = rotated(back, backbones[:, 1:, :3] - backbones[:, :-1, :3])
    return np.concatenate([d, rotation_vector(product(back, backbones[:, 1:, 3:]))], -1)


def chained(gaps):
    """The inverse, the base at the origin."""
    place, turn = np.zeros((len(gaps), 3)), np.tile([0.0, 0, 0, 1], (len(gaps), 1))
    plates = [np.concatenate([place, turn], -1)]
    for g in range(gaps.shape[1]):
        place = place + rotated(turn, gaps[:, g, :3])
        turn = product(turn, rotation_of(gaps[:, g, 3:]))
        plates.append(np.concatenate([place, turn], -1))
    return np.stack(plates, 1)


def no_load_gaps(arm, commands):
    """(24) to (26): (k, n) to each segment's gap, (k, s, 6)."""
    commands = np.asarray(commands, np.float64)
    found, first = [], 0
    for segment in arm.segments:
        strains, places = [], []
        for chamber in segment.chambers:
            p = commands[:, first + len(strains)]
            strains.append(chamber.sense * sum(
                c * p ** (k + 1) for k, c in enumerate(chamber.strain_polynomial)))
            phi = np.radians(chamber.angle_deg)
            y, z = chamber.radius_m * np.cos(phi), chamber.radius_m * np.sin(phi)
            places.append([1.0, z, -y])
        first += len(strains)
        fit = np.linalg.lstsq(np.array(places), np.array(strains), rcond=None)[0]
        omega = np.zeros((len(commands), 3))
        omega[:, 1:] = segment.length_m / segment.gaps * fit[1:].T
        length = segment.length_m / segment.gaps * (1 + fit[0])
        t = np.linalg.norm(omega, axis=-1)[:, None]
        safe = np.maximum(t, 1e-6)
        a = np.where(t > 1e-4, (1 - np.cos(safe)) / safe**2, 0.5)
        b = np.where(t > 1e-2, (safe - np.sin(safe)) / safe**3, 1 / 6 - t * t / 120)
        along = np.tile([1.0, 0, 0], (len(commands), 1))
        turned = np.cross(omega, along)
        d = length[:, None] * (along + a * turned + b * np.cross(omega, turned))
        found.append(np.concatenate([d, omega], -1))
    return np.stack(found, 1)


def over_gaps(arm, of_segments):
    return np.repeat(of_segments, [segment.gaps for segment in arm.segments], axis=1)


def read_tensors(path):
    """Tensors of a safetensors file, in double, and its metadata."""
    content = path.read_bytes()
    (length,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8:8 + length])
    metadata = header.pop("__metadata__")
    data = content[8 + length:]
    return {name: np.frombuffer(data[slice(*entry["data_offsets"])], "<f4")
            .reshape(entry["shape"]).astype(np.float64) for name, entry in header.items()}, metadata


def tighten_bounds(path, share=0.02):
    """Moves the bounds of the model file to this share of their range, so that they hold gaps."""
    content = bytearray(path.read_bytes())
    (length,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8:8 + length])

    def part(name):
        return slice(*(8 + length + offset for offset in header[name]["data_offsets"]))

    def numbers(name):
        return np.frombuffer(bytes(content[part(name)]), "<f4")

    for what in ("length", "turn"):
        low, high = numbers(f"bounds.{what}.min"), numbers(f"bounds.{what}.max")
        middle, half = (low + high) / 2, share * (high - low) / 2
        content[part(f"bounds.{what}.min")] = (middle - half).astype("<f4").tobytes()
        content[part(f"bounds.{what}.max")] = (middle + half).astype("<f4").tobytes()
    content[part("bounds.bend.max")] = (numbers("bounds.bend.max") / 3).astype("<f4").tobytes()
    path.write_bytes(bytes(content))


def query_of(arm, previous_kpa, current_kpa, previous, before):
    """What the network is asked, in kPa, m and rad. Past commands stand behind the latest."""
    k, n = len(previous), arm.channel_count
    gaps = gaps_of(previous)
    return np.concatenate([previous_kpa, current_kpa, gaps.reshape(k, -1),
                           no_load_gaps(arm, current_kpa[:, :n]).reshape(k, -1),
                           (gaps - gaps_of(before)).reshape(k, -1)], -1)


def answer_of(tensors, query):
    x = (query - tensors["normalisation.input.offset"]) * tensors["normalisation.input.scale"]
    count = sum(name.endswith(".bias") and name.startswith("layers.") for name in tensors)
    for layer in range(count):
        x = x @ tensors[LAYERS.format(layer, "weight")].T + tensors[LAYERS.format(layer, "bias")]
        x = np.maximum(x, 0) if layer + 1 < count else x
    size = len(tensors["normalisation.output.scale"])
    x[:, :size] = x[:, :size] / tensors["normalisation.output.scale"]
    return x


def bounded(tensors, gaps):
    """(20) in space, and the share of gaps that it holds."""
    length = np.linalg.norm(gaps[..., :3], axis=-1)
    kept = np.clip(length, tensors["bounds.length.min"], tensors["bounds.length.max"])
    twist = np.clip(gaps[..., 3], tensors["bounds.turn.min"], tensors["bounds.turn.max"])
    bend = np.linalg.norm(gaps[..., 4:], axis=-1)
    bent = np.minimum(bend, tensors["bounds.bend.max"])
    result = np.concatenate([gaps[..., :3] * (kept / length)[..., None], twist[..., None],
                             gaps[..., 4:] * (bent / np.maximum(bend, 1e-30))[..., None]], -1)
    held = [np.mean(kept != length), np.mean(twist != gaps[..., 3]), np.mean(bent != bend)]
    return result, held


def next_gaps(arm, tensors, query, answer):
    """(16) and (20): (k, m - 1, 6), and the shares of gaps whose length, twist and bend are held."""
    size = len(tensors["normalisation.output.scale"])
    first = query.shape[1] - 2 * size - 6 * arm.segment_count
    previous = query[:, first:first + size].reshape(len(query), -1, 6)
    no_load = query[:, first + size:first + size + 6 * arm.segment_count]
    no_load = over_gaps(arm, no_load.reshape(len(query), -1, 6))
    change = answer[:, :size].reshape(previous.shape)
    gate = 1 / (1 + np.exp(-answer[:, size:].reshape(previous.shape)))
    return bounded(tensors, previous + change + gate * (no_load - previous))
