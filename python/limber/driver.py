"""Drivers in Python, each in a process of its own (docs/driver.md has the protocol).

    class Mine(limber.driver.Driver):
        rate_hz, segment_count = 20.0, 3
        def command(self, setpoint_kpa): ...
        def vent(self): ...

    if __name__ == "__main__":
        limber.driver.serve(Mine())

A busy notebook, a breakpoint in it or its end can't hold valves open: the driver vents at the end
of its input, and when no `set` came for three frames.
"""

from __future__ import annotations

import abc
import contextlib
import json
import os
import selectors
import signal
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from types import FrameType
from typing import Any, BinaryIO, Optional, Union

import numpy as np
import numpy.typing as npt

from ._limber import ArmState

__all__ = ["Driver", "serve"]

PROTOCOL = 1
SILENT_FRAMES = 3  # without another `set`, then it vents
LONGEST_LINE = 1 << 20  # bytes


class Driver(abc.ABC):
    """What moves an arm. Its attributes are what `hello` says of it."""

    name: str = "limber.driver"
    device: str = ""  # what the device speaks
    rate_hz: float = 20.0  # frames per second: the arm's
    segment_count: int = 0
    tracked: bool = True  # whether states carry backbones
    real_time: bool = True  # False for a simulation
    #: Own limits, one per segment: a number for both sides, or (lower, upper).
    limit_kpa: Optional[Sequence[Union[float, tuple[float, float]]]] = None

    def __repr__(self) -> str:
        return (f"{type(self).__name__}(name={self.name!r}, rate_hz={self.rate_hz}, "
                f"segment_count={self.segment_count})")

    @abc.abstractmethod
    def command(self, setpoint_kpa: npt.NDArray[np.float32]) -> ArmState:
        """Hands set points (n,) [kPa] to the device, and returns its newest sample at once: with
        the set points that were in force when it was taken, ArmState(..., setpoint_kpa=...)."""

    @abc.abstractmethod
    def vent(self) -> ArmState:
        """Opens every vent valve and returns the newest sample; called more than once."""

    def bodies(self) -> Optional[npt.ArrayLike]:
        """What a tracker that sees in 3D says of the sample returned last, (m, 7) rows x, y, z,
        qx, qy, qz, qw in its own frame and unit; by default None, and the sample's backbone counts.
        """
        return None


def _ranges(limits: Sequence[Union[float, tuple[float, float]]]) -> list[tuple[float, float]]:
    return [(float(one[0]), float(one[1])) if isinstance(one, (tuple, list))
            else (-float(one), float(one)) for one in limits]


class _Lines:
    """Lines of a pipe, with a limit to the time that is waited for one."""

    def __init__(self, pipe: BinaryIO) -> None:
        self._descriptor = pipe.fileno()
        self._selector = selectors.DefaultSelector()
        self._selector.register(self._descriptor, selectors.EVENT_READ)
        self._waiting = b""

    def next(self, deadline_s: Optional[float]) -> Optional[bytes]:
        """The next line; empty at the end of the input, None where time.monotonic() has passed the
        deadline."""
        while b"\n" not in self._waiting:
            if len(self._waiting) > LONGEST_LINE:
                return b""
            left_s = None if deadline_s is None else max(0.0, deadline_s - time.monotonic())
            if not self._selector.select(left_s):
                return None
            read = os.read(self._descriptor, 1 << 16)
            if not read:
                return b""
            self._waiting += read
        line, self._waiting = self._waiting.split(b"\n", 1)
        return line + b"\n"


def _numbers(values: npt.ArrayLike) -> Any:
    array = np.asarray(values, dtype=float)
    if not np.isfinite(array).all():
        raise ValueError("the driver returned a number that is not finite")
    return array.tolist()


