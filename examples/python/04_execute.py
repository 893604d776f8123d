"""A plan executed, open loop, on the virtual arm. Another arm needs an ArmDriver of its own.

    04_execute.py PLAN.json ENVIRONMENT.yaml           (in C++: 05_execute)
"""

import sys

import limber


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    plan = limber.read_plan(sys.argv[1])
    virtual_arm = limber.VirtualArm(arm)
    result = limber.execute(arm, environment, plan, virtual_arm)

    print(f"{result.status.name}: {result.frames} frames, "
          f"{result.goal_error.position_m * 100:.2f} cm from the goal's centre"
          f"{', reached' if result.goal_reached else ', not reached'}"
          f"{', collided' if result.collided else ''}")
    if result.prediction:
        print(f"the tip was {result.prediction.mean_m * 100:.2f} cm from its prediction on average")
    return 0 if result.goal_reached and not result.collided else 1


if __name__ == "__main__":
    sys.exit(main())
