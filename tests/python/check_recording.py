"""Prints a recording as h5py sees it; tests/data/recording_python_test.cpp compares."""

import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1], "r") as file:
    schema, name = (file.attrs[key].decode() for key in ("schema", "arm_name"))
    print(schema, name, file.attrs["rate_hz"], file.attrs["seed"])
    episodes = file["episodes"]
    first = episodes["000000"]
    print(
        f"{len(episodes)} episodes, backbone {first['backbone'].shape},"
        f" pressure {first['pressure_kpa'].shape},"
        f" units {first['backbone'].attrs['unit'].decode()} and"
        f" {first['pressure_kpa'].attrs['unit'].decode()}"
    )
    total = {
        name: sum(np.sum(episode[name][:], dtype=np.float64) for episode in episodes.values())
        for name in ("backbone", "pressure_kpa")
    }
    print(f"sums {total['backbone']:.9f} {total['pressure_kpa']:.9f}")
