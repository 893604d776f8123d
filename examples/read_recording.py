#!/usr/bin/env python3
"""Reads a limber recording with h5py: what it holds, and where the end effector went.

    python3 examples/read_recording.py out/train.h5
"""

import sys

import h5py
import numpy as np

COMMANDS = ("pressure_kpa", "command", "setpoint_kpa", "command_setpoint")


def main(path):
    with h5py.File(path, "r") as file:
        about = file.attrs
        name = about["arm_name"]
        name = name.decode() if isinstance(name, bytes) else name  # of fixed length: bytes
        episodes = [file["episodes"][name] for name in sorted(file["episodes"])]
        frames = sum(len(episode["time_s"]) for episode in episodes)
        untracked = sum(int(np.sum(episode["tracked"][:] == 0)) for episode in episodes
                        if "tracked" in episode)  # left out: all are tracked
        channels = f"{about['chambers']} chambers" if "chambers" in about else f"{about['segments']} segments"
        print(f"arm '{name}', {channels}, {about['points']} points, {about['rate_hz']:g} Hz")
        print(f"{len(episodes)} episodes, {frames} frames, {untracked} of them not tracked")
        for number, episode in enumerate(episodes[:5]):
            # frames × [x_m, y_m, theta_rad]; in space [x_m, y_m, z_m, qx, qy, qz, qw]
            tip = episode["backbone"][-1, -1, :]
            place = ", ".join(f"{m:.3f} m" for m in tip[:3 if len(tip) == 7 else 2])
            heading = f", {tip[2]:.2f} rad" if len(tip) == 3 else ""
            # As measured; else what was commanded.
            data = next(episode[one] for one in COMMANDS if one in episode)
            unit = data.attrs.get("unit", "kPa")
            unit = unit.decode() if isinstance(unit, bytes) else unit
            peak = ", ".join(f"{p:.1f}" for p in np.abs(data[:]).max(axis=0))
            print(f"episode {number}: {place}{heading} at its end; largest {data.name.split('/')[-1]} {peak} {unit}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: read_recording.py RECORDING.h5")
    main(sys.argv[1])
