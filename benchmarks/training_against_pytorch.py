#!/usr/bin/python3
"""Times an epoch of training in limber and in PyTorch: the same recording, network, windows, batches,
optimiser and first weights, in one run. Needs Debian's python3-torch and python3-numpy.

    limber collect --schedule transitions --out train.h5
    benchmarks/training_against_pytorch.py build/release/bin/limber train.h5

PyTorch gets the normalised tables and the windows' order that limber itself starts from, and the mean
loss of the first epoch must agree before a time is believed. Both are timed epoch about, and the
median counts. PyTorch is asked for one and for two threads, eagerly and as a traced graph; its
fastest is what limber is compared with. Debian's PyTorch multiplies with whatever BLAS is installed:
with the reference one (libblas3) it is many times slower than it could be, so a comparison that is
to mean something needs libopenblas0-pthread.
"""

import argparse
import ctypes
import json
import math
import pathlib
import statistics
import struct
import subprocess
import tempfile
import time

import numpy
import torch

AGREEMENT = 2e-3  # relative, of the first epoch's mean losses: float32 sums in other orders


def blas():
    """OpenBLAS, where it is what PyTorch multiplies with; else None."""
    library = ctypes.CDLL("libblas.so.3")
    return library if hasattr(library, "openblas_set_num_threads") else None


def set_threads(count):
    torch.set_num_threads(count)
    if blas():
        blas().openblas_set_num_threads(count)


def read_safetensors(path):
    """The tensors and the metadata of a safetensors file (Debian has no reader)."""
    content = pathlib.Path(path).read_bytes()
    (length,) = struct.unpack_from("<Q", content)
    header = json.loads(content[8 : 8 + length])
    metadata = header.pop("__metadata__")
    tensors = {}
    for name, entry in header.items():
        begin, end = (8 + length + offset for offset in entry["data_offsets"])
        values = numpy.frombuffer(content[begin:end], dtype="<f4").reshape(entry["shape"])
        tensors[name] = torch.from_numpy(values.copy())
    return tensors, metadata


def chained_error(states, target, tables):
    """FrameError, chained: gap poses to poses about the base, compared with the recorded ones."""
    gap = states * tables["error.scale"][0] + tables["error.offset"][0]
    gap = gap.view(*states.shape[:-1], -1, 3)
    theta = gap[..., 2].cumsum(-1)
    heading = theta - gap[..., 2]
    cosine, sine = heading.cos(), heading.sin()
    x = (cosine * gap[..., 0] - sine * gap[..., 1]).cumsum(-1)
    y = (sine * gap[..., 0] + cosine * gap[..., 1]).cumsum(-1)
    poses = torch.stack([x, y, theta], -1).flatten(-2)
    return ((poses - target).abs() * tables["error.weight"][0]).sum()


def entry_error(states, target, tables):
    return ((states - target).abs() * tables["error.weight"][0]).sum()


def rollout_loss(frames, gated, given, state, change, uncompensated, target, tables, layers):
    """Sum over a batch's windows of their errors. `given`: what an input holds besides the backbone
    and its change, which has no columns where the network reads no velocities."""
    segments = tables["pressure"].shape[1]
    scale = tables["output_scale"][0]
    states = []
    for k in range(frames):
        x = torch.cat([given[k][:, : 2 * segments], state, given[k][:, 2 * segments :], change], 1)
        for weight, bias in layers[:-1]:
            x = torch.relu(torch.nn.functional.linear(x, weight, bias))
        output = torch.nn.functional.linear(x, *layers[-1])
        before = state
        if gated:
            added, gate = output.chunk(2, 1)
            pulled = torch.lerp(state, uncompensated[k], gate.sigmoid())
            state = torch.addcmul(pulled, added, scale)
        else:
            state = torch.addcmul(uncompensated[k], output, scale)
        if "change_scale" in tables:
            change = (state - before) * tables["change_scale"][0]
        states.append(state)
    error = chained_error if "error.scale" in tables else entry_error
    return error(torch.stack(states), target, tables) / frames


