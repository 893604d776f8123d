#include "limber/run/replanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/planning/planner_factory.hpp"
#include "plan_repair.hpp"
#include "sampled_motions.hpp"

namespace limber {

namespace {

/// What is asked of a correction, the most first: share of the goal's tolerances that it ends
/// within, share of the room for the model's error that it keeps from obstacles. That error is one
/// of long motions; a correction is short.
struct Asked {
  double tolerance;
  double margin;
};
/// A search usually asks 25 times in an iteration. From where every motion strikes at once it asks
/// once or not at all, and would go on for minutes.
constexpr std::uint64_t kQueriesPerIteration = 5;
/// Times the queries of a search, for an arm that was halted and found no way on, or that stands
/// outside its goal and found none: it would stay there.
constexpr std::uint64_t kQueriesOfLastResort = 25;
/// Of the goal's tolerance: near enough. Corrections of an arm with
/// friction end some 4 mm beside their predictions: where the tolerance is 2 cm, from nearer than
/// this the next one is no likely gain (docs/experiments.md, Disturbances).
constexpr double kNearEnough = 0.1;
/// More of the tolerance with each plan after so many: an arm that needed them is hard to place.
constexpr double kNearEnoughLater = 0.01;
constexpr int kPlansBeforeLater = 6;
/// What a sampled correction has to end within: of the distance that is left, and of the tolerance.
constexpr double kOfNow = 0.8;
constexpr double kFarthest = 0.6;
/// Up to that share of the tolerance it may be a little more than the distance that is left: moved,
/// an arm that friction holds ends somewhere else, which is worth as much as a good prediction.
constexpr double kNear = 0.5;
constexpr double kOfNowNear = 1.3;
/// SampledMotion::effort: friction holds an arm that is moved by less. Twice as much is better, a
/// few times at most, after each correction that moved the arm by less than that share of what was
/// predicted.
constexpr double kLeastEffort = 0.05;
constexpr double kHardlyMoved = 0.25;
constexpr int kMaxDoublings = 3;
constexpr double kNearObstacleM = 0.01;
/// Of the distance that is left, where no plan ends in the goal.
constexpr double kNearerShare = 0.8;
/// Of the goal's tolerance: an arm this near to the centre is not led out of the goal again.
constexpr double kHeldInside = 0.5;
/// Cost of a correction, of a pressure scale: less moves no arm.
constexpr double kLeastCost = 0.01;
constexpr double kNearOfClearance =
    0.5;  // of the plan's own, where that is less than kNearObstacleM
constexpr double kLeastMargin = 0.25;
/// Of how far a plate moves in a sampled correction: kept from obstacles, since the model errs by
/// more where an arm swings far to end nearer.
constexpr double kOfSwing = 0.1;
constexpr std::array kAsked = {Asked{0.1, 1.0}, Asked{0.1, kLeastMargin}, Asked{1.0, kLeastMargin}};
/// Of an arm that was halted: its way is long again.
constexpr std::array kAskedOfHalted = {Asked{0.1, 1.0}, Asked{1.0, 1.0}};

double swing_m(const Plan& plan) {
  double farthest_m = 0.0;
  for (const PlanFrame& frame : plan.frames) {
    farthest_m = std::max(farthest_m,
                          largest_plate_distance_m(frame.backbone, plan.frames.front().backbone));
  }
  return farthest_m;
}

}  // namespace

Replanner::Replanner(const ArmDescription& arm, const MotionModel& model,
                     const Environment& environment, const ErrorRoom& room,
                     const ReplannerSettings& settings, std::uint64_t seed)
    : arm_(arm),
      model_(model),
      environment_(environment),
      room_(room),
      settings_(settings),
      seed_(seed),
      near_(arm, environment.obstacles),
      planner_(make_planner("default", settings.planner_jobs)),
      aim_(environment.goal) {}

bool Replanner::may_go_on(const Plan& plan, std::size_t frame,
                          const std::optional<Backbone>& seen) {
  if (!seen || replans_ >= settings_.max_replans) {
    return true;
  }
  // No obstacle is nearer to the plan than its clearance, so that much is always allowed.
  const bool strays =
      !(largest_plate_distance_m(*seen, plan.frames[frame].backbone) < plan.clearance_m);
  return !strays ||
         clearance_m(*seen) >= std::min(kNearObstacleM, kNearOfClearance * plan.clearance_m);
}

bool Replanner::has_more_to_gain(double error_m, bool has_arrived) const {
  const double near_enough =
      kNearEnough + kNearEnoughLater * std::max(0, replans_ - kPlansBeforeLater);
  return error_m >= kMinGainM &&
         (!has_arrived || error_m >= near_enough * environment_.goal.position_tolerance_m);
}

std::vector<PressureLimits> limits_after(const Plan& plan,
                                         const std::vector<PressureLimits>& in_force) {
  if (plan.limits.empty() || in_force.empty()) {
    return plan.limits.empty() ? in_force : plan.limits;
  }
  std::vector<PressureLimits> limits = in_force;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    limits[i] = limits[i].within(plan.limits[i]);
  }
  return limits;
}

