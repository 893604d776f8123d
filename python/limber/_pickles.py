"""Copies and pickles: of settings and other records by their fields; of arms, environments, models
and plans by what their files hold; of episodes, polygons and starts by their arrays. pickle and copy
raise TypeError for everything else."""

from __future__ import annotations

import pathlib
from typing import Any

from . import _limber

_READERS: dict[str, Any] = {"arm": _limber.load_arm_to_characterise, "environment": _limber.load_environment,
            "model": _limber.read_model, "plan": _limber.read_plan_unchecked}
_WRITERS: dict[str, Any] = {"arm": _limber.write_arm, "environment": _limber.write_environment,
            "model": _limber.write_model, "plan": _limber.write_plan}
_FILED = {_limber.ArmDescription: "arm", _limber.Environment: "environment",
          _limber.CompensationModel: "model", _limber.Plan: "plan"}
_ARGUMENTS = {_limber.Episode: ("time_s", "pressure_kpa", "setpoint_kpa", "backbone", "motion_index",
                               "tracked", "setpoints_only", "physics", "lifted", "log"),
              _limber.Polygon: ("points_m",), _limber.ArmStart: ("pressures_kpa", "backbone")}


def _of_class(self: Any, table: dict[Any, Any]) -> Any:
    """What a table of limber's classes says of one, or of a class derived from it."""
    return next(table[kind] for kind in type(self).__mro__ if kind in table)


def _from_fields(kind: type, fields: dict[str, Any]) -> Any:
    return kind(**fields)


def _from_file(kind: str, data: bytes) -> Any:
    import tempfile  # what few need
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / f"pickled {kind}"
        path.write_bytes(data)
        return _READERS[kind](path)


def _reduce_filed(self: Any, _protocol: int) -> tuple[Any, ...]:
    import tempfile
    kind = _of_class(self, _FILED)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / f"pickled {kind}"
        _WRITERS[kind](path, self)
        data = path.read_bytes()
    return _from_file, (kind, data)


def _reduce_record(self: Any, _protocol: int) -> tuple[Any, ...]:
    kind: Any = next(one for one in type(self).__mro__ if "_fields" in vars(one))
    usual = kind()
    fields = {name: getattr(self, name) for name in kind._fields}
    return _from_fields, (kind, {name: value for name, value in fields.items()
                                 if value != getattr(usual, name)})


def _reduce_arguments(self: Any, _protocol: int) -> tuple[Any, ...]:
    return type(self), tuple(getattr(self, name) for name in _of_class(self, _ARGUMENTS))


def _reduce_enum(self: Any, _protocol: int) -> tuple[Any, ...]:
    return type(self), (int(self),)


def _reduce(self: Any) -> Any:
    return self.__reduce_ex__(2)


for _kind in list(vars(_limber).values()):
    if not isinstance(_kind, type):
        continue
    if _kind in _FILED:
        _own = _reduce_filed
    elif hasattr(_kind, "_fields"):
        _own = _reduce_record
    elif hasattr(_kind, "__members__"):
        _own = _reduce_enum
    elif _kind in _ARGUMENTS:
        _own = _reduce_arguments
    else:
        continue
    setattr(_kind, "__reduce_ex__", _own)
    setattr(_kind, "__reduce__", _reduce)
