"""The virtual arm recorded, and a network trained on what it did: a little of the recording is held
back, to choose the epoch and to measure the error that plans keep clear of.

    02_record_and_train.py RECORDING.h5 MODEL.safetensors [EPOCHS]     (in C++: the same name)
"""

import sys

import limber

HELD_BACK = 0.1  # of the frames, each time


def main() -> None:
    arm = limber.load_arm(limber.data_folder() / "arms" / "three_segment.yaml")
    schedule = limber.ScheduleSettings(kind=limber.ScheduleKind.random, count=20, episodes=2)
    limber.collect(arm, limber.virtual_collection(arm, schedule), limber.virtual_arm_factory(arm),
                   sys.argv[1])
    recording = limber.read_recording(sys.argv[1])
    limber.require_recording_of(recording, arm, sys.argv[1])

    settings = limber.best_preset()
    if len(sys.argv) > 3:
        limber.set_epoch_count(settings, int(sys.argv[3]))
    data = limber.hold_back_validation(recording.episodes, HELD_BACK, settings.seed)
    limber.hold_back_unseen(data, HELD_BACK, settings.seed)
    result = limber.train(arm, data, settings,
                          lambda point: print(f"epoch {point.epoch}: loss {point.loss:.4f}"))
    model = result.model
    model.set_valves(limber.identify_valves(recording.episodes, arm))
    model.learnt = limber.learnt_region_of(data)
    limber.note_unseen(arm, model, data.unseen)
    limber.write_model(sys.argv[2], model)

    print(f"{len(result.curve)} epochs in {result.wall_time_s:.1f} s, the best "
          f"{result.best_epoch}: {result.best_validation_position_error_cm:.2f} cm at the tip, "
          "open loop")
    if model.prediction_error:
        print(f"over {model.prediction_error.runs} unseen runs "
              f"{model.prediction_error.off_path_m * 100:.2f} cm off the predicted path, in 95 % "
              "of them")


if __name__ == "__main__":
    main()
