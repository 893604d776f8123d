#include "styled_environment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limber/common/random_stream.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/lab/environment_findings.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/planner.hpp"
#include "limber/world/collision.hpp"
#include "random_obstacle.hpp"

namespace limber {

namespace {

constexpr int kObstacleDraws = 300;
constexpr double kMinBend = 0.35;  // of the limit, of every segment at the end of the hidden motion
constexpr double kMinTravelM = 0.25;   // of the tip; less is no task
constexpr double kGapLargestM = 0.22;  // a wider way through a wall is no gap
constexpr double kWallLengthM = 0.22;  // of the wall on either side of the gap
constexpr double kWallWidthM = 0.03;
constexpr double kGoalToleranceM = 0.02;
constexpr double kGoalToleranceRad = 0.3;

/// One draw: a motion, and obstacles about it.
class Draft {
 public:
  Draft(const ArmDescription& arm, const MotionModel& model, const StyleSettings& settings,
        std::uint64_t seed, std::uint64_t stream)
      : arm_(arm), model_(model), settings_(settings), random_(seed, stream) {}

  std::optional<StyledEnvironment> draw() {
    const std::vector<Pressures> waypoints = draw_waypoints();
    hidden_ = simulate(waypoints);
    straight_ = simulate({waypoints.front(), waypoints.back()});
    if (!is_worth_planning()) {
      return std::nullopt;
    }
    set_goal();
    if (settings_.style == EnvironmentStyle::gap_in_a_wall && !place_wall()) {
      return std::nullopt;
    }
    if (settings_.narrow && settings_.style != EnvironmentStyle::gap_in_a_wall && !place_gate()) {
      return std::nullopt;
    }
    if (!block_straight_line()) {
      return std::nullopt;
    }
    crowd();
    return finish(waypoints);
  }

 private:
  Pressures draw_end() {
    Pressures end(arm_.segment_count());
    for (int i = 0; i < arm_.segment_count(); ++i) {
      const PressureLimits& limits = arm_.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
      const double sign = random_.uniform() < 0.5 ? -1.0 : 1.0;
      end[i] = static_cast<float>(limits.side_kpa(sign) * random_.uniform(kMinBend, 1.0));
    }
    return end;
  }

  /// From rest to the end: in between, some segments are there already and some have not begun, and
  /// with overshoot one is bent the other way first.
  std::vector<Pressures> draw_waypoints() {
    const Pressures end = draw_end();
    std::vector<Pressures> waypoints = {Pressures::Zero(arm_.segment_count())};
    for (int k = 1; k < settings_.waypoints; ++k) {
      Pressures next = waypoints.back();
      for (Eigen::Index i = 0; i < end.size(); ++i) {
        next[i] = random_.uniform() < 0.5 ? end[i] : next[i];
      }
      if (settings_.overshoot && k == 1) {
        const auto reversed =
            static_cast<Eigen::Index>(random_.index(static_cast<std::uint32_t>(end.size())));
        next[reversed] = -end[reversed] * static_cast<float>(random_.uniform(0.3, 0.9));
      }
      waypoints.push_back(next);
    }
    waypoints.push_back(end);
    return waypoints;
  }

  Plan simulate(const std::vector<Pressures>& waypoints) {
    const CollisionChecker nothing_in_the_way(arm_, {});
    MotionSimulator simulator(arm_, model_, nothing_in_the_way);
    const PlanningProblem problem{arm_, model_, environment_, 0.0};
    return build_plan(problem, simulator, waypoints, "hidden", 0);
  }

  bool is_worth_planning() const {
    const auto tip = [](const PlanFrame& frame) { return tip_pose(frame.backbone); };
    const Pose from = tip(hidden_.frames.front());
    const Pose to = tip(hidden_.frames.back());
    return std::hypot(to.x_m - from.x_m, to.y_m - from.y_m) > kMinTravelM;
  }

  void set_goal() {
    const Pose tip = tip_pose(hidden_.frames.back().backbone);
    const auto millimetres = [](double x) { return std::round(1e3 * x) / 1e3; };
    PoseGoal& goal = environment_.goal;
    goal.x_m = millimetres(tip.x_m);
    goal.y_m = millimetres(tip.y_m);
    goal.position_tolerance_m = kGoalToleranceM;
    goal.orientation_tolerance_rad = kGoalToleranceRad;
    if (settings_.orientation) {
      goal.theta_rad = std::round(1e2 * tip.theta_rad) / 1e2;
    }
  }

  /// Least clearance of a motion from one obstacle; gives up below `min_of_interest`.
  double clearance_m(const Plan& motion, const Obstacle& obstacle, double min_of_interest) const {
    const CollisionChecker checker(arm_, {obstacle});
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < motion.frames.size() && least >= min_of_interest; ++k) {
      least = std::min(
          least, checker.motion_clearance(motion.frames[k - 1].backbone, motion.frames[k].backbone)
                     .value_m);
    }
    return least;
  }

  bool accept(const Obstacle& obstacle, double max_clearance_m) {
    const double clearance = clearance_m(hidden_, obstacle, settings_.min_clearance_m);
    if (clearance < settings_.min_clearance_m || clearance > max_clearance_m) {
      return false;
    }
    environment_.obstacles.push_back(obstacle);
    return true;
  }