class Peer:
    """One network and its optimiser, trained the way limber does it."""

    def __init__(self, tables, metadata, stage, frames, batch, traced):
        self.tables, self.frames, self.batch = tables, frames, batch
        self.starts = tables[f"starts.{stage}"].flatten().long()
        self.mean = metadata["reduction"] == "mean"
        self.gated = metadata["output_form"] == "gated_change"
        self.limit = float(metadata["gradient_norm_limit"])
        count = sum(name.endswith(".weight") and name.startswith("layers.") for name in tables)
        self.parameters = [
            tables[f"layers.{l}.{part}"].squeeze(0).clone().requires_grad_()
            for l in range(count)
            for part in ("weight", "bias")
        ]
        kind = {"adam": torch.optim.Adam, "sgd": torch.optim.SGD}[metadata["optimiser"]]
        # `foreach` takes all parameters in one call, which is faster.
        self.optimiser = kind(self.parameters, lr=float(metadata["learning_rate"]), foreach=True)
        self.graph = None
        if traced:
            example = (*self.gather(self.starts[:batch]), *self.parameters)
            self.graph = torch.jit.trace(self.loss, example, check_trace=False)

    def gather(self, starts):
        tables = self.tables
        index = starts[None, :] + torch.arange(self.frames)[:, None]
        given = torch.cat(
            [tables["pressure"][index], tables["pressure"][index + 1], tables["no_load"][index + 1]], 2
        )
        state = tables["state"][starts]
        return (
            given,
            state,
            tables["change"][starts] if "change" in tables else state[:, :0],
            tables["uncompensated"][index + 1],
            tables["target"][index + 1],
        )

    def loss(self, given, state, change, uncompensated, target, *parameters):
        layers = list(zip(parameters[::2], parameters[1::2]))
        return rollout_loss(
            self.frames, self.gated, given, state, change, uncompensated, target, self.tables, layers
        )

    def epoch(self):
        total = 0.0
        for starts in self.starts.split(self.batch):
            batch = self.gather(starts)
            whole = self.graph is not None and len(starts) == self.batch
            loss = (self.graph if whole else self.loss)(*batch, *self.parameters)
            self.optimiser.zero_grad(set_to_none=True)
            (loss / len(starts) if self.mean else loss).backward()
            if self.limit > 0:
                torch.nn.utils.clip_grad_norm_(self.parameters, self.limit)
            self.optimiser.step()
            total += loss.item()
        return total / len(self.starts)


def timed(peer):
    begin = time.perf_counter()
    peer.epoch()
    return time.perf_counter() - begin


def compare(limber, recording, preset, epochs, tables_path):
    command = [limber, "bench", "--quiet", "--json", "--training", recording, "--preset", preset,
               "--tables", tables_path, "--force"]
    subprocess.run([*command, "--epochs", "1"], check=True, stdout=subprocess.DEVNULL)
    tables, metadata = read_safetensors(tables_path)

    def measure_limber():
        output = subprocess.run(
            [*command, "--epochs", str(epochs)], check=True, stdout=subprocess.PIPE
        )
        return json.loads(output.stdout)["training"][0]

    before = measure_limber()
    rows = []
    for k, stage in enumerate(before["stages"]):
        variants = {}
        for threads in (1, 2):
            for traced in (False, True):
                set_threads(threads)
                peer = Peer(
                    tables, metadata, k, stage["window_frames"], stage["windows_per_batch"], traced
                )
                loss = peer.epoch()
                if not math.isclose(loss, stage["first_epoch_loss"], rel_tol=AGREEMENT):
                    raise SystemExit(
                        f"preset {preset}, stage {k}: PyTorch's loss after one epoch is {loss}, "
                        f"limber's {stage['first_epoch_loss']}: they don't train the same"
                    )
                timed(peer)
                name = f"{threads} thread{'s' if threads > 1 else ''}{', traced' if traced else ''}"
                variants[name] = statistics.median(timed(peer) for _ in range(epochs))
        rows.append((stage, variants))
    after = measure_limber()
    for (stage, variants), again in zip(rows, after["stages"]):
        limber_s = statistics.mean([stage["epoch_s"], again["epoch_s"]])
        name, best = min(variants.items(), key=lambda item: item[1])
        times = ", ".join(f"{key} {1e3 * value:.0f}" for key, value in variants.items())
        print(
            f"{preset}, {before['shape']}, windows of {stage['window_frames']}, batches of "
            f"{stage['windows_per_batch']}, {stage['windows']} windows:\n"
            f"  limber {1e3 * limber_s:.1f} ms an epoch ({before['threads']} threads, "
            f"{50 * (stage['fraction_of_fma_peak'] + again['fraction_of_fma_peak']):.0f} % of the "
            f"FMA peak)\n"
            f"  PyTorch {torch.__version__} with {'OpenBLAS' if blas() else 'the reference BLAS'}, ms: "
            f"{times}\n"
            f"  limber is {best / limber_s:.1f} times as fast as PyTorch's best ({name})",
            flush=True,
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("limber", help="the program, such as build/release/bin/limber")
    parser.add_argument("recording", help="recording to train on")
    parser.add_argument("--preset", choices=["paper", "best"], help="else both")
    parser.add_argument("--epochs", type=int, default=5, help="timed of each (default: 5)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for preset in [arguments.preset] if arguments.preset else ["paper", "best"]:
            compare(
                arguments.limber, arguments.recording, preset, arguments.epochs,
                f"{folder}/tables.safetensors",
            )


if __name__ == "__main__":
    main()
