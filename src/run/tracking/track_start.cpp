#include <algorithm>

#include "lap_fit.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/run/tip_tracker.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr int kStartSamples = 400;
constexpr int kNearSamples = 150;
constexpr double kNearShares[] = {0.15, 0.05, 0.02, 0.005};  // of the limits' half width
constexpr double kStartSettlingS = 1.5;
constexpr double kStartNearM = 0.01;

/// Tips where these set points (n×k) leave the arm, from rest.
std::vector<Eigen::Vector2d> settled_tips(const ArmDescription& arm, const MotionModel& model,
                                          const Eigen::MatrixXf& setpoints_kpa) {
  const ArmStart vented = start_state(Environment{}, arm);
  const MotionState rest = model.settled_state(vented.pressures_kpa, vented.backbone);
  const auto count = std::size_t(setpoints_kpa.cols());
  std::vector<Eigen::Vector2d> tips(count);
  std::vector<bool> arrived(count, false);
  RolloutBatch rollouts(model);
  for (Eigen::Index c = 0; c < setpoints_kpa.cols(); ++c) {
    const int frames = motion_frame_count(vented.pressures_kpa, setpoints_kpa.col(c),
                                          arm.pressure_step_limit_kpa());
    rollouts.add(int(c), rest, setpoints_kpa.col(c), frames);
  }
  while (rollouts.size() > 0) {
    rollouts.step();
    for (int column = rollouts.size() - 1; column >= 0; --column) {
      if (!rollouts.has_ended(column)) {
        continue;
      }
      const auto label = std::size_t(rollouts.label(column));
      if (arrived[label]) {
        tips[label] = tip_position_m(rollouts.now(column));
        rollouts.remove(column);
      } else {
        arrived[label] = true;
        rollouts.go_on(column, setpoints_kpa.col(Eigen::Index(label)),
                       arm.frames_in(kStartSettlingS));
      }
    }
  }
  return tips;
}

/// n×count: each as `draw` has it from its segment's number and limits.
template <class Draw>
Eigen::MatrixXf sampled_kpa(const ArmDescription& arm, int count, const Draw& draw) {
  Eigen::MatrixXf setpoints_kpa(arm.channel_count(), count);
  for (Eigen::Index c = 0; c < setpoints_kpa.cols(); ++c) {
    for (Eigen::Index i = 0; i < setpoints_kpa.rows(); ++i) {
      setpoints_kpa(i, c) = float(draw(i, arm.segments[i].pressure_limit_kpa));
    }
  }
  return setpoints_kpa;
}

struct Candidate {
  Pressures setpoint_kpa;
  double distance_m = 0.0;
};

/// Of these set points, those whose settled tip is nearest to `tip_m`.
Candidate nearest_of(const ArmDescription& arm, const MotionModel& model,
                     const Eigen::Vector2d& tip_m, const Eigen::MatrixXf& setpoints_kpa) {
  const std::vector<Eigen::Vector2d> tips = settled_tips(arm, model, setpoints_kpa);
  const auto starts = mapped<Candidate>(tips.size(), [&](std::size_t c) {
    return Candidate{setpoints_kpa.col(Eigen::Index(c)), (tips[c] - tip_m).norm()};
  });
  return std::ranges::min(starts, {}, &Candidate::distance_m);
}

Candidate nearest_sample(const ArmDescription& arm, const MotionModel& model,
                         const Eigen::Vector2d& tip_m, RandomStream& random) {
  const Eigen::MatrixXf setpoints_kpa =
      sampled_kpa(arm, kStartSamples, [&](Eigen::Index /*segment*/, const PressureLimits& limits) {
        return random.uniform(limits.lower_kpa, limits.upper_kpa);
      });
  return nearest_of(arm, model, tip_m, setpoints_kpa);
}

Candidate refined(const ArmDescription& arm, const MotionModel& model, const Eigen::Vector2d& tip_m,
                  Candidate best, RandomStream& random) {
  for (const double share : kNearShares) {
    const Eigen::MatrixXf setpoints_kpa =
        sampled_kpa(arm, kNearSamples, [&](Eigen::Index i, const PressureLimits& limits) {
          const double spread_kpa = share * limits.half_width_kpa();
          return limits.clamped(double(best.setpoint_kpa[i]) + spread_kpa * random.normal());
        });
    best = std::ranges::min(best, nearest_of(arm, model, tip_m, setpoints_kpa), {},
                            &Candidate::distance_m);
  }
  return best;
}

}  // namespace

TrackStart find_track_start(const ArmDescription& arm, const MotionModel& model,
                            const TipPath& path, std::uint64_t seed) {
  LapPosture posture =
      fitted_to(path, arm, model, LapPosture(model.no_load(), path, limits_of(arm), seed));
  const Eigen::Vector2d& tip_m = path.point_m.front();
  RandomStream random(seed, 0);
  const Eigen::MatrixXf first_kpa = posture.at(0.0).cast<float>();
  Candidate found = refined(arm, model, tip_m, nearest_of(arm, model, tip_m, first_kpa), random);
  if (found.distance_m > kStartNearM) {
    const Candidate nearest =
        refined(arm, model, tip_m, nearest_sample(arm, model, tip_m, random), random);
    found = std::ranges::min(found, nearest, {}, &Candidate::distance_m);
  }
  return {std::move(posture), found.setpoint_kpa, found.distance_m};
}

}  // namespace limber
