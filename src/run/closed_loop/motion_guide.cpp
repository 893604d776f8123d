#include "motion_guide.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "limber/common/interrupt.hpp"
#include "limber/run/replanner.hpp"
#include "plan_repair.hpp"

namespace limber {

namespace {

/// Of the room, what a plan that is made in motion keeps: more, so that it is not given up at once.
constexpr double kRoomOfNewPlans = 0.5;
constexpr double kOfPromised = 0.9;  // of a plan's own clearance, where that is less
/// Of the goal's tolerance: an arm that will end farther from the goal than promised by more than
/// that strays. Less is left to the corrections, which are predicted better.
constexpr double kStrays = 0.5;
/// An arm whose way is free for less is halted at once. One that came as near as forecasts let it
/// touched what it was halted for in 6 of 83 runs, and found another way no more often.
constexpr double kFreeS = 1.0;
/// Times as far off its plan as the arm is, it has to be free in the next second, or the plan
/// waits: with more friction than the model knows, arms slide off by centimetres in a few frames.
constexpr float kTimesOff = 4.0F;
/// From here on a forecast that strikes counts at once. What lies farther ahead counts from the
/// second such forecast in a row on: a tracker's noise makes single ones, as networks that read
/// velocities amplify it, and the way that avoids what is not there ends farther from the goal.
constexpr double kStrikesSoonS = 0.3;

std::vector<Pressures> setpoints_after(const Plan& plan, std::size_t next) {
  std::vector<Pressures> rest;
  for (std::size_t k = next + 1; k < plan.frames.size(); ++k) {
    rest.push_back(plan.frames[k].setpoint_kpa);
  }
  return rest;
}

bool is_at_rest(const std::vector<Pressures>& rest, const Pressures& now) {
  return std::all_of(rest.begin(), rest.end(), [&](const Pressures& kpa) { return kpa == now; });
}

Eigen::Vector3d bounded(const Eigen::Vector3d& miss, double max_m) {
  const double size_m = miss.head<2>().norm();
  return size_m > max_m ? Eigen::Vector3d(miss * (max_m / size_m)) : miss;
}

/// What the model will miss by the end, if it goes on as it did: as much for each kPa.
Eigen::Vector3d miss_ahead(const ModelMiss& miss, const std::vector<Pressures>& rest,
                           const Pressures& from_kpa) {
  constexpr double kMaxMissM = 0.02;
  double ahead_kpa = 0.0;
  Pressures before = from_kpa;
  for (const Pressures& kpa : rest) {
    ahead_kpa += double((kpa - before).cwiseAbs().sum());
    before = kpa;
  }
  const double share =
      miss.travelled_kpa > 0.0 ? std::min(1.0, ahead_kpa / miss.travelled_kpa) : 0.0;
  return bounded(share * miss.sum, kMaxMissM);
}

/// By what the model's forecasts were off recently. Where a plate was off by more than its whole
/// room, none of them waits for its room to grow.
void widen(PlateRoom& room, const Eigen::VectorXd& missed_m, double kept_m) {
  if (room.full_m.empty()) {
    room.full_m.resize(std::size_t(missed_m.size()), 0.0);
  }
  bool is_wider = false;
  for (Eigen::Index plate = 0; plate < missed_m.size(); ++plate) {
    const double more_m = missed_m[plate] - kept_m;
    is_wider = is_wider || more_m > room.full_m[plate];
    room.full_m[plate] = std::max(room.full_m[plate], more_m);
  }
  if (is_wider) {
    room.growth = {};
  }
}

/// Simulates set points frame by frame, with the clearance of every motion between frames.
/// @param setpoint_kpa  of frame k = 0 … frames − 1, the arm being in that state before it
/// @param needed_m  what has to be kept from obstacles, beyond the checker's own margins
RestForecast forecast(
    const MotionModel& model, const CollisionChecker& checker, MotionState state,
    std::size_t frames,
    const std::function<Pressures(std::size_t k, const MotionState& before)>& setpoint_kpa,
    double needed_m) {
  RestForecast result;
  double smallest_m = std::numeric_limits<double>::infinity();  // clearance so far
  MotionModel::Workspace workspace;
  Backbone before = state.backbone;
  for (std::size_t k = 0; k < frames; ++k) {
    before = state.backbone;
    model.step(setpoint_kpa(k, state), state, workspace);
    const Clearance clearance = checker.motion_clearance(before, state.backbone, smallest_m);
    smallest_m = clearance.value_m;
    if (result.is_safe() && !(clearance.value_m >= needed_m)) {
      result.unsafe_frame = int(k);
      result.unsafe_obstacle = clearance.obstacle;
    }
  }
  result.end = tip_pose(state.backbone);
  return result;
}

}  // namespace

MotionGuide::MotionGuide(const ArmDescription& arm, const MotionModel& model,
                         const Environment& environment, const ErrorRoom& room,
                         const ClosedLoopSettings& settings, Planner& planner, PlanCheck check,
                         std::uint64_t seed)
    : arm_(arm),
      model_(model),
      environment_(environment),
      room_(room),
      settings_(settings),
      planner_(planner),
      check_(std::move(check)),
      seed_(seed) {}

PlateRoom MotionGuide::room_in_motion(const Plan& plan) const {
  PlateRoom room;
  if (plan.tube) {
    room = {plan.tube->plate_radius_m, plan.tube->growth, plan.frames.front().backbone};
  }
  for (double& radius_m : room.full_m) {
    radius_m *= share_;
  }
  return room;
}

CollisionChecker MotionGuide::checker_for(const Plan& plan, const ModelMiss& miss) const {
  PlateRoom room = room_in_motion(plan);
  widen(room, miss.plate_m, needed_m(plan));
  return CollisionChecker(arm_, environment_.obstacles, 0.0, std::move(room));
}

double MotionGuide::needed_m(const Plan& plan) const {
  return plan.tube ? 0.0 : std::min(share_ * room_.margin_m, kOfPromised * plan.clearance_m);
}

MotionAdvice MotionGuide::advise(const PlanProgress& at, const PoseGoal& aim,
                                 const MotionState& now, const ModelMiss& miss,
                                 const std::optional<ShapeFeedback>& feedback) {
  const Plan& plan = at.plan;
  const std::size_t next = at.frame;
  const Pressures& next_kpa = at.sent_kpa;
  const std::vector<Pressures> rest_kpa = setpoints_after(plan, next);
  if (is_at_rest(rest_kpa, next_kpa)) {
    return {};  // its hold: corrections follow it
  }
  ++seed_;
  if (feedback) {
    if (std::optional<MotionAdvice> led = lead(plan, next, *feedback)) {
      strikes_ = false;
      return *std::move(led);
    }
  }
  MotionState from = now;
  MotionModel::Workspace workspace;
  model_.step(next_kpa, from, workspace);
  const CollisionChecker checker = checker_for(plan, miss);
  // An arm that is nearer already may go on where it comes no nearer.
  const double start_m = checker.clearance(from.backbone).value_m;
  const double kept_m = start_m > 0.0 ? kOfPromised * start_m : start_m / kOfPromised;
  const Ahead way{from, checker, std::min(needed_m(plan), kept_m)};
  const RestForecast rest =
      feedback ? led_forecast(plan, next, way, *feedback) : way.forecast_of(model_, rest_kpa);
  const Eigen::Vector3d ahead =
      feedback ? Eigen::Vector3d::Zero().eval() : miss_ahead(miss, rest_kpa, next_kpa);
  const PoseGoal goal = asked_goal(aim, ahead);
  const double error_m = as_length_m(goal, pose_error(goal, rest.end));
  const bool struck_before = std::exchange(strikes_, !rest.is_safe());
  const double promised_m =
      as_length_m(goal, PoseError{plan.goal_distance_m, plan.goal_orientation_rad});
  if (rest.is_safe() && error_m <= promised_m + kStrays * goal.position_tolerance_m) {
    has_waited_ = false;
    return {};
  }
  if (strikes_ && !struck_before && rest.unsafe_frame > arm_.frames_in(kStrikesSoonS)) {
    return {};
  }
  if (std::optional<FollowedPlan> found = find(at, way, goal, rest.is_safe(), error_m)) {
    has_waited_ = false;
    return {MotionAdvice::Kind::go_on, std::move(found), "", true};
  }
  if (rest.is_safe() || rest.unsafe_frame + 1 > arm_.frames_in(kFreeS)) {
    return {.has_searched = true};
  }
  return {MotionAdvice::Kind::stop, std::nullopt,
          fmt::format("{} is in the way, and no other way was found: the arm was stopped",
                      obstacle_name(environment_, rest.unsafe_obstacle)),
          true};
}

bool MotionGuide::is_free(const Plan& plan, std::size_t next, std::size_t frames,
                          const Backbone& off) const {
  const CollisionChecker checker(arm_, environment_.obstacles, needed_m(plan),
                                 room_in_motion(plan));
  const std::size_t first = std::max<std::size_t>(next, 1);  // 0: the arm waits in the start
  Backbone before = plan.frames[first - 1].backbone + off;
  for (std::size_t k = first; k < next + frames; ++k) {
    Backbone now = plan.frames[k].backbone + off;
    if (!(checker.motion_clearance(before, now).value_m > 0.0)) {
      return false;
    }
    before.swap(now);
  }
  return true;
}

std::optional<MotionAdvice> MotionGuide::lead(const Plan& plan, std::size_t next,
                                              const ShapeFeedback& feedback) {
  const std::size_t rest = plan.frames.size() - next;
  const std::size_t soon = std::min(rest, std::size_t(arm_.frames_in(kFreeS)));
  const Backbone on_plan = Backbone::Zero(arm_.point_count(), kPoseSize);
  if (!is_free(plan, next, rest, on_plan) || !is_free(plan, next, soon, feedback.off_plan())) {
    return std::nullopt;
  }
  has_waited_ = !has_waited_ && !is_free(plan, next, soon, kTimesOff * feedback.off_plan());
  return MotionAdvice{has_waited_ ? MotionAdvice::Kind::wait : MotionAdvice::Kind::go_on};
}

RestForecast MotionGuide::Ahead::forecast_of(const MotionModel& model,
                                             const std::vector<Pressures>& setpoints_kpa) const {
  return forecast(
      model, checker, from, setpoints_kpa.size(),
      [&](std::size_t k, const MotionState&) { return setpoints_kpa[k]; }, needed_m);
}

RestForecast MotionGuide::led_forecast(const Plan& plan, std::size_t next, const Ahead& way,
                                       ShapeFeedback feedback) const {
  return forecast(
      model_, way.checker, way.from, plan.frames.size() - next - 1,
      [&](std::size_t k, const MotionState& before) {
        feedback.learn(plan.frames[next + k].backbone, before.backbone);
        return feedback.setpoint(plan.frames[next + k + 1].setpoint_kpa, before.setpoint_kpa(),
                                 limits_after(plan, settings_.corrections.limits));
      },
      way.needed_m);
}

std::optional<FollowedPlan> MotionGuide::find(const PlanProgress& at, const Ahead& way,
                                              const PoseGoal& goal, bool is_safe, double error_m) {
  const Plan& plan = at.plan;
  Environment from_here = environment_;
  from_here.start = start_at(way.from);
  from_here.goal = goal;
  const double tolerance_m = environment_.goal.position_tolerance_m;
  const double max_error_m = is_safe ? std::min(tolerance_m, error_m - kMinGainM) : tolerance_m;
  if (max_error_m <= 0.0) {
    return std::nullopt;
  }
  const auto is_free = [&](const std::optional<Plan>& found) {
    return found && way.forecast_of(model_, setpoints_after(*found, 0)).is_safe();
  };
  std::optional<Plan> found = repaired_plan(problem_from(from_here, plan),
                                            waypoints_after(at, arm_.pressure_step_limit_kpa()),
                                            max_error_m, seed_, check_);
  if (is_free(found)) {
    return FollowedPlan{*std::move(found), from_here};
  }
  if (is_safe && error_m <= tolerance_m) {
    return std::nullopt;  // good enough for the corrections to start from
  }
  found = searched(plan, from_here);
  return is_free(found) ? std::optional(FollowedPlan{*std::move(found), from_here}) : std::nullopt;
}

PlanningProblem MotionGuide::problem_from(const Environment& from_here, const Plan& plan) const {
  PlanningProblem problem{arm_, model_, from_here,
                          std::max(kRoomOfNewPlans, share_) * room_.margin_m};
  problem.limits = limits_after(plan, settings_.corrections.limits);
  problem.margin_yields_to_start = true;
  return problem;
}

std::optional<Plan> MotionGuide::searched(const Plan& plan, const Environment& from_here) {
  PlannerLimits limits;
  limits.queries = settings_.motion_queries;
  PlanResult result = planner_.plan(problem_from(from_here, plan), limits, seed_,
                                    [](const PlannerProgress&) { return !interrupt_requested(); });
  const bool is_certified = result.plan && result.plan->certified;
  return is_certified ? std::move(result.plan) : std::nullopt;
}

}  // namespace limber