  /// A plate of the arm, not the first two, at some frame of a motion.
  PlacedPlate draw_plate(const Plan& motion) {
    const PlanFrame& frame =
        motion.frames[random_.index(static_cast<std::uint32_t>(motion.frames.size()))];
    const auto points = static_cast<std::uint32_t>(frame.backbone.rows());
    const auto plate = static_cast<Eigen::Index>(2 + random_.index(points - 2));
    const int gap = std::min(static_cast<int>(plate), arm_.point_count() - 2);
    const Segment& segment = arm_.segments[static_cast<std::size_t>(arm_.segment_of_gap(gap))];
    return {frame.backbone(plate, 0), frame.backbone(plate, 1), frame.backbone(plate, 2),
            0.5 * segment.width_m + arm_.actuator_radius_m};
  }

  bool block_straight_line() {
    for (int k = 0; k < kObstacleDraws; ++k) {
      if (straight_line_collides()) {
        return true;
      }
      const Obstacle obstacle = draw_obstacle_at(settings_.style, draw_plate(straight_), random_);
      if (clearance_m(straight_, obstacle, -0.01) < -0.005) {
        accept(obstacle, std::numeric_limits<double>::infinity());
      }
    }
    return false;
  }

  bool straight_line_collides() const {
    return std::any_of(
        environment_.obstacles.begin(), environment_.obstacles.end(),
        [&](const Obstacle& obstacle) { return clearance_m(straight_, obstacle, 0.0) < 0.0; });
  }

  /// More obstacles close beside the hidden motion, so that it has to be followed closely.
  void crowd() {
    for (int k = 0; k < kObstacleDraws &&
                    static_cast<int>(environment_.obstacles.size()) < settings_.obstacles;
         ++k) {
      const double clearance =
          random_.uniform(settings_.min_clearance_m, settings_.max_clearance_m);
      accept(draw_obstacle_beside(settings_.style, draw_plate(hidden_), clearance,
                                  random_.uniform() < 0.5 ? -1.0 : 1.0, random_),
             settings_.max_clearance_m);
    }
  }

  /// The widest that counts as narrow at a plate.
  static double narrow_m(const PlacedPlate& plate) {
    return kNarrowWidths * 2.0 * plate.radius_m + kNarrowExtraM;
  }

  /// Two obstacles, one on either side of a plate at some moment, a narrow passage apart.
  bool place_gate() {
    constexpr double kAny = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kObstacleDraws; ++k) {
      const PlacedPlate plate = draw_plate(hidden_);
      const double room = 0.5 * narrow_m(plate) - plate.radius_m;
      const double left = room * random_.uniform(0.6, 0.95);
      if (accept(draw_obstacle_beside(settings_.style, plate, left, 1.0, random_), kAny)) {
        const double right = room * random_.uniform(0.6, 0.95);
        if (accept(draw_obstacle_beside(settings_.style, plate, right, -1.0, random_), kAny)) {
          return true;
        }
        environment_.obstacles.pop_back();
      }
    }
    return false;
  }

  /// A wall across the way, its gap as wide as the hidden motion needs and the clearance.
  bool place_wall() {
    for (int k = 0; k < kObstacleDraws; ++k) {
      const PlacedPlate plate = draw_plate(hidden_);
      const WallLine line = draw_wall_line(plate, random_);
      double low = std::numeric_limits<double>::infinity();
      double high = -low;
      for (const PlanFrame& frame : hidden_.frames) {
        widen_by_crossing(line, arm_, frame.backbone, kWallWidthM, low, high);
      }
      const double room = random_.uniform(settings_.min_clearance_m, settings_.max_clearance_m);
      const double max_m = settings_.narrow ? narrow_m(plate) : kGapLargestM;
      if (!(high - low + 2.0 * room < max_m)) {
        continue;
      }
      const Obstacle left = wall_piece(line, high + room, high + room + kWallLengthM, kWallWidthM);
      const Obstacle right = wall_piece(line, low - room - kWallLengthM, low - room, kWallWidthM);
      constexpr double kAny = std::numeric_limits<double>::infinity();
      if (accept(left, kAny)) {
        if (accept(right, kAny)) {
          return true;
        }
        environment_.obstacles.pop_back();
      }
    }
    return false;
  }

  /// The plan once more, now with obstacles and goal, judged as a planner's would be.
  std::optional<StyledEnvironment> finish(const std::vector<Pressures>& waypoints) {
    const CollisionChecker checker(arm_, environment_.obstacles);
    MotionSimulator simulator(arm_, model_, checker);
    const PlanningProblem problem{arm_, model_, environment_, 0.0};
    Plan plan = build_plan(problem, simulator, waypoints, "hidden", 0);
    if (!is_solution(problem, checker, plan)) {
      return std::nullopt;
    }
    return StyledEnvironment{environment_, std::move(plan)};
  }

  const ArmDescription& arm_;
  const MotionModel& model_;
  const StyleSettings& settings_;
  RandomStream random_;
  Environment environment_;
  Plan hidden_;
  Plan straight_;
};

}  // namespace

std::optional<StyledEnvironment> draw_styled(const ArmDescription& arm, const MotionModel& model,
                                             const StyleSettings& settings, std::uint64_t seed,
                                             std::uint64_t number) {
  return Draft(arm, model, settings, seed, number).draw();
}

}  // namespace limber
