"""Where does the arm go, says a network, when the first segment is inflated for two seconds?

    01_query_the_model.py MODEL.safetensors [KPA]      (in C++: the same name)
"""

import sys

import limber


def main() -> None:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    forward = limber.ForwardModel(arm, limber.read_model(sys.argv[1]))
    assert forward.compensation is not None
    model = limber.MotionModel(forward, limber.ValveModel(arm, forward.compensation.valves))

    goal = limber.PoseGoal()
    rest = limber.start_state(limber.Environment("empty", [], goal), arm)
    state = model.settled_state(rest.pressures_kpa, rest.backbone)
    setpoint_kpa = rest.pressures_kpa
    setpoint_kpa[0] = float(sys.argv[2]) if len(sys.argv) > 2 else 60.0
    for frame in range(1, arm.frames_in(2.0) + 1):
        model.step(setpoint_kpa, state)
        if frame % 10 == 0:
            tip = limber.tip_pose(state.backbone)
            print(f"{frame * arm.frame_period_s:g} s: tip at ({tip.x_m:.4f}, {tip.y_m:.4f}) m, "
                  f"{tip.theta_rad:.3f} rad, segment 0 at {state.pressure_kpa[0]:g} kPa")


if __name__ == "__main__":
    main()