void Replanner::learn_from(const Plan& ended, const Pose& measured) {
  if (!is_correction_) {
    return;  // a long way, on which the arm was led
  }
  const Pose expected = tip_pose(ended.frames.back().backbone);
  const Pose start = tip_pose(ended.frames.front().backbone);
  const double moved_m = difference(measured, start).head<2>().norm();
  const double wanted_m = (difference(expected, start) - missed_.creep()).head<2>().norm();
  stuck_ = moved_m < kHardlyMoved * wanted_m ? stuck_ + 1 : 0;
  missed_.learn(expected, measured);
}

/// As the arm will go, and not as the model has it: without creep.
bool Replanner::stays_in_goal(const Plan& plan) const {
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    const Eigen::Vector3d off = missed_.creep(k);
    Pose tip = tip_pose(plan.frames[k].backbone);
    tip.x_m -= off.x();
    tip.y_m -= off.y();
    tip.theta_rad -= off.z();
    if (!is_within(environment_.goal, pose_error(environment_.goal, tip))) {
      return false;
    }
  }
  return true;
}

std::optional<Plan> Replanner::search(const Plan& before, const Environment& from_here,
                                      double margin_m, bool is_last_resort) {
  PlanningProblem problem = problem_from(before, from_here, margin_m);
  problem.margin_yields_to_start = true;
  PlannerLimits limits;
  limits.queries = (is_last_resort ? kQueriesOfLastResort : 1) * settings_.queries;
  limits.iterations = std::max<std::uint64_t>(1, *limits.queries / kQueriesPerIteration);
  return planner_
      ->plan(problem, limits, seed_of_next(),
             [](const PlannerProgress&) { return !interrupt_requested(); })
      .plan;
}

std::optional<Plan> Replanner::next(const Plan& plan, std::size_t frame, const Pressures& held_kpa,
                                    const std::optional<Backbone>& rest, const RestMiss& missed) {
  missed_ = missed;
  if (!rest || replans_ >= settings_.max_replans) {
    return std::nullopt;
  }
  const Pose measured = tip_pose(*rest);
  const PoseError error = pose_error(environment_.goal, measured);
  const double error_m = as_length_m(environment_.goal, error);
  const bool has_ended = frame + 1 == plan.frames.size();
  const bool has_arrived = is_within(environment_.goal, error);
  const bool halted = !has_ended && !has_arrived;
  if (has_ended) {
    learn_from(plan, measured);
  }
  // Millimetres are not worth a collision: an arm in the goal keeps all of the room.
  const double kept_m = has_arrived ? room_.margin_m : -std::numeric_limits<double>::infinity();
  if (halted) {
    missed_.forget_creep();
  } else if (has_more_to_gain(error_m, has_arrived) && clearance_m(*rest) >= kept_m) {
    missed_.note_creep(model_, held_kpa, plan.hold_frame_count, *rest);
  } else {
    return std::nullopt;
  }
  Environment from_here = environment_;
  from_here.start = ArmStart{held_kpa, *rest};
  aim_ = asked_goal(environment_.goal, missed_.expected());
  from_here.goal = aim_;
  const bool is_well_inside =
      !halted && error_m <= kHeldInside * environment_.goal.position_tolerance_m;
  const double least_cost_kpa = kLeastCost * double(pressure_scales_kpa(arm_).mean());
  const IsTaken is_taken = [&](const Plan& found) {
    return (halted || found.cost_kpa >= least_cost_kpa) && found.clearance_m >= kept_m &&
           (!is_well_inside || stays_in_goal(found));
  };
  const auto if_taken = [&](std::optional<Plan> found) {
    return found && is_taken(*found) ? std::move(found) : std::nullopt;
  };
  std::optional<Plan> found;
  if (!halted) {
    found = if_taken(short_correction(plan, from_here, error_m, is_taken));
  }
  if (!found) {
    found = if_taken(search_less_and_less(plan, from_here, halted));
  }
  if (!found && !halted && !has_arrived) {
    from_here.goal.position_tolerance_m = aim_.position_tolerance_m;
    from_here.goal.orientation_tolerance_rad = aim_.orientation_tolerance_rad;
    found = if_taken(search(plan, from_here, kLeastMargin * room_.margin_m, true));
  }
  if (!found && !halted) {
    found = if_taken(nearer(plan, from_here, as_length_m(aim_, pose_error(aim_, measured))));
  }
  has_halted_in_vain_ = halted && !found;
  if (!found) {
    return std::nullopt;
  }
  ++replans_;
  is_correction_ = !halted;
  return found;
}

