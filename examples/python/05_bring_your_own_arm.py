"""From logs in CSV files to a plan: import them, train a network on them, plan with it.

    05_bring_your_own_arm.py ARM.yaml MAPPING.yaml ENVIRONMENT.yaml PLAN.json EPOCHS LOG.csv…

MAPPING.yaml names the logs' columns and units (docs/importing.md). In C++: the same name.
"""

import sys

import limber


def main() -> int:
    arm_file, mapping, environment_file, plan_file, epochs, *logs = sys.argv[1:]
    arm = limber.load_arm(arm_file)
    imported = limber.import_csv(logs, arm, mapping)
    print(imported.report)
    recording = imported.recording
    print(limber.inspect(recording, arm))

    settings = limber.best_preset()
    limber.set_epoch_count(settings, int(epochs))
    data = limber.hold_back_validation(recording.episodes, 0.1, settings.seed)
    limber.hold_back_unseen(data, 0.1, settings.seed)
    network = limber.train(arm, data, settings).model
    network.set_valves(limber.identify_valves(recording.episodes, arm))
    network.learnt = limber.learnt_region_of(data)
    limber.note_unseen(arm, network, data.unseen)

    environment = limber.load_environment(environment_file, arm)
    result = limber.plan(arm, network, environment, limber.PlannerLimits(time_s=5.0))
    if not result.plan:
        print(f"no plan: {result.reason}")
        return 1
    limber.write_plan(plan_file, result.plan)
    limber.write_setpoints_csv(plan_file + ".csv", result.plan)
    print(f"{plan_file}: {result.plan.frame_count} frames, {result.plan.cost_kpa:.1f} kPa")
    return 0


if __name__ == "__main__":
    sys.exit(main())
