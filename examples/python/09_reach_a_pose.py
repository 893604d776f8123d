"""Which pressures bring the end effector to a place, where nothing rubs or pulls?

    09_reach_a_pose.py [X_M Y_M]     (in C++: the same name)
"""

import sys

import limber


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    model = limber.NoLoadModel(arm)

    goal = limber.PoseGoal()
    goal.x_m = float(sys.argv[1]) if len(sys.argv) > 2 else 0.45
    goal.y_m = float(sys.argv[2]) if len(sys.argv) > 2 else 0.30

    random = limber.RandomStream(1, 0)  # seed, stream
    result = limber.solve_inverse_kinematics(
        model, goal, limber.InverseKinematicsSettings(), random)
    if not result.reachable:
        print(result.reason)
        return 1
    print("pressures [kPa], base first, and the tip they lead to [m, m, rad]:")
    for pressures_kpa in result.pressures_kpa:
        backbone = model.backbone(pressures_kpa)
        print(f"{pressures_kpa}  ->  {backbone[-1]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
