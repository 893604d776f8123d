// A network from a recording: a little of it is held back, to choose the epoch and to measure the
// error that plans keep clear of.
//
//   06_train_from_a_recording RECORDING.h5 MODEL.safetensors [EPOCHS]

#include <cstdlib>
#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"

namespace {

constexpr double kHeldBack = 0.1;  // of the frames, each time

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "06_train_from_a_recording RECORDING.h5 MODEL.safetensors [EPOCHS]\n";
    return 2;
  }
  const limber::ArmDescription arm =
      limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::Recording recording = limber::read_recording(argv[1]);
  limber::require_recording_of(recording, arm, argv[1]);

  limber::TrainingSettings settings = limber::best_preset();
  for (limber::TrainingStage& stage : settings.stages) {
    stage.epochs = argc > 3 ? std::atoi(argv[3]) : stage.epochs;
  }
  limber::TrainingData data =
      limber::hold_back_validation(recording.episodes, kHeldBack, settings.seed);
  limber::hold_back_unseen(data, kHeldBack, settings.seed);
  limber::TrainingResult result = limber::train(arm, data, settings);
  limber::note_unseen(arm, result.model, data.unseen);
  limber::write_model(argv[2], result.model);

  std::cout << result.curve.size() << " epochs in " << result.wall_time_s << " s, the best "
            << result.best_epoch << ": " << result.best_validation_position_error_cm
            << " cm at the tip, open loop\n";
  if (result.model.prediction_error) {
    std::cout << "over " << result.model.prediction_error->runs << " unseen runs "
              << result.model.prediction_error->off_path_m * 100.0
              << " cm off the predicted path, in 95 % of them\n";
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
