#!/usr/bin/env python3
"""Reads a limber recording with h5py: what it holds, and where the end effector went.

    python3 examples/read_recording.py out/train.h5
"""

import sys

import h5py
import numpy as np


def main(path):
    with h5py.File(path, "r") as file:
        about = file.attrs
        name = about["arm_name"]
        name = name.decode() if isinstance(name, bytes) else name  # of fixed length: bytes
        episodes = [file["episodes"][name] for name in sorted(file["episodes"])]
        frames = sum(len(episode["time_s"]) for episode in episodes)
        untracked = sum(int(np.sum(episode["tracked"][:] == 0)) for episode in episodes)
        print(
            f"arm '{name}', {about['segments']} segments,"
            f" {about['points']} points, {about['rate_hz']:g} Hz"
        )
        print(f"{len(episodes)} episodes, {frames} frames, {untracked} of them not tracked")
        for number, episode in enumerate(episodes[:5]):
            tip = episode["backbone"][:, -1, :]  # frames × [x_m, y_m, theta_rad]
            peak = np.abs(episode["pressure_kpa"][:]).max(axis=0)
            print(
                f"episode {number}: {tip[-1, 0]:.3f} m, {tip[-1, 1]:.3f} m,"
                f" {tip[-1, 2]:.2f} rad at its end; highest pressures"
                f" {', '.join(f'{p:.1f}' for p in peak)} kPa"
            )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: read_recording.py RECORDING.h5")
    main(sys.argv[1])
