#!/usr/bin/env python3
"""Draws docs/images/modules.svg from the build's own targets: which module links which.

    tools/module_picture.py --build build/dev --out docs/images/modules.svg
    tools/module_picture.py --build build/dev --check     only whether the layers hold

What links what is in module_links.txt of the build folder: CMake writes it (LimberModuleLinks.cmake).

Modules stand on those below them, in layers; what is linked through another is not drawn again. Fails
where an arrow would point upwards, that is where targets stand on each other in a circle, where a
target does not declare exactly the modules that its files include, where a library that one module
alone may know is included by another, or where a module holds more than 12 % of the lines.
"""

import argparse
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
MAX_SHARE_OF_LINES = 0.12
# What one module alone knows: the header's beginning, or a call.
KNOWN_BY_ONE = {"data": r"<(hdf5|H5|linux/seccomp)", "sim": r"<mujoco/", "driver": r"<spawn\.h>",
                "planning": r"<ompl/", "network": r"<onnx/", "common": r"<yaml-cpp/",
                "studio": r"<httplib\.h>"}
BOX_W, BOX_H, GAP_X, GAP_Y, EDGE = 118, 40, 26, 46, 20


def links_of(build):
    """Module → modules that its target links."""
    path = pathlib.Path(build) / "module_links.txt"
    if not path.exists():
        sys.exit(f"{path} is missing: configure that folder first, as in cmake --preset dev")
    rows = [line.split(":") for line in path.read_text().splitlines()]
    links = {module: set(others.split()) for module, others in rows}
    # Kernels are headers for inner loops, seen from many layers: docs/architecture.md names them.
    folders = {path.parent.name for path in ROOT.glob("src/*/CMakeLists.txt")} - {"kernels"}
    if set(links) != folders:
        sys.exit(f"{path} and src/ differ in {', '.join(sorted(set(links) ^ folders))}")
    return links


def below(links, module, way=()):
    """All that a module stands on."""
    if module in way:
        sys.exit(f"modules stand on each other: {' → '.join([*way, module])}")
    found = set()
    for other in links[module]:
        found |= {other} | below(links, other, (*way, module))
    return found


def direct(links, module):
    """Without what is linked through another."""
    through = set().union(*[below(links, other) for other in links[module]], set())
    return links[module] - through


def check_includes(links):
    """Each target declares every module that its files include, and no other."""
    for module in links:
        used = set()
        for path in (ROOT / "src" / module).rglob("*.?pp"):
            text = path.read_text()
            used |= set(re.findall(r'#include "limber/(\w+)/', text)) - {module}
            for owner, pattern in KNOWN_BY_ONE.items():
                if owner != module and re.search(pattern, text):
                    sys.exit(f"{path.relative_to(ROOT)}: {pattern} belongs to src/{owner} alone")
        for other in sorted(used - links[module]):
            sys.exit(f"src/{module} includes limber/{other}/, which its CMakeLists.txt does not name")
        for other in sorted(links[module] - used):
            sys.exit(f"src/{module}/CMakeLists.txt names limber::{other}, which nothing there includes")


def lines_of(module):
    folder = ROOT / "src" / module
    return sum(len(path.read_text().splitlines()) for path in folder.rglob("*.?pp"))


def layers_of(links):
    """Rows from the bottom up, each module as near as can be to those that stand on it."""
    users = {module: {user for user in links if module in links[user]} for module in links}
    depth = {}

    def layer(module):
        if module not in depth:
            depth[module] = 1 + max([layer(user) for user in users[module]], default=-1)
        return depth[module]

    for module in links:
        layer(module)
    for module in links:
        if not users[module] and links[module]:  # nothing stands on it: just above what it needs
            depth[module] = min(depth[other] for other in links[module]) - 1
    rows = {}
    for module in links:
        rows.setdefault(depth[module], []).append(module)
    return untangled([sorted(rows[key]) for key in sorted(rows, reverse=True)], links)