std::optional<Plan> Replanner::search_less_and_less(const Plan& before, Environment from_here,
                                                    bool is_halted) {
  for (const Asked& asked : is_halted ? std::span<const Asked>(kAskedOfHalted) : kAsked) {
    from_here.goal.position_tolerance_m = asked.tolerance * aim_.position_tolerance_m;
    from_here.goal.orientation_tolerance_rad = asked.tolerance * aim_.orientation_tolerance_rad;
    if (std::optional<Plan> found =
            search(before, from_here, asked.margin * room_.margin_m, has_halted_in_vain_)) {
      return found;
    }
  }
  return std::nullopt;
}

/// From where the arm rests to where the model has it near the aim, without looking for ways
/// around anything.
std::optional<Plan> Replanner::short_correction(const Plan& before, const Environment& from_here,
                                                double error_m, const IsTaken& is_taken) {
  const double tolerance_m = aim_.position_tolerance_m;
  const double near_m = std::min(kOfNowNear * error_m, kNear * tolerance_m);
  const SampledPlanAsked asked{
      std::min(kFarthest * tolerance_m, std::max(near_m, kOfNow * error_m)), kLeastEffort,
      std::ldexp(kLeastEffort, std::min(stuck_, kMaxDoublings))};
  const PlanCheck certified = certificate_check(arm_, model_);
  const PlanCheck check = [&](Plan& plan, const Environment& environment) {
    return plan.clearance_m >= kOfSwing * swing_m(plan) && is_taken(plan) &&
           certified(plan, environment);
  };
  const std::vector<SampledMotion> motions =
      sampled_motions(problem_from(before, from_here, 0.0), settings_.queries, seed_of_next());
  for (const double share : {1.0, kLeastMargin}) {
    if (std::optional<Plan> found =
            sampled_plan(problem_from(before, from_here, share * room_.margin_m), motions, asked,
                         seed_of_next(), check)) {
      return found;
    }
  }
  return std::nullopt;
}

/// Of the plan that is made next.
PlanningProblem Replanner::problem_from(const Plan& before, const Environment& from_here,
                                        double margin_m) {
  planned_for_ = from_here;
  PlanningProblem problem{arm_, model_, from_here, margin_m};
  problem.limits = limits_after(before, settings_.limits);
  return problem;
}

/// As near to the aim as a straight motion comes, where that is clearly nearer than the arm is. For
/// the model an arm that is held is nearer too, by its creep; but an arm that stands short of the
/// goal had better be moved a little than not at all (docs/experiments.md, Disturbances).
std::optional<Plan> Replanner::nearer(const Plan& before, Environment from_here, double error_m) {
  const double max_error_m = kNearerShare * error_m;
  if (!(error_m - max_error_m >= kMinGainM)) {
    return std::nullopt;
  }
  const double widened = std::max(1.0, max_error_m / aim_.position_tolerance_m);
  from_here.goal.position_tolerance_m *= widened;
  from_here.goal.orientation_tolerance_rad *= widened;
  const Pressures& held_kpa = from_here.start->pressures_kpa;
  return repaired_plan(problem_from(before, from_here, kLeastMargin * room_.margin_m),
                       {held_kpa, held_kpa}, max_error_m, seed_of_next(),
                       certificate_check(arm_, model_));
}

}  // namespace limber
