"""What a driver of an arm has to do."""

from __future__ import annotations

import abc
from typing import TYPE_CHECKING

from ._limber import ArmState, ProcessDriver, VirtualArm

if TYPE_CHECKING:  # numpy.typing alone takes a tenth of the import
    import numpy as np
    import numpy.typing as npt


class ArmDriver(abc.ABC):
    """An arm that takes set points frame by frame, simulated in this process.

    Laws: `state().time_s` grows by one frame period with each `command`; no driver passes on a set
    point beyond the arm's limits; after `vent` every set point is zero. Hardware belongs behind a
    process of its own: valves must close, whatever becomes of the notebook.
    """

    @abc.abstractmethod
    def state(self) -> ArmState:
        """The latest state; before the first command, the arm at its start."""

    @abc.abstractmethod
    def command(self, setpoint_kpa: npt.NDArray[np.float32]) -> ArmState:
        """Commands set points (n,) [kPa], lets one frame pass and returns the state after it."""

    @abc.abstractmethod
    def vent(self) -> None:
        """Opens every vent valve; safe to call at any time, more than once."""


    def __repr__(self) -> str:
        return f"{type(self).__name__}(an ArmDriver)"


ArmDriver.register(VirtualArm)
ArmDriver.register(ProcessDriver)
