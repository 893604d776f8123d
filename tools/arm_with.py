#!/usr/bin/env python3
"""An arm file with other numbers: that of an arm whose physics somebody guessed wrongly.

    tools/arm_with.py arms/three_segment.yaml friction_coefficient=0.35 > guess.yaml

KEY=VALUE replaces the number of every line "KEY: number"; a key that has no such line is refused.
"""

import argparse
import pathlib
import re
import sys


def replaced(text, setting):
    key, _, value = setting.partition("=")
    try:
        value = float(value)
    except ValueError:
        sys.exit(f"{setting}: expected KEY=VALUE, VALUE a number")
    number = r"[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?(?=[ \t]*(?:#|$))"
    found, count = re.subn(rf"^([ \t]*{re.escape(key)}:[ \t]*){number}",
                           lambda line: line[1] + str(value), text, flags=re.MULTILINE)
    if count == 0:
        sys.exit(f"{setting}: the arm file has no number of that name")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("arm", type=pathlib.Path)
    parser.add_argument("settings", nargs="+", metavar="KEY=VALUE")
    options = parser.parse_args()
    text = options.arm.read_text(encoding="utf-8")
    for setting in options.settings:
        text = replaced(text, setting)
    print(text, end="")


if __name__ == "__main__":
    main()
