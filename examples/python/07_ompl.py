"""A planner of the Open Motion Planning Library on limber's model, beside limber's own. It needs a
limber that was built with libompl-dev.

    07_ompl.py MODEL.safetensors ENVIRONMENT.yaml [PLANNER]     (in C++: the same name)
"""

import sys

import limber


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    limits = limber.PlannerLimits(time_s=5.0)
    for name in ("default", sys.argv[3] if len(sys.argv) > 3 else "ompl:RRT"):
        result = limber.plan(arm, sys.argv[1], environment, limits, seed=1, planner=name)
        if result.plan and result.first_solution:
            print(f"{name}: {result.plan.cost_kpa:.1f} kPa, certified after "
                  f"{result.first_solution.time_s:.3f} s and {result.first_solution.queries} "
                  "queries")
        else:
            print(f"{name}: no plan: {result.reason}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except limber.InputError as error:
        print(error, file=sys.stderr)
        sys.exit(2)
