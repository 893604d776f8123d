"""What a controller has to do."""

from __future__ import annotations

import abc
from typing import TYPE_CHECKING

from ._limber import ArmEstimate, ClosedLoop, MotionModel

if TYPE_CHECKING:  # numpy.typing alone takes a tenth of the import
    import numpy as np
    import numpy.typing as npt


class Controller(abc.ABC):
    """Decides what an arm is sent, frame by frame, from where it is.

    The executor holds each answer against the arm's limits and its rate, sends it through the
    safety gate, and asks again after the frame. `model`, if it is set, is what the estimate
    predicts with.
    """

    model: MotionModel | None

    @abc.abstractmethod
    def step(self, arm: ArmEstimate) -> npt.NDArray[np.float32] | None:
        """Set points (n,) [kPa] of the next frame; None ends the run."""

    def __repr__(self) -> str:
        return f"{type(self).__name__}(a Controller)"


Controller.register(ClosedLoop)
