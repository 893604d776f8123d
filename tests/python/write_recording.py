"""Writes a recording by h5py alone, double precision and without the optional parts."""

import sys

import h5py
import numpy as np

FRAMES, SEGMENTS, POINTS = 4, 1, 3

with h5py.File(sys.argv[1], "w") as file:
    file.attrs["schema"] = "limber/recording/1"
    file.attrs["arm_name"] = "from python"
    file.attrs["arm_hash"] = ""
    file.attrs["source"] = "h5py"
    file.attrs["program_version"] = "none"
    file.attrs["rate_hz"] = 20
    file.attrs["segments"] = SEGMENTS
    file.attrs["points"] = POINTS
    file.attrs["seed"] = 0
    episode = file.create_group("episodes/000000")
    episode["time_s"] = np.arange(FRAMES) / 20
    episode["pressure_kpa"] = np.arange(FRAMES).reshape(FRAMES, SEGMENTS) * 10.0
    episode["setpoint_kpa"] = np.zeros((FRAMES, SEGMENTS))
    backbone = np.zeros((FRAMES, POINTS, 3))
    backbone[2, 1, 2] = 0.5
    episode["backbone"] = backbone
    episode["motion_index"] = np.zeros(FRAMES, dtype=np.int64)
