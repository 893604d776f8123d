"""Draws the arm's shape at given pressures as an SVG picture.

    10_draw_the_arm.py PICTURE.svg [PRESSURE_KPA…]     (in C++: the same name)
"""

import pathlib
import sys

import limber


def main() -> None:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    model = limber.NoLoadModel(arm)

    pressures_kpa = [30.0] * arm.segment_count
    for i, text in enumerate(sys.argv[2:2 + arm.segment_count]):
        pressures_kpa[i] = float(text)
    pathlib.Path(sys.argv[1]).write_text(limber.arm_svg(arm, model.backbone(pressures_kpa)),
                                         encoding="utf-8")
    print(sys.argv[1])


if __name__ == "__main__":
    main()
