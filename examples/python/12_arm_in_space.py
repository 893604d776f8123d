"""An arm in space: the virtual one recorded, networks trained on what it did, and their mean rolled
out beside a run that they have not seen.

    12_arm_in_space.py RECORDING.h5 MODEL.safetensors [EPOCHS]     (in C++: the same name)
"""

import sys

import numpy as np

import limber

NETWORKS = 2  # where they disagree, they know little


def main() -> None:
    arm = limber.load_arm(limber.data_folder() / "arms" / "hanging_3x2.yaml")
    schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=6, episodes=4)
    limber.collect(arm, limber.virtual_collection(arm, schedule), limber.virtual_arm_factory(arm),
                   sys.argv[1])
    *episodes, unseen = limber.read_recording(sys.argv[1]).episodes

    settings = limber.best_preset()
    settings.ensemble = NETWORKS
    if len(sys.argv) > 3:
        limber.set_epoch_count(settings, int(sys.argv[3]))
    data = limber.hold_back_validation(episodes, 0.3, settings.seed)  # of the frames
    model = limber.train(arm, data, settings).model
    model.set_valves(limber.identify_valves(episodes, arm))
    limber.write_model(sys.argv[2], model)

    # Poses are x, y, z and a quaternion x, y, z, w for each plate; the base comes first.
    no_load = limber.NoLoadModel(arm).backbone(unseen.pressure_kpa)
    ensemble = limber.EnsembleForward(arm, limber.read_model(sys.argv[2]))
    rollout = ensemble.rollout(unseen.pressure_kpa, unseen.backbone[0])
    for name, poses in (("no load", no_load), ("networks", rollout.mean)):
        off_m = np.linalg.norm(poses[:, -1, :3] - unseen.backbone[:, -1, :3], axis=1)
        print(f"{name}: tip {off_m.mean() * 1000:.1f} mm off on average")
    x_m, y_m, z_m = rollout.mean[-1, -1, :3]
    spread_mm = 1000 * np.linalg.norm(rollout.standard_deviation[-1, -1, :3])
    print(f"at the end: tip at ({x_m:.4f}, {y_m:.4f}, {z_m:.4f}) m, give or take {spread_mm:.1f} mm")

    # One frame from where it was seen: pressures before and now, and two backbones before.
    forward = limber.ForwardModel(arm, model)
    told_kpa = forward.told_commands(unseen.pressure_kpa)  # networks read past ones too
    after = forward.step(told_kpa[1], told_kpa[2], unseen.backbone[1], before=unseen.backbone[0])
    off_m = np.linalg.norm(after[-1, :3] - unseen.backbone[2, -1, :3])
    print(f"after one frame: tip {off_m * 1000:.2f} mm off")


if __name__ == "__main__":
    main()
