// From logs in CSV files to a plan: import them, train a network on them, plan with it.
//
//   05_bring_your_own_arm ARM.yaml MAPPING.yaml ENVIRONMENT.yaml PLAN.json EPOCHS LOG.csv…
//
// MAPPING.yaml names the logs' columns and units (docs/importing.md).

#include <cstdlib>
#include <iostream>

#include "limber/data/valve_identification.hpp"
#include "limber/logs/log_import.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/training/evaluation.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"

int main(int argc, char** argv) try {
  if (argc < 7) {
    std::cerr << "05_bring_your_own_arm ARM MAPPING ENVIRONMENT PLAN.json EPOCHS LOG.csv…\n";
    return 2;
  }
  const limber::ArmDescription arm = limber::load_arm(argv[1]);
  limber::ImportOptions options;
  options.mapping = limber::read_import_mapping(argv[2], arm);
  const limber::ImportResult imported = limber::import_csv({argv + 6, argv + argc}, options, arm);
  std::cout << limber::to_text(imported.report) << "\n";
  const limber::Recording& recording = imported.recording;
  const auto inspection = limber::inspect(recording, &arm, "the logs");
  std::cout << limber::to_text(recording, inspection) << "\n";

  limber::TrainingSettings settings = limber::best_preset();
  limber::set_epoch_count(settings, std::atoi(argv[5]));
  auto data = limber::hold_back_validation(recording.episodes, 0.1, settings.seed);
  limber::hold_back_unseen(data, 0.1, settings.seed);
  limber::CompensationModel network = limber::train(arm, data, settings).model;
  network.set_valves(limber::identify_valves(recording.episodes, arm, "the logs"));
  network.learnt = limber::learnt_region_of(data);
  limber::note_unseen(arm, network, data.unseen);

  const limber::Environment environment = limber::load_environment(argv[3], arm);
  const auto result = limber::plan(arm, network, environment, {.time_s = 5.0});
  if (!result.plan) {
    std::cout << "no plan: " << result.reason << "\n";
    return 1;
  }
  limber::write_plan(argv[4], *result.plan);
  limber::write_setpoints_csv(std::string(argv[4]) + ".csv", *result.plan);
  std::cout << argv[4] << ": " << result.plan->frame_count() << " frames, " << result.plan->cost_kpa
            << " kPa\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
