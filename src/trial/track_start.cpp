#include <algorithm>
#include <limits>

#include "limber/common/random_stream.hpp"
#include "limber/trial/tip_tracker.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr int kStartSamples = 400;
constexpr int kNearSamples = 150;
constexpr double kNearShares[] = {0.15, 0.05, 0.02, 0.005};  // of the limits' half width
constexpr double kStartSettlingS = 1.5;

/// Tips where these set points (n×k) leave the arm, from rest.
std::vector<Eigen::Vector2d> settled_tips(const ArmDescription& arm, const MotionModel& model,
                                          const Eigen::MatrixXf& setpoints_kpa) {
  const ArmStart vented = start_state(Environment{}, arm);
  const MotionState rest = model.settled_state(vented.pressures_kpa, vented.backbone);
  const auto count = static_cast<std::size_t>(setpoints_kpa.cols());
  std::vector<Eigen::Vector2d> tips(count);
  std::vector<bool> arrived(count, false);
  RolloutBatch rollouts(model);
  for (Eigen::Index c = 0; c < setpoints_kpa.cols(); ++c) {
    const int frames = motion_frame_count(vented.pressures_kpa, setpoints_kpa.col(c),
                                          arm.pressure_step_limit_kpa());
    rollouts.add(static_cast<int>(c), rest, setpoints_kpa.col(c), frames);
  }
  while (rollouts.size() > 0) {
    rollouts.step();
    for (int column = rollouts.size() - 1; column >= 0; --column) {
      if (!rollouts.has_ended(column)) {
        continue;
      }
      const auto label = static_cast<std::size_t>(rollouts.label(column));
      const MotionState end = rollouts.state(column);
      rollouts.remove(column);
      if (arrived[label]) {
        tips[label] = end.backbone.bottomRows<1>().leftCols<2>().cast<double>().transpose();
      } else {
        arrived[label] = true;
        rollouts.add(static_cast<int>(label), end, setpoints_kpa.col(Eigen::Index(label)),
                     arm.frames_in(kStartSettlingS));
      }
    }
  }
  return tips;
}

}  // namespace

TrackStart find_track_start(const ArmDescription& arm, const MotionModel& model,
                            const Eigen::Vector2d& tip_m, std::uint64_t seed) {
  RandomStream random(seed, 0);
  const Eigen::Index n = arm.segment_count();
  const auto limits_of_segment = [&](Eigen::Index i) {
    return arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
  };
  TrackStart best{Pressures::Zero(n), std::numeric_limits<double>::infinity()};
  const auto try_all = [&](const Eigen::MatrixXf& setpoints_kpa) {
    const std::vector<Eigen::Vector2d> tips = settled_tips(arm, model, setpoints_kpa);
    for (std::size_t c = 0; c < tips.size(); ++c) {
      const double distance_m = (tips[c] - tip_m).norm();
      if (distance_m < best.distance_m) {
        best = {setpoints_kpa.col(Eigen::Index(c)), distance_m};
      }
    }
  };
  Eigen::MatrixXf setpoints_kpa(n, kStartSamples);
  for (Eigen::Index c = 0; c < setpoints_kpa.cols(); ++c) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const PressureLimits limits = limits_of_segment(i);
      setpoints_kpa(i, c) = static_cast<float>(random.uniform(limits.lower_kpa, limits.upper_kpa));
    }
  }
  try_all(setpoints_kpa);
  setpoints_kpa.resize(n, kNearSamples);
  for (const double share : kNearShares) {
    const Pressures center = best.setpoint_kpa;
    for (Eigen::Index c = 0; c < setpoints_kpa.cols(); ++c) {
      for (Eigen::Index i = 0; i < n; ++i) {
        const PressureLimits limits = limits_of_segment(i);
        const double spread_kpa = share * limits.half_width_kpa();
        setpoints_kpa(i, c) =
            static_cast<float>(limits.clamped(double(center[i]) + spread_kpa * random.normal()));
      }
    }
    try_all(setpoints_kpa);
  }
  return best;
}

}  // namespace limber
