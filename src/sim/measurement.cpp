#include "measurement.hpp"

#include "limber/arm/space_pose.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

void check_option(const char* name, double value, double high) {
  refuse_if(!(value >= 0.0 && value <= high),
            "virtual arm: {} = {}; expected a number from 0 to {}", name, value, high);
}

}  // namespace

void check_options(const VirtualArmOptions& options) {
  constexpr double kLongestLatencyS = 10.0;
  constexpr double kLongestLossS = 1e6;
  constexpr double kMaxNoise = 1e3;
  check_option("noise_m", options.noise_m, kMaxNoise);
  check_option("noise_rad", options.noise_rad, kMaxNoise);
  check_option("noise_kpa", options.noise_kpa, kMaxNoise);
  check_option("drop_rate", options.drop_rate, 1.0);
  check_option("latency_s", options.latency_s, kLongestLatencyS);
  check_option("lost_from_s", options.lost_from_s, kLongestLossS);
  check_option("lost_for_s", options.lost_for_s, kLongestLossS);
  check_option("later_from_s", options.later_from_s, kLongestLossS);
}

ArmState Measurement::pressures(double time_s, const std::vector<double>& true_kpa) {
  ArmState state;
  state.time_s = time_s;
  state.pressure_kpa.resize(Eigen::Index(true_kpa.size()));
  for (std::size_t s = 0; s < true_kpa.size(); ++s) {
    state.pressure_kpa[Eigen::Index(s)] = float(true_kpa[s] + noise(options_.noise_kpa));
  }
  return state;
}

bool Measurement::is_lost(double time_s) {
  const bool is_dropped = options_.drop_rate > 0.0 && random_.uniform() < options_.drop_rate;
  const double since_s = time_s - options_.lost_from_s;
  return is_dropped || (since_s >= 0.0 && since_s < options_.lost_for_s);
}

ArmState Measurement::of(double time_s, const std::vector<double>& true_kpa, BackboneD plates) {
  ArmState state = pressures(time_s, true_kpa);
  for (Eigen::Index row = 0; row < plates.rows(); ++row) {
    plates(row, 0) += noise(options_.noise_m);
    plates(row, 1) += noise(options_.noise_m);
    plates(row, 2) += noise(options_.noise_rad);
  }
  if (!is_lost(time_s)) {
    state.backbone = plates.cast<float>();
  }
  return state;
}

ArmState Measurement::of(double time_s, const std::vector<double>& true_kpa,
                         SpaceBackboneD plates) {
  ArmState state = pressures(time_s, true_kpa);
  for (Eigen::Index row = 0; row < plates.rows(); ++row) {
    SpacePose pose = space_pose_of(plates.row(row));
    Eigen::Vector3d turn_rad;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      pose.position_m[axis] += noise(options_.noise_m);
      turn_rad[axis] = noise(options_.noise_rad);
    }
    pose.rotation = pose.rotation * rotation_of_vector(turn_rad);
    plates.row(row) = numbers_of(pose).transpose();
  }
  if (!is_lost(time_s)) {
    state.space_backbone = plates.cast<float>();
  }
  return state;
}

}  // namespace limber
