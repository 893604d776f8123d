"""Writes limber/_limber.pyi and a page of all public names from the built module, as a step of its build:
signatures and texts are those of its docstrings, so that neither can be forgotten.

    (cd build/release/python && PYTHONPATH=. python3 ../../../tools/python_stubs.py limber/_limber.pyi names.md)
"""

import argparse
import pathlib
import re

# What pybind11 can't know: functions and sequences that cross the border as objects.
PARAMETERS = {
    "out": "npt.NDArray[np.float32] | None",
    "callback": "Callable[[PlannerProgress], bool | None] | None",
    "on_epoch": "Callable[[LearningCurvePoint], bool | None] | None",
    "make_driver": "DriverFactory | ProcessDriver | Callable[[int], ArmDriver]",
    "driver": "ArmDriver | ProcessDriver | VirtualArm",
    "controller": "ClosedLoop | Controller | None",
    "on_message": "Callable[[str], None] | None",
    "episodes": "Iterable[Episode]", "training": "Iterable[Episode]",
    "validation": "Iterable[Episode]", "replay": "Iterable[Episode]",
    "unseen": "Iterable[Episode]", "motion_index": "npt.ArrayLike", "tracked": "npt.ArrayLike | None",
}
RESULTS = {
    "Recording.episodes": "list[Episode]", "TrainingData.training": "list[Episode]",
    "TrainingData.validation": "list[Episode]", "TrainingData.replay": "list[Episode]",
    "TrainingData.unseen": "list[Episode]", "CompensationModel.layers": "list[Layer]",
    "ArmState.backbone": "npt.NDArray[np.float32] | None",
    "ArmState.setpoint_kpa": "npt.NDArray[np.float32] | None", "to_json": "dict[str, Any]",
    "ExecutionResult.final_backbone": "npt.NDArray[np.float32] | None",
    "ExecutionResult._repr_svg_": "str | None", "ProcessDriver.__enter__": "ProcessDriver",
    "ArmEstimate.rest": "npt.NDArray[np.float32] | None", "export_csv": "list[pathlib.Path]",
    "with_setpoints_only": "list[Episode]",
}
# Parameters that a name alone does not tell: (function, parameter).
EXCEPTIONS = {("certify", "network"): "CompensationModel | None",
              ("evaluate", "network"): "ForwardModel | None",
              ("__init__", "network"): "CompensationModel | None"}  # a Certifier's

HEADER = '''# Made by tools/python_stubs.py from the module's docstrings; do not edit.
import os
import pathlib
from typing import Any, Callable, Iterable, Iterator, Sequence, overload

import numpy as np
import numpy.typing as npt

from .arm_driver import ArmDriver
from .controller import Controller

__version__: str
'''
SIGNATURE = re.compile(r"^(?:\d+\. )?(\w+)\((.*)\) -> (.+)$")


def plain(text):
    """A pybind11 type in Python's words."""
    text = re.sub(r"limber\._limber\.", "", text)
    text = re.sub(r"float\[\d+\]", "float", text)
    text = re.sub(r"numpy\.ndarray\[(?:numpy\.)?(\w+)\]",
                  lambda m: f"npt.NDArray[np.{m[1].replace('bool', 'bool_')}]", text)
    text = text.replace("List[", "list[").replace("Dict[", "dict[").replace("Tuple[", "tuple[")
    text = text.replace("os.PathLike", "str | os.PathLike[str]").replace("object", "Any")
    text = re.sub(r"\biterable\b", "Iterable[Any]", text)
    while "Optional[" in text or "Union[" in text:
        text = unfold(text)
    return text


def unfold(text):
    """The first Optional or Union as A | B."""
    found = re.search(r"(Optional|Union)\[", text)
    depth, end = 1, found.end()
    while depth:
        depth += {"[": 1, "]": -1}.get(text[end], 0)
        end += 1
    inside = text[found.end():end - 1]
    parts = split(inside) if found[1] == "Union" else [inside, "None"]
    return text[:found.start()] + " | ".join(parts) + text[end:]


def split(text):
    """At the commas that stand in no bracket."""
    parts, depth, start = [], 0, 0
    for at, letter in enumerate(text):
        depth += (letter in "[(<") - (letter in "])>")
        if letter == "," and depth == 0:
            parts.append(text[start:at].strip())
            start = at + 1
    rest = text[start:].strip()
    return parts + [rest] if rest else parts


def parameter(text, function):
    """One parameter of a signature, as a stub has it."""
    if text.startswith("*") or ":" not in text:
        return text
    name, kind = text.split(":", 1)
    kind, _, default = (part.strip() for part in kind.partition(" = "))
    if name == "self":
        return "self"
    opaque = kind.lower() in ("object", "iterable")
    kind = EXCEPTIONS.get((function, name)) or (opaque and PARAMETERS.get(name)) or re.sub(
        r"npt\.NDArray\[[\w.]+\]", "npt.ArrayLike", plain(kind))
    if default == "None" and "None" not in kind:
        kind += " | None"
    kind = re.sub(r"^list\[", "Sequence[", kind)
    simple = re.fullmatch(r"None|True|False|-?[\d.]+|'[^']*'", default)
    return f"{name}: {kind}" + (f" = {default if simple else '...'}" if default else "")


