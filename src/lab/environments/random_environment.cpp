#include "limber/lab/random_environment.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/lab/environment_measures.hpp"
#include "limber/world/collision.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kEnvironmentStream = 0x656e76ULL << 32;
constexpr int kMaxWaypoints = 3;
constexpr double kMinTravelM = 0.15;  // of the tip, from start to goal
constexpr int kTriesPerObstacle = 30;
constexpr int kStraightLineStarts = 20;

/// Builds one environment about one random motion.
class EnvironmentSampler {
 public:
  EnvironmentSampler(const ArmDescription& arm, const MotionModel& model,
                     const RandomEnvironmentSettings& settings, RandomStream& random)
      : arm_(arm),
        model_(model),
        settings_(settings),
        random_(random),
        nothing_(arm, {}),
        simulator_(arm, model, nothing_) {
    result_.environment.start = settings.start;
  }

  std::optional<RandomEnvironment> sample() {
    draw_motion();
    const Pose tip = tip_pose(motion_.back().backbone);
    const Pose start = tip_pose(motion_.front().backbone);
    if (std::hypot(tip.x_m - start.x_m, tip.y_m - start.y_m) < kMinTravelM) {
      return std::nullopt;
    }
    result_.environment.goal =
        random_goal(tip, settings_.position_tolerance_m, settings_.orientation_tolerance_rad,
                    settings_.orientation_share, random_);
    const int wanted =
        settings_.min_obstacles + static_cast<int>(random_.index(static_cast<std::uint32_t>(
                                      settings_.max_obstacles - settings_.min_obstacles + 1)));
    for (int k = 0; k < wanted * kTriesPerObstacle &&
                    static_cast<int>(result_.environment.obstacles.size()) < wanted;
         ++k) {
      add_obstacle(result_.environment.obstacles.empty());
    }
    const PlanningProblem problem{arm_, model_, result_.environment};
    const Pressures& end = result_.witness_kpa.back();
    if (static_cast<int>(result_.environment.obstacles.size()) < wanted ||
        !straight_line_collides(problem, end) ||
        straight_line_solves(problem, {end}, kStraightLineStarts, random_.next_u32())) {
      return std::nullopt;
    }
    return std::move(result_);
  }

 private:
  Pressures random_pressures() {
    Pressures q(arm_.channel_count());
    for (int i = 0; i < q.size(); ++i) {
      const PressureLimits& limits = arm_.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
      q[i] = static_cast<float>(random_.uniform(limits.lower_kpa, limits.upper_kpa));
    }
    return q;
  }

  void draw_motion() {
    const ArmStart rest = start_state(result_.environment, arm_);
    motion_.assign(1, {rest.pressures_kpa, rest.pressures_kpa, rest.backbone});
    straight_ = motion_;
    result_.witness_kpa.assign(1, rest.pressures_kpa);
    const int waypoints = 2 + static_cast<int>(random_.index(kMaxWaypoints - 1));
    for (int k = 0; k < waypoints; ++k) {
      result_.witness_kpa.push_back(random_pressures());
      simulator_.append_motion(result_.witness_kpa.back(), motion_);
    }
    simulator_.append_hold(motion_);
    simulator_.append_motion(result_.witness_kpa.back(), straight_);
  }

  /// A point near the arm on the straight motion, which is to be blocked, or near the witness.
  Eigen::Vector2d random_point(bool on_straight_line) {
    const std::vector<PlanFrame>& frames = on_straight_line ? straight_ : motion_;
    const Backbone& b = frames[random_.index(static_cast<std::uint32_t>(frames.size()))].backbone;
    const auto plate =
        static_cast<Eigen::Index>(random_.index(static_cast<std::uint32_t>(arm_.point_count())));
    const double spread = on_straight_line ? 0.02 : 0.15 * arm_.length_m();
    return {b(plate, 0) + spread * random_.normal(), b(plate, 1) + spread * random_.normal()};
  }

  /// Adds one obstacle where the witness stays clear of it.
  void add_obstacle(bool on_straight_line) {
    const Obstacle obstacle =
        random_obstacle(size_unit(arm_), random_point(on_straight_line), random_);
    const CollisionChecker checker(arm_, {obstacle}, settings_.clearance_m);
    for (std::size_t k = 1; k < motion_.size(); ++k) {
      if (!checker.is_motion_free(motion_[k - 1].backbone, motion_[k].backbone)) {
        return;
      }
    }
    result_.environment.obstacles.push_back(obstacle);
  }

  const ArmDescription& arm_;
  const MotionModel& model_;
  const RandomEnvironmentSettings& settings_;
  RandomStream& random_;
  CollisionChecker nothing_;
  MotionSimulator simulator_;
  std::vector<PlanFrame> motion_;
  std::vector<PlanFrame> straight_;
  RandomEnvironment result_;
};

}  // namespace

std::optional<RandomEnvironment> random_environment(const ArmDescription& arm,
                                                    const MotionModel& model, std::uint64_t seed,
                                                    std::uint64_t number,
                                                    const RandomEnvironmentSettings& settings) {
  RandomStream random(seed, kEnvironmentStream + number);
  for (int attempt = 0; attempt < settings.attempts; ++attempt) {
    std::optional<RandomEnvironment> sampled =
        EnvironmentSampler(arm, model, settings, random).sample();
    if (sampled) {
      sampled->environment.name = fmt::format("random {} of seed {}", number, seed);
      return sampled;
    }
  }
  return std::nullopt;
}

}  // namespace limber
