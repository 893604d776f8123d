"""A plan with a network of one's own, and a second opinion on it.

    03_plan_and_verify.py MODEL.safetensors ENVIRONMENT.yaml PLAN.json     (in C++: the same name)
"""

import sys

import limber


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    network = limber.read_model(sys.argv[1])
    forward = limber.ForwardModel(arm, network)
    valves = network.valves or limber.ValveParameters()
    model = limber.MotionModel(forward, limber.ValveModel(arm, valves))
    room = limber.error_room(forward)  # the error that the model states
    problem = limber.problem_with_room(arm, model, environment, room)
    limits = limber.PlannerLimits(time_s=2.0)
    result = limber.make_planner("default").plan(problem, limits, seed=1)
    if not result.plan:
        print(f"no plan: {result.reason}")
        return 1
    limber.write_plan(sys.argv[3], result.plan)

    # The planner has asked for it already; this is how you ask yourself, of a file from anywhere.
    certificate = limber.certify(limber.read_plan_unchecked(sys.argv[3]), arm, network, valves,
                                 environment)
    for failure in certificate.failures:
        print(f"{failure.check}: {failure.message}")
    print(f"{'certified' if certificate.certified else 'refused'}: {certificate.frames} frames, "
          f"{certificate.cost_kpa:.1f} kPa, clearance {certificate.clearance_m * 100:.2f} cm")
    return 0 if certificate.certified else 1


if __name__ == "__main__":
    sys.exit(main())
