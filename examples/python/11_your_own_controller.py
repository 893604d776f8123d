"""A controller of one's own: the plan's set points, moved by what the tip misses along one axis.

    11_your_own_controller.py PLAN.json ENVIRONMENT.yaml     (in C++: the same name)
"""

from __future__ import annotations

import sys

import numpy as np
import numpy.typing as npt

import limber


class Nudge(limber.Controller):
    """Presses the first segment harder while the tip is left of where the plan has it."""

    GAIN = 20.0  # [kPa/m], in each frame

    def __init__(self, arm: limber.ArmDescription, plan: limber.Plan) -> None:
        self.step_kpa = arm.pressure_step_limit_kpa
        self.limit_kpa = np.array([segment.pressure_limit_kpa for segment in arm.segments])
        self.setpoints, self.backbones = plan.setpoint_kpa, plan.backbone
        self.nudge_kpa = 0.0

    def step(self, arm: limber.ArmEstimate) -> npt.NDArray[np.float32] | None:
        following = arm.frames + 1
        if following >= len(self.setpoints):
            return None  # the end
        seen = max(0, following - 1 - arm.lag_frames)
        if arm.measured.backbone is not None:
            planned = self.backbones[seen][-1, :2]
            self.nudge_kpa += self.GAIN * float((arm.measured.backbone[-1, :2] - planned)[1])
        wanted = self.setpoints[following].copy()
        wanted[0] += self.nudge_kpa
        wanted = np.clip(wanted, arm.setpoint_kpa - self.step_kpa, arm.setpoint_kpa + self.step_kpa)
        return np.asarray(np.clip(wanted, -self.limit_kpa, self.limit_kpa), dtype=np.float32)


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    plan = limber.read_plan(sys.argv[1])
    result = limber.execute(arm, environment, plan, limber.VirtualArm(arm),
                            controller=Nudge(arm, plan))
    if result.goal_error is None:
        print("the arm was not seen at the end")
        return 1
    print(f"{result.status.name}: {result.goal_error.position_m * 100:.2f} cm from the goal after "
          f"{result.frames} frames")
    return 0 if result.status == limber.ExecutionStatus.done else 1


if __name__ == "__main__":
    sys.exit(main())
