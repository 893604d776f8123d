"""A planner of your own: it says where the set points go, limber simulates, holds and certifies the
motion. This one climbs: it changes the best motion so far, and keeps what is nearer to a solution.

    06_plug_in_a_planner.py MODEL.safetensors ENVIRONMENT.yaml PLAN.json     (in C++: the same name)

The model may be your own too: 08_train_in_pytorch.py trains one in PyTorch, and model_file.py writes any
network's weights as such a file.
"""

import sys

import limber

TRIES = 2000
SPREAD = 0.2  # of the limits: how far a try is from the best so far


def fault_m(plan: limber.Plan) -> float:
    """How far a motion ends from the goal, and how deep it goes into obstacles."""
    return plan.goal_distance_m - min(plan.clearance_m, 0.0)


def climb(arm: limber.ArmDescription, problem: limber.PlanningProblem,
          seed: int) -> limber.PlanResult:
    random = limber.RandomStream(seed, 0)  # seed, stream
    best_kpa = [[0.0] * arm.segment_count] * 2  # over one waypoint to another
    best = limber.plan_along(problem, best_kpa, "climber", seed)
    for _ in range(TRIES):
        if best.status != limber.PlanStatus.not_certified or best.best_partial is None:
            break
        kpa = [list(waypoint) for waypoint in best_kpa]
        for waypoint in kpa:
            for s, (lower, upper) in enumerate(arm.pressure_ranges_kpa):
                change_kpa = SPREAD * (upper - lower) / 2 * random.normal()
                waypoint[s] = min(max(waypoint[s] + change_kpa, lower), upper)
        tried = limber.plan_along(problem, kpa, "climber", seed)
        if tried.plan or (tried.best_partial
                          and fault_m(tried.best_partial) < fault_m(best.best_partial)):
            best_kpa = kpa
            best = tried
    return best


def main() -> int:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    environment = limber.load_environment(sys.argv[2], arm)
    forward = limber.ForwardModel(arm, limber.read_model(sys.argv[1]))
    problem = limber.PlanningProblem(arm, limber.MotionModel(forward), environment)
    result = climb(arm, problem, 1)
    if not result.plan:
        print(f"no plan: {result.reason}")
        return 1
    limber.write_plan(sys.argv[3], result.plan)
    print(f"{sys.argv[3]}: {result.plan.cost_kpa:.1f} kPa, certified")
    return 0


if __name__ == "__main__":
    sys.exit(main())
