#include "limber/lab/witnessed_environment.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "limber/common/interrupt.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/lab/environment_measures.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/hold.hpp"
#include "limber/world/pressure_box.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kEnvironmentStream = 0x656e76ULL << 32;
constexpr int kMaxWaypoints = 3;
constexpr double kMinTravelM = 0.15;  // of the tip, from start to goal: else the arm may stay
constexpr int kFewestObstacles = 2;
constexpr int kMostObstacles = 5;
constexpr int kTriesPerObstacle = 30;
constexpr int kStraightLineStarts = 20;

/// Whether an arm that moves from each shape to the next keeps that far from the obstacle.
template <class Shapes, class ShapeOf = std::identity>
bool is_clear(const ArmDescription& arm, const Obstacle& obstacle, double clearance_m,
              const Shapes& shapes, const ShapeOf& shape_of = {}) {
  const CollisionChecker checker(arm, {obstacle}, clearance_m);
  const auto collides = [&](const Backbone& from, const Backbone& to) {
    return !checker.is_motion_free(from, to);
  };
  return std::ranges::adjacent_find(shapes, collides, shape_of) == shapes.end();
}

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
    result_.environment.goal = random_goal(tip, random_);
    const int wanted = kFewestObstacles + int(random_.index(kMostObstacles - kFewestObstacles + 1));
    for (int k = 0;
         k < wanted * kTriesPerObstacle && int(result_.environment.obstacles.size()) < wanted;
         ++k) {
      add_obstacle(result_.environment.obstacles.empty());
    }
    const PlanningProblem problem{arm_, model_, result_.environment};
    const Pressures& end = result_.witness_kpa.back();
    if (int(result_.environment.obstacles.size()) < wanted ||
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
      const PressureLimits& limits = arm_.segments[i].pressure_limit_kpa;
      q[i] = float(random_.uniform(limits.lower_kpa, limits.upper_kpa));
    }
    return q;
  }

  void draw_motion() {
    const ArmStart rest = start_state(result_.environment, arm_);
    motion_.assign(1, {rest.pressures_kpa, rest.pressures_kpa, rest.backbone});
    straight_ = motion_;
    result_.witness_kpa.assign(1, rest.pressures_kpa);
    const int waypoints = 2 + int(random_.index(kMaxWaypoints - 1));
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
    const Backbone& b = frames[random_.index(std::uint32_t(frames.size()))].backbone;
    const auto plate = Eigen::Index(random_.index(std::uint32_t(arm_.point_count())));
    const double spread = on_straight_line ? 0.02 : 0.15 * arm_.length_m();
    return {b(plate, 0) + spread * random_.normal(), b(plate, 1) + spread * random_.normal()};
  }

  /// Adds one obstacle where the witness stays clear of it.
  void add_obstacle(bool on_straight_line) {
    const Obstacle obstacle =
        random_obstacle(size_unit(arm_), random_point(on_straight_line), random_);
    if (is_clear(arm_, obstacle, settings_.clearance_m, motion_, &PlanFrame::backbone)) {
      result_.environment.obstacles.push_back(obstacle);
    }
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

constexpr double kShapePeriodS = 0.01;  // an arm that speeds up by 5 m/s² leaves a chord by 0.06 mm
constexpr float kSettledShare = 0.01F;  // of the limit: pressures this near have arrived

bool is_settled(const ArmDescription& arm, const VirtualArm& driver, const Pressures& kpa) {
  const Pressures off_kpa = (driver.true_pressure_kpa().cast<float>() - kpa).cwiseAbs();
  const auto band_kpa = float(virtual_arm_parameters(arm).pressure_dead_band_kpa);
  const Pressures near_kpa = kSettledShare * pressure_limits_kpa(arm);
  return (off_kpa.array() <= near_kpa.array().max(band_kpa)).all();
}

std::vector<Backbone> shapes_of_virtual_arm(const ArmDescription& arm,
                                            const std::vector<Pressures>& waypoints_kpa) {
  VirtualArm driver(arm);
  std::vector<Backbone> shapes = {driver.true_backbone().cast<float>()};
  const auto every = std::max(1L, std::lround(kShapePeriodS / driver.time_step_s()));
  driver.set_observer([&shapes, every, step = 0L](double, const BackboneD& shape) mutable {
    if (++step % every == 0) {
      shapes.push_back(shape.cast<float>());
    }
  });
  Pressures at_kpa = start_state(Environment{}, arm).pressures_kpa;
  for (const Pressures& to_kpa : waypoints_kpa) {
    for (const Pressures& sent_kpa :
         straight_setpoints(at_kpa, to_kpa, arm.pressure_step_limit_kpa())) {
      (void)driver.command(sent_kpa);
    }
    at_kpa = to_kpa;
  }
  const int least = arm.frames_in(kHoldS);
  for (int k = 0;
       k < least || (k < arm.frames_in(kLongestHoldS) && !is_settled(arm, driver, at_kpa)); ++k) {
    (void)driver.command(at_kpa);
  }
  shapes.push_back(driver.true_backbone().cast<float>());
  return shapes;
}

constexpr std::uint64_t kWitnessedStream = 0x776974ULL << 32;
constexpr int kAttempts = 100;
constexpr int kMaxMotions = 3;
constexpr int kMinObstacles = 5;
constexpr int kMaxObstacles = 13;
constexpr double kNearM = 0.16;                   // from a plate to an obstacle's middle
constexpr double kClearancesM[] = {0.012, 0.02};  // each of half of the environments

/// One attempt.
class Sampler {
 public:
  Sampler(const ArmDescription& arm, RandomStream& random)
      : arm_(arm), unit_(size_unit(arm)), random_(random) {}

  std::optional<WitnessedEnvironment> sample(const Witness& witness) {
    const PressureBox box = pressure_box(arm_);
    const int motions = 1 + index(kMaxMotions);
    for (int k = 0; k < motions; ++k) {
      result_.waypoints_kpa.push_back(box.sample(random_));
    }
    // A plan starts where the model has the arm at rest, which is to be free too.
    shapes_.assign(1, start_state(result_.environment, arm_).backbone);
    const std::vector<Backbone> moved = witness(result_.waypoints_kpa);
    shapes_.insert(shapes_.end(), moved.begin(), moved.end());
    const Pose start = tip_pose(moved.front());
    const Pose end = tip_pose(moved.back());
    if (std::hypot(end.x_m - start.x_m, end.y_m - start.y_m) < unit_ * kMinTravelM) {
      return std::nullopt;
    }
    result_.environment.goal = random_goal(end, random_);
    result_.clearance_m = unit_ * kClearancesM[index(2)];
    return add_obstacles() ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  int index(int count) { return int(random_.index(std::uint32_t(count))); }

  bool add_obstacles() {
    std::vector<Obstacle>& obstacles = result_.environment.obstacles;
    const auto wanted = std::size_t(kMinObstacles + index(kMaxObstacles - kMinObstacles + 1));
    for (std::size_t k = 0; k < wanted * kTriesPerObstacle && obstacles.size() < wanted; ++k) {
      const Obstacle obstacle = random_obstacle(unit_, random_point(), random_);
      if (is_clear(arm_, obstacle, result_.clearance_m, shapes_)) {
        obstacles.push_back(obstacle);
      }
    }
    return obstacles.size() == wanted;
  }

  Eigen::Vector2d random_point() {
    const Backbone& shape = shapes_[index(int(shapes_.size()))];
    const int plate = index(arm_.point_count());
    const double angle = random_.uniform(0.0, 2.0 * std::numbers::pi);
    const double away_m = unit_ * kNearM * random_.uniform();
    return {double(shape(plate, 0)) + away_m * std::cos(angle),
            double(shape(plate, 1)) + away_m * std::sin(angle)};
  }

  const ArmDescription& arm_;
  double unit_;
  RandomStream& random_;
  std::vector<Backbone> shapes_;
  WitnessedEnvironment result_;
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

Witness virtual_witness(const ArmDescription& arm) {
  return [&arm](const std::vector<Pressures>& waypoints_kpa) {
    return shapes_of_virtual_arm(arm, waypoints_kpa);
  };
}

Witness model_witness(const ArmDescription& arm, const MotionModel& model) {
  return [&arm, model](const std::vector<Pressures>& waypoints_kpa) {
    const CollisionChecker nothing(arm, {});
    MotionSimulator simulator(arm, model, nothing);
    const ArmStart rest = start_state(Environment{}, arm);
    std::vector<PlanFrame> frames{{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
    for (const Pressures& to_kpa : waypoints_kpa) {
      simulator.append_motion(to_kpa, frames);
    }
    simulator.append_hold(frames);
    std::vector<Backbone> shapes(frames.size());
    std::ranges::transform(frames, shapes.begin(), &PlanFrame::backbone);
    return shapes;
  };
}

std::optional<WitnessedEnvironment> witnessed_environment(const ArmDescription& arm,
                                                          const Witness& witness,
                                                          std::uint64_t seed,
                                                          std::uint64_t number) {
  RandomStream random(seed, kWitnessedStream + number);
  for (int k = 0; k < kAttempts; ++k) {
    throw_if_interrupted();
    if (std::optional<WitnessedEnvironment> sampled = Sampler(arm, random).sample(witness)) {
      sampled->environment.name = fmt::format("random {} of seed {}", number, seed);
      return sampled;
    }
  }
  return std::nullopt;
}

}  // namespace limber
