"""A plan executed on the virtual arm: open loop, and planned again from where the arm is measured.
Another arm needs an ArmDriver of its own.

    04_execute.py PLAN.json ENVIRONMENT.yaml MODEL.safetensors     (in C++: the same name)
"""

import sys

import limber


def show(how: str, result: limber.ExecutionResult) -> None:
    if result.goal_error is None:  # the arm was not tracked at the end
        print(f"{how}: {result.message}")
        return
    print(f"{how}: {result.status.name}, {result.frames} frames, "
          f"{result.goal_error.position_m * 100:.2f} cm from the goal's centre"
          f"{', reached' if result.goal_reached else ', not reached'}"
          f"{', collided' if result.collided else ''}, planned again {result.replans} times")


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    plan = limber.read_plan(sys.argv[1])
    open_loop = limber.execute(arm, environment, plan, limber.VirtualArm(arm))
    show("open loop", open_loop)
    if open_loop.prediction:
        print(f"the tip was {open_loop.prediction.mean_m * 100:.2f} cm from its prediction on "
              "average")

    network = limber.read_model(sys.argv[3])
    forward = limber.ForwardModel(arm, network)
    valves = network.valves or limber.ValveParameters()
    model = limber.MotionModel(forward, limber.ValveModel(arm, valves))
    loop = limber.ClosedLoop(arm, model, environment, limber.error_room(forward), seed=1)
    closed_loop = limber.execute(arm, environment, plan, limber.VirtualArm(arm),
                                 controller=loop)
    show("closed loop", closed_loop)
    return 0 if closed_loop.goal_reached and not closed_loop.collided else 1


if __name__ == "__main__":
    sys.exit(main())