class _Server:
    def __init__(self, driver: Driver, output: BinaryIO) -> None:
        self._driver = driver
        self._output = output
        self._frame_s = 1.0 / driver.rate_hz

    def run(self, lines: _Lines) -> None:
        vent_at_s: Optional[float] = None
        while True:
            line = lines.next(vent_at_s)
            if line is None:
                self._driver.vent()
                vent_at_s = None
                continue
            if not line:
                return
            message = json.loads(line)
            kind = message.get("type")
            if kind == "bye":
                return
            try:
                self._answer(kind, message)
                if kind == "set":
                    vent_at_s = time.monotonic() + SILENT_FRAMES * self._frame_s
                elif kind == "vent":
                    vent_at_s = None
            except Exception as error:  # the device's failure, whatever it is: vented and told
                vent_at_s = None
                self._driver.vent()
                self._say({"type": "fault", "message": f"{type(error).__name__}: {error}"})

    def _answer(self, kind: Optional[str], message: dict[str, Any]) -> None:
        if kind == "hello":
            self._say(self._hello())
        elif kind == "set":
            setpoint_kpa = np.asarray(message["pressure_kpa"], dtype=np.float32)
            if setpoint_kpa.shape != (self._driver.segment_count,):
                raise ValueError(f"{setpoint_kpa.size} set points; the arm has "
                                 f"{self._driver.segment_count} segments")
            if not np.isfinite(setpoint_kpa).all():
                raise ValueError(f"set points {setpoint_kpa.tolist()} kPa: not finite")
            self._refuse_beyond_limits(setpoint_kpa)
            self._state(self._driver.command(setpoint_kpa), message)
        elif kind == "vent":
            self._state(self._driver.vent(), message)

    def _refuse_beyond_limits(self, setpoint_kpa: npt.NDArray[np.float32]) -> None:
        limits = self._driver.limit_kpa
        if limits is None:
            return
        lower, upper = np.transpose(_ranges(limits))
        room = np.maximum(1e-3, 1e-5 * np.maximum(-lower, upper))  # as limber looks at plans before a run
        if not ((setpoint_kpa >= lower - room) & (setpoint_kpa <= upper + room)).all():
            raise ValueError(f"set points {setpoint_kpa.tolist()} kPa are beyond the driver's "
                             f"limits {list(limits)}")

    def _hello(self) -> dict[str, Any]:
        driver = self._driver
        said = {"type": "hello", "protocol": PROTOCOL, "driver": driver.name,
                "device": driver.device, "rate_hz": driver.rate_hz,
                "segments": driver.segment_count, "tracked": driver.tracked,
                "real_time": driver.real_time}
        if driver.limit_kpa is not None:
            ranges = _ranges(driver.limit_kpa)
            said["limit_kpa"] = [max(-lower, upper) for lower, upper in ranges]
            if any(lower != -upper for lower, upper in ranges):
                said["limits_kpa"] = ranges
        return said

    def _state(self, state: ArmState, message: dict[str, Any]) -> None:
        bodies, backbone = self._driver.bodies(), state.backbone
        said = {"type": "state", "seq": message.get("seq"), "t": state.time_s,
                "pressure_kpa": _numbers(state.pressure_kpa)}
        if state.setpoint_kpa is not None:
            said["setpoint_kpa"] = _numbers(state.setpoint_kpa)
        if state.tracker_t is not None:
            said["tracker_t"] = state.tracker_t
        if bodies is not None:
            said["bodies"] = _numbers(bodies)
        else:
            said["backbone"] = None if backbone is None else _numbers(backbone)
        self._say(said)

    def _say(self, message: dict[str, Any]) -> None:
        self._output.write(json.dumps(message).encode() + b"\n")
        self._output.flush()


@contextlib.contextmanager
def _handled(handler: Any, *numbers: signal.Signals) -> Iterator[None]:
    """Signals go to `handler`; only a program's main thread may say so, and gets them."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, handler) for number in numbers}
    try:
        yield
    finally:
        for number, own in before.items():
            signal.signal(number, own)


def _leave(number: int, frame: Optional[FrameType]) -> None:
    """SIGTERM ends the program through its `finally`s, so that the arm is vented; once."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(1)


def serve(driver: Driver, input: Optional[BinaryIO] = None,
          output: Optional[BinaryIO] = None) -> None:
    """Answers limber on standard input and output until the input ends; vents however it ends.

    What the driver prints goes to standard error meanwhile.
    """
    if driver.segment_count < 1:
        raise ValueError(f"{type(driver).__name__}.segment_count = {driver.segment_count}; "
                         "expected the arm's number of segments")
    lines = _Lines(input or sys.stdin.buffer)
    server = _Server(driver, output or sys.stdout.buffer)
    with contextlib.redirect_stdout(sys.stderr), _handled(_leave, signal.SIGTERM):
        try:
            server.run(lines)
        finally:
            # Whoever is in a hurry must not leave valves open: this vent is not cut short.
            with _handled(signal.SIG_IGN, signal.SIGINT, signal.SIGTERM):
                driver.vent()
