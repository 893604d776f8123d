#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/planning/planner.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/rest_miss.hpp"
#include "limber/world/collision.hpp"

namespace limber {

/// About what the tracker's noise hides. An arm nearer to the goal's centre than that is left
/// alone. [m]
inline constexpr double kMinGainM = 0.001;

struct ReplannerSettings {
  /// Of each search; a number of queries, so that runs in simulated time can be repeated.
  std::uint64_t queries = 20000;
  int max_replans = 24;
  int planner_jobs = 1;
  /// Of set points, where they are narrower than the arm's; empty: the arm's. Plans stay within
  /// them, and within those of the plan that runs.
  std::vector<PressureLimits> limits = {};
};

/// Of plans that follow `plan`: its own, as its end is within them, and what the run allows. Empty:
/// the arm's.
std::vector<PressureLimits> limits_after(const Plan& plan,
                                         const std::vector<PressureLimits>& in_force);

/// Plans again from where the arm is measured, whenever it stands: after a plan that ended off the
/// goal, and where it has strayed so far from its plan that it comes near an obstacle. Every
/// plan is certified. Small corrections from rest are predicted well, since the network's error
/// grows with the motion: of many that are sampled, the one that ends nearest. They end where the
/// arm is so near that the next one is no likely gain. An arm well inside the goal gets none that
/// leaves it on the way. What the model misses all the same, where a correction ended beside its
/// prediction, shifts the goal of the next one, by at most 10 cm.
///
/// Borrows arm, model and environment; the model has a network. Without tracking it asks for no
/// plan: the run is then open loop.
class Replanner {
 public:
  Replanner(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
            const ErrorRoom& room, const ReplannerSettings& settings, std::uint64_t seed);

  /// Whether an arm that is seen there (none: nowhere) in a frame of the plan may follow its rest.
  bool may_go_on(const Plan& plan, std::size_t frame, const std::optional<Backbone>& seen);
  /// The plan to follow from where the arm rests after that frame of a plan.
  /// @param held_kpa  set points that it has
  /// @param missed    by the model, of an arm at rest, as far as it is known
  std::optional<Plan> next(const Plan& plan, std::size_t frame, const Pressures& held_kpa,
                           const std::optional<Backbone>& rest, const RestMiss& missed);

  /// The goal that the last plan was made for: shifted by what the model misses.
  const PoseGoal& aim() const { return aim_; }
  /// What it was certified for.
  const Environment& planned_for() const { return planned_for_; }
  /// Whether the last plan was for an arm whose plan had ended, or that stood in the goal.
  bool is_correction() const { return is_correction_; }
  /// Plans that were found so far.
  int replans() const { return replans_; }
  /// What is known of it since.
  const RestMiss& missed() const { return missed_; }

 private:
  double clearance_m(const Backbone& shape) const { return near_.clearance(shape).value_m; }
  std::uint64_t seed_of_next() const { return seed_ + std::uint64_t(replans_); }
  bool has_more_to_gain(double error_m, bool has_arrived) const;
  void learn_from(const Plan& ended, const Pose& measured);
  bool stays_in_goal(const Plan& plan) const;
  std::optional<Plan> search(const Plan& before, const Environment& from_here, double margin_m,
                             bool is_last_resort);
  std::optional<Plan> search_less_and_less(const Plan& before, Environment from_here,
                                           bool is_halted);
  using IsTaken = std::function<bool(const Plan&)>;
  std::optional<Plan> short_correction(const Plan& before, const Environment& from_here,
                                       double error_m, const IsTaken& is_taken);
  PlanningProblem problem_from(const Plan& before, const Environment& from_here, double margin_m);
  std::optional<Plan> nearer(const Plan& before, Environment from_here, double error_m);

  const ArmDescription& arm_;
  MotionModel model_;
  const Environment& environment_;
  ErrorRoom room_;
  ReplannerSettings settings_;
  std::uint64_t seed_;
  CollisionChecker near_;  // what touches this arm is too near to go on beside
  std::unique_ptr<Planner> planner_;
  PoseGoal aim_;
  Environment planned_for_;
  int replans_ = 0;
  bool has_halted_in_vain_ = false;  // the arm, halted, asked and found no plan
  bool is_correction_ = false;       // what the arm follows
  int stuck_ = 0;                    // corrections in a row that hardly moved the arm
  RestMiss missed_;
};

}  // namespace limber
