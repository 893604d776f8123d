// The virtual arm recorded, and a network trained on what it did: a little of the recording is held
// back, to choose the epoch and to measure the error that plans keep clear of.
//
//   02_record_and_train RECORDING.h5 MODEL.safetensors [EPOCHS]

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "limber/common/data_folder.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"

int main(int argc, char** argv) try {
  if (argc < 3) {
    throw std::invalid_argument("02_record_and_train RECORDING.h5 MODEL.safetensors [EPOCHS]");
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  limber::ScheduleSettings schedule;
  schedule.kind = limber::ScheduleKind::random;
  schedule.count = 20;
  schedule.episodes = 2;
  limber::collect(arm, limber::virtual_collection(arm, schedule, {}),
                  limber::virtual_arm_factory(arm, {}), argv[1]);
  const limber::Recording recording = limber::read_recording(argv[1]);
  limber::require_recording_of(recording, arm, argv[1]);

  limber::TrainingSettings settings = limber::best_preset();
  if (argc > 3) {
    limber::set_epoch_count(settings, std::atoi(argv[3]));
  }
  constexpr double kHeldBack = 0.1;  // of the frames, each time
  auto data = limber::hold_back_validation(recording.episodes, kHeldBack, settings.seed);
  limber::hold_back_unseen(data, kHeldBack, settings.seed);
  const auto print = [](const limber::LearningCurvePoint& point) {
    std::cout << "epoch " << point.epoch << ": loss " << point.loss << "\n";
  };
  const limber::TrainingResult result = limber::train(arm, data, settings, {.on_epoch = print});
  limber::CompensationModel model = result.model;
  model.set_valves(limber::identify_valves(recording.episodes, arm, argv[1]));
  model.learnt = limber::learnt_region_of(data);
  limber::note_unseen(arm, model, data.unseen);
  limber::write_model(argv[2], model);

  std::cout << result.curve.size() << " epochs in " << result.wall_time_s << " s, the best "
            << result.best_epoch << ": " << result.best_validation_position_error_cm
            << " cm at the tip, open loop\n";
  if (model.prediction_error) {
    std::cout << "over " << model.prediction_error->runs << " unseen runs "
              << model.prediction_error->off_path_m * 100.0
              << " cm off the predicted path, in 95 % of them\n";
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