def signatures(owner, name, documentation):
    """(parameters, result, text) of each overload in a docstring."""
    lines = documentation.split("\n")
    found = [(at, match) for at, line in enumerate(lines) if (match := SIGNATURE.match(line))
             and match[1] == name]
    for number, (at, match) in enumerate(found):
        end = found[number + 1][0] if number + 1 < len(found) else len(lines)
        text = "\n".join(lines[at + 1:end]).strip()
        inside = [parameter(part, name) for part in split(match[2])]
        key = f"{owner}.{name}" if owner else name
        yield inside, RESULTS.get(key, plain(match[3])), text


def function_lines(owner, name, documentation, indent, fields=()):
    """A function or method, one or several overloads."""
    overloads = list(signatures(owner, name, documentation))
    lines = []
    for inside, result, text in overloads:
        if "**kwargs" in inside and fields:
            inside = ["self", "*", *fields]
        if len(overloads) > 1:
            lines.append(f"{indent}@overload")
        head = f"{indent}def {name}({', '.join(inside)}) -> {result}:"
        lines.append(head + (" ..." if not text else ""))
        if text:
            lines.append(f'{indent}    """{text}"""')
    return lines


def property_type(owner, name, getter, documentation):
    match = re.search(r"-> (.+)$", getter.__doc__ or "", flags=re.M)
    return RESULTS.get(f"{owner}.{name}", plain(match[1]) if match else "Any")


def class_lines(module, name, kind):
    members = vars(kind)
    bases = [base.__name__ for base in kind.__bases__ if base.__module__ != "pybind11_builtins"]
    base = f"({bases[0]})" if bases and bases[0] != "object" else ""
    lines = [f"class {name}{base}:", f'    """{(kind.__doc__ or "").strip()}"""']
    if "__members__" in members or hasattr(kind, "__members__"):
        lines[1] = f'    """{kind.__doc__.split(chr(10))[0]}"""'
        lines += [f"    {member}: {name}" for member in kind.__members__]
        lines += ["    def __init__(self, value: int) -> None: ...",
                  "    def __int__(self) -> int: ...", "    def __index__(self) -> int: ...",
                  "    @property", "    def name(self) -> str: ...",
                  "    @property", "    def value(self) -> int: ..."]
        return lines
    fields = []
    for member, value in members.items():
        if isinstance(value, property):
            result = property_type(name, member, value.fget, value.__doc__)
            lines += ["    @property", f"    def {member}(self) -> {result}:",
                      f'        """{value.__doc__ or ""}"""']
            if value.fset:
                given = PARAMETERS.get(member) if result.startswith("list[Episode") else result
                lines += [f"    @{member}.setter",
                          f"    def {member}(self, value: {given}) -> None: ..."]
                fields.append(f"{member}: {result} = ...")
    for member, value in members.items():
        public = not member.startswith("_") or member in (
            "__init__", "__eq__", "__len__", "__str__", "_repr_svg_", "__getitem__",
            "__setitem__", "__iter__", "__delitem__", "__bool__", "__contains__", "__enter__",
            "__exit__")
        if public and callable(value) and not isinstance(value, property):
            made = function_lines(name, member, value.__doc__ or "", "    ", fields)
            if member == "__eq__":
                made = ["    def __eq__(self, other: object) -> bool: ..."]
            lines += [line.replace("arg0: ", "value: ") for line in made]
    return lines


def stub(module):
    lines = [HEADER]
    for name, value in sorted(vars(module).items()):
        if name.startswith("_"):
            continue
        if isinstance(value, type) and issubclass(value, Exception):
            lines += [f"class {name}({value.__bases__[0].__name__}):",
                      f'    """{value.__doc__}"""', ""]
        elif isinstance(value, type):
            lines += [*class_lines(module, name, value), ""]
        elif callable(value):
            lines += [*function_lines("", name, value.__doc__ or "", ""), ""]
    return "\n".join(lines).rstrip() + "\n"


def names(package):
    """A table of the package's names with the first sentence of each."""
    lines = ["# The names of limber's Python module", "",
             "Made when the module is built; `help(limber.NAME)` says the rest.", "",
             "| name | what it is |", "|---|---|"]
    for name, value in sorted(vars(package).items(), key=lambda item: item[0].lower()):
        if name.startswith("_") or not (isinstance(value, type) or callable(value)):
            continue
        said = [line for line in value.__doc__.splitlines()
                if line.strip() and not SIGNATURE.match(line) and line != "Overloaded function."]
        text = " ".join(" ".join(said).split()).split(". ")[0].rstrip(".").replace("|", "\\|")
        lines.append(f"| `{name}` | {text} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stub", type=pathlib.Path)
    parser.add_argument("names", type=pathlib.Path)
    arguments = parser.parse_args()
    import limber._limber
    arguments.stub.write_text(stub(limber._limber), encoding="utf-8")
    arguments.names.write_text(names(limber), encoding="utf-8")


if __name__ == "__main__":
    main()