def untangled(rows, links):
    """Each row in the order of the mean place of its neighbours, again and again."""
    near = {module: {other for other in links if other in direct(links, module)
                     or module in direct(links, other)} for module in links}
    for sweep in range(8):
        place = {module: i - (len(row) - 1) / 2 for row in rows for i, module in enumerate(row)}
        for row in rows if sweep % 2 else reversed(rows):
            row.sort(key=lambda m: sum(place[n] for n in near[m]) / max(len(near[m]), 1))
            place.update({module: i - (len(row) - 1) / 2 for i, module in enumerate(row)})
    return rows


def picture(links, lines):
    rows = layers_of(links)
    width = max(len(row) for row in rows) * (BOX_W + GAP_X) - GAP_X + 2 * EDGE
    height = len(rows) * (BOX_H + GAP_Y) - GAP_Y + 2 * EDGE
    total = sum(lines.values())
    centre = {}
    for k, row in enumerate(rows):
        left = (width - (len(row) * (BOX_W + GAP_X) - GAP_X)) / 2
        for i, module in enumerate(row):
            centre[module] = (left + i * (BOX_W + GAP_X) + BOX_W / 2,
                              height - EDGE - k * (BOX_H + GAP_Y) - BOX_H / 2)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
           f'viewBox="0 0 {width:.0f} {height:.0f}" font-family="sans-serif" font-size="13">',
           '<title>Modules and what they stand on</title>',
           '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="7" refY="4" orient="auto">'
           '<path d="M0,1 L7,4 L0,7" fill="none" stroke="#5f6b7a"/></marker></defs>',
           f'<rect width="{width:.0f}" height="{height:.0f}" fill="#ffffff"/>']
    for module in sorted(links):
        for other in sorted(direct(links, module)):
            (x1, y1), (x2, y2) = centre[module], centre[other]
            out.append(f'<path d="M{x1:.0f},{y1 + BOX_H / 2:.0f} C{x1:.0f},{y1 + BOX_H / 2 + 34:.0f} '
                       f'{x2:.0f},{y2 - BOX_H / 2 - 34:.0f} {x2:.0f},{y2 - BOX_H / 2 - 2:.0f}" '
                       'fill="none" stroke="#5f6b7a" marker-end="url(#tip)"/>')
    for module, (x, y) in sorted(centre.items()):
        share = f"{100 * lines[module] / total:.0f} %" if lines[module] else ""
        out.append(f'<rect x="{x - BOX_W / 2:.0f}" y="{y - BOX_H / 2:.0f}" width="{BOX_W}" '
                   f'height="{BOX_H}" rx="5" fill="#eef3f8" stroke="#31506f"/>')
        out.append(f'<text x="{x:.0f}" y="{y - 2:.0f}" text-anchor="middle" fill="#10233a">'
                   f'{module}</text>')
        out.append(f'<text x="{x:.0f}" y="{y + 13:.0f}" text-anchor="middle" font-size="11" '
                   f'fill="#5f6b7a">{share}</text>')
    return "\n".join([*out, "</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build/dev", help="a configured build folder")
    parser.add_argument("--out", default=str(ROOT / "docs/images/modules.svg"))
    parser.add_argument("--check", action="store_true", help="draw nothing")
    options = parser.parse_args()
    links = links_of(options.build)
    lines = {module: lines_of(module) for module in [*links, "kernels"]}
    largest = max(lines, key=lines.get)
    share = lines[largest] / sum(lines.values())
    for module in links:
        below(links, module)
    check_includes(links)
    print(f"{len(links)} modules, the largest {largest} with {100 * share:.1f} % of the lines")
    if share > MAX_SHARE_OF_LINES:
        sys.exit(f"{largest} holds more than {100 * MAX_SHARE_OF_LINES:.0f} % of the lines")
    if not options.check:
        pathlib.Path(options.out).write_text(picture(links, lines))


if __name__ == "__main__":
    main()
