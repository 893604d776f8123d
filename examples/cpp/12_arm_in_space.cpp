// An arm in space: the virtual one recorded, networks trained on what it did, and their mean rolled
// out beside a run that they have not seen.
//
//   12_arm_in_space RECORDING.h5 MODEL.safetensors [EPOCHS]

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "limber/common/data_folder.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/forward/ensemble_forward.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/training/trainer.hpp"

int main(int argc, char** argv) try {
  if (argc < 3) {
    throw std::invalid_argument("12_arm_in_space RECORDING.h5 MODEL.safetensors [EPOCHS]");
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "hanging_3x2.yaml");
  limber::ScheduleSettings schedule;
  schedule.kind = limber::ScheduleKind::random;
  schedule.count = 6;
  schedule.episodes = 4;
  limber::collect(arm, limber::virtual_collection(arm, schedule, {}),
                  limber::virtual_arm_factory(arm, {}), argv[1]);
  std::vector<limber::Episode> episodes = limber::read_recording(argv[1]).episodes;
  const limber::Episode unseen = episodes.back();
  episodes.pop_back();

  limber::TrainingSettings settings = limber::best_preset();
  settings.ensemble = 2;  // where networks disagree, they know little
  if (argc > 3) {
    limber::set_epoch_count(settings, std::atoi(argv[3]));
  }
  const auto data = limber::hold_back_validation(episodes, 0.3, settings.seed);  // of the frames
  limber::CompensationModel model = limber::train(arm, data, settings).model;
  model.set_valves(limber::identify_valves(episodes, arm, argv[1]));
  limber::write_model(argv[2], model);

  // Poses are x, y, z and a quaternion x, y, z, w for each plate; the base comes first. Limber has
  // a column for each frame.
  const Eigen::MatrixXf pressures = unseen.pressure_kpa.transpose();
  const Eigen::MatrixXf seen = unseen.backbone.transpose();
  Eigen::MatrixXf no_load(seen.rows(), seen.cols());
  const limber::NoLoadModel unloaded(arm);
  for (Eigen::Index t = 0; t < seen.cols(); ++t) {
    unloaded.poses(pressures.col(t), no_load.col(t));
  }
  const limber::EnsembleForward ensemble(arm, limber::read_model(argv[2]));
  const auto rollout = ensemble.rollout(pressures, seen.col(0));
  const Eigen::Index tip = seen.rows() - 7;
  const auto off_mm = [&](const Eigen::MatrixXf& poses) {
    return 1000.0F * (poses - seen).middleRows<3>(tip).colwise().norm().mean();
  };
  std::cout << "no load: tip " << off_mm(no_load) << " mm off on average\n"
            << "networks: tip " << off_mm(rollout.mean) << " mm off on average\n"
            << "at the end: tip at " << rollout.mean.rightCols<1>().segment<3>(tip).transpose()
            << " m, give or take "
            << 1000.0F * rollout.standard_deviation.rightCols<1>().segment<3>(tip).norm()
            << " mm\n";

  // One frame from where it was seen: pressures before and now, and two backbones before.
  const limber::ForwardModel forward(arm, model);
  Eigen::VectorXf after(seen.rows());
  limber::ForwardModel::Workspace workspace;
  const Eigen::MatrixXf told = forward.told_commands(pressures);  // networks read past ones too
  forward.step_batch(told.col(1), told.col(2), seen.col(0), seen.col(1), after, workspace);
  std::cout << "after one frame: tip " << 1000.0F * (after - seen.col(2)).segment<3>(tip).norm()
            << " mm off\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
