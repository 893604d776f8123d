"""A recording cut into windows, as a network needs them that learns on its own output."""

import limber
import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float32]


def windows(arm: limber.ArmDescription, recording: limber.Recording, frames: int) -> list[Floats]:
    """Pressures, backbones and no-load backbones of all windows: (frames + 1, windows, numbers)."""
    cut = []
    for episode in recording.episodes:
        q = episode.pressure_kpa
        free = limber.NoLoadModel(arm).backbone(q)
        row = np.concatenate([q, episode.backbone.reshape(len(q), -1), free.reshape(len(q), -1)], 1)
        cut += [row[k:k + frames + 1] for k in range(0, len(q) - frames, frames)]
    n, poses = arm.segment_count, 3 * arm.point_count
    return np.split(np.stack(cut, axis=1), [n, n + poses], axis=2)
