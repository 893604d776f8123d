"""limber: learn, simulate and plan the motion of soft pneumatic arms.

Names, units and frames are those of the C++ library. Arrays are NumPy's: a C-contiguous float32
array is not copied, anything else is copied once. n: segments, m: plates along the backbone,
k: queries of a batch, T: frames.
"""

from __future__ import annotations

import os
import pathlib

from ._limber import *  # noqa: F401,F403
from ._limber import SystemFault, __version__
from .arm_driver import ArmDriver


def data_folder() -> pathlib.Path:
    """Where the arms and environments lie that limber comes with.

    LIMBER_DATA_DIR where that is set; the package's own, the source tree's, or the installed ones.
    """
    chosen = os.environ.get("LIMBER_DATA_DIR")
    here = pathlib.Path(__file__).resolve().parent
    candidates = [here / "data", *(parent / "share" / "limber" for parent in here.parents),
                  *list(here.parents)[:4]]
    if chosen:
        candidates = [pathlib.Path(chosen)]
    for candidate in candidates:
        if (candidate / "arms").is_dir() and (candidate / "environments").is_dir():
            return candidate
    raise SystemFault("limber's arms/ and environments/ were not found in: "
                      + " ".join(map(str, candidates)) + "; set LIMBER_DATA_DIR")
