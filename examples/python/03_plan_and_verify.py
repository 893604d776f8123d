"""A plan with a network of one's own, and a second opinion on it.

    03_plan_and_verify.py MODEL.safetensors ENVIRONMENT.yaml PLAN.json     (in C++: the same name)
"""

import sys

import limber


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    result = limber.plan(arm, sys.argv[1], environment)  # with room for the model's error
    if not result.plan:
        print(f"no plan: {result.reason}")
        return 1
    limber.write_plan(sys.argv[3], result.plan)

    # The planner has asked for it already; this is how you ask yourself, of a file from anywhere.
    network = limber.read_model(sys.argv[1])
    valves = network.valves or limber.ValveParameters()
    certificate = limber.certify(limber.read_plan_unchecked(sys.argv[3]), arm, network, valves,
                                 environment)
    for failure in certificate.failures:
        print(f"{failure.check}: {failure.message}")
    print(f"{'certified' if certificate.certified else 'refused'}: {certificate.frames} frames, "
          f"{certificate.cost_kpa:.1f} kPa, clearance {certificate.clearance_m * 100:.2f} cm")
    return 0 if certificate.certified else 1


if __name__ == "__main__":
    sys.exit(main())
