#include "limber/run/closed_loop.hpp"

#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "certified_frame.hpp"
#include "goal_lengths.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/replanning.hpp"
#include "motion_guide.hpp"
#include "estimate/rest_average.hpp"

namespace limber {

namespace {

constexpr double kRestS = 0.5;
constexpr double kSettleS = 0.25;     // of a hold: the arm comes to where its plan ends
constexpr double kWellInside = 0.05;  // of the tolerance: left alone
/// Of the arm's length, per frame: 2 mm of the arm of the paper. An arm that slid on at 1.4 cm per
/// frame was led to the goal by where it was, and struck what its plan passed.
constexpr double kStillM = 0.00284;
constexpr double kStillS = 0.5;         // at a hold's end, for the arm to come to rest
constexpr double kRoomOfLeading = 1.0;  // of the room for the model's error: kept from obstacles
constexpr double kRoomOfFrames = 0.25;  // of the room for the model's error: kept in every frame
constexpr double kLongestWaitS = 0.5;   // in mid-motion; then the plan is left
constexpr int kLedOn = 3;               // times that an arm short of its goal is led on
constexpr double kCheckS = 0.5;  // most of what an arm that is held still moves is over by then
/// Of the arm's length: what a plate is measured beside where the filter believes the arm can have
/// it. 2 mm of the arm of the paper, four times a tracker's noise: with 0.5 and 1 mm a noise of
/// 0.5 mm still moved the arm (docs/experiments.md, Disturbances).
constexpr double kMeasuredShare = 0.00284;

Eigen::VectorXd gap_lengths_m(const ArmDescription& arm) {
  Eigen::VectorXd lengths_m(arm.point_count() - 1);
  for (int gap = 0; gap < lengths_m.size(); ++gap) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(arm.segment_of_gap(gap))];
    lengths_m[gap] = segment.length_m / segment.gaps;
  }
  return lengths_m;
}

/// The hold of a plan, once more.
Plan held_on(Plan plan) {
  const PlanFrame end = plan.frames.back();
  plan.frames.assign(static_cast<std::size_t>(plan.hold_frame_count) + 1, end);
  plan.waypoints_kpa = {end.setpoint_kpa, end.setpoint_kpa};
  plan.certified.reset();
  return plan;
}

}  // namespace

struct ClosedLoop::Motion {
  Motion(const ArmDescription& the_arm, const MotionModel& the_model, const ErrorRoom& the_room,
         const ClosedLoopSettings& the_settings, std::uint64_t the_seed)
      : arm(the_arm),
        model(the_model),
        room(the_room),
        settings(the_settings),
        seed(the_seed),
        planner(make_planner("default", settings.corrections.planner_jobs)),
        estimate(model, static_cast<std::size_t>(the_arm.frames_in(kCheckS))),
        rest(the_arm.frames_in(kRestS)),
        follower(the_arm, model) {}

  void move_in(const Environment& now) {
    corrections.emplace(arm, model, now, room, settings.corrections, seed);
    guide.emplace(arm, model, now, room,
                  MotionGuideSettings{settings.motion_queries, settings.corrections.min_gain_m,
                                      settings.corrections.limits},
                  *planner, certificate_check(arm, model), seed);
    if (model.has_network()) {
      gate.emplace(arm, model, now, kRoomOfFrames * room.margin_m, settings.corrections.limits);
    }
    aim = goal = now.goal;
  }

  /// Without memory a model predicts from pressures alone.
  void filter_noise(const Environment& environment) {
    if (model.has_network()) {
      estimate.filter_noise(ShapeFilter(gap_lengths_m(arm), kMeasuredShare * arm.length_m()),
                            start_of(PlanningProblem{arm, model, environment, 0.0}).backbone);
    }
  }

  /// Where the arm rests, free of most of the tracker's noise.
  ArmState at_rest(ArmState state) {
    const std::lock_guard lock(estimate_mutex);
    if (const std::optional<Backbone> mean = rest.backbone(); state.backbone && mean) {
      state.backbone = mean;
    }
    return state;
  }

  /// Corrections are short and their goals shifted, and the shapes that a model without memory
  /// predicts are no arm's. Led, an arm swings about its plan; where that is too near to something,
  /// it is better predicted than led.
  bool is_led(const Plan& plan) const {
    const bool has_room = plan.tube || plan.clearance_m >= room.margin_m;
    return model.has_network() && settings.motion_queries > 0 && !is_correction && has_room &&
           estimate.has_state();
  }

  bool is_in_goal(const Backbone& shape) const {
    return is_within(goal, pose_error(goal, tip_pose(shape)));
  }

  /// Where a plan ends in the goal, and there is room for what the way there may miss.
  bool may_be_led_to_goal(const Plan& plan, const Backbone& shape) const {
    const double error_m = as_length_m(goal, pose_error(goal, tip_pose(shape)));
    return error_m >= kWellInside * goal.position_tolerance_m &&
           is_in_goal(plan.frames.back().backbone) &&
           corrections->clearance_m(shape) >= kRoomOfLeading * room.margin_m;
  }

  /// Whether friction and valves still carry it on: where it is now says little of where it ends.
  bool is_moving() const { return estimate.moved_m() > kStillM * arm.length_m(); }

  /// An arm that rests short of the goal where its plan has it inside.
  bool is_led_on(const Plan& plan, std::size_t frame, const ArmState& state) const {
    return state.backbone && is_led(plan) && settings.corrections.max_replans > 0 &&
           times_led_on < kLedOn && frame + 1 == plan.frames.size() &&
           !is_in_goal(*state.backbone) && may_be_led_to_goal(plan, *state.backbone);
  }

  /// Whether the arm, if it is halted now, comes to rest free.
  bool may_stop() { return !gate || !estimate.has_state() || gate->may_stop(estimate.state()); }

  /// Whether the rest of a plan is certified for an arm that had its frame `next` after `now`. It
  /// is led along that, while nothing corrects an arm that is halted.
  bool leads_on(const Plan& plan, std::size_t next, MotionState now) {
    MotionModel::Workspace workspace;
    model.step(plan.frames[next].setpoint_kpa, now, workspace);
    return gate && gate->leads_on(now, plan, next);
  }

  bool is_blind() const { return estimate.frames_unseen() > arm.frames_in(settings.blind_s); }

  const ArmDescription& arm;
  MotionModel model;
  ErrorRoom room;
  ClosedLoopSettings settings;
  std::uint64_t seed;
  std::unique_ptr<Planner> planner;
  ArmEstimate estimate;
  RestAverage rest;
  PlanFollower follower;
  const Plan* followed = nullptr;  // by the follower
  int times_led_on = 0;
  std::mutex estimate_mutex;  // of both: in real time the arm is observed while `next` searches
  std::optional<Replanner> corrections;
  std::optional<MotionGuide> guide;
  std::optional<CertifiedFrame> gate;  // none without memory: that predicts from pressures alone
  const Plan* sent_of = nullptr;       // what was sent last; compared, never read
  int waited = 0;  // frames of that in a row in which the arm was held in mid-motion
  PoseGoal aim;    // of the plan that is followed
  PoseGoal goal;   // of the environment
  /// It starts at rest, and its goal is shifted by what the model has a held arm do: that is not
  /// missed once more.
  bool is_correction = false;
};

ClosedLoop::ClosedLoop(const ArmDescription& arm, const MotionModel& model,
                       const Environment& environment, const ErrorRoom& room,
                       const ClosedLoopSettings& settings, std::uint64_t seed)
    : motion_(std::make_unique<Motion>(arm, model, room, settings, seed)) {
  motion_->move_in(environment);
  motion_->filter_noise(environment);
}

ClosedLoop::~ClosedLoop() = default;

void ClosedLoop::observe(const Pressures& setpoint_kpa, const ArmState& state) {
  const std::lock_guard lock(motion_->estimate_mutex);
  motion_->estimate.observe(setpoint_kpa, state);
  motion_->rest.observe(state.backbone);
}

/// What leads the arm, the plan's own, or what the arm has: the first of these that is certified.
FrameSetpoint ClosedLoop::setpoint(const Plan& plan, std::size_t frame, std::size_t next) {
  Motion& motion = *motion_;
  const Pressures& held_kpa = plan.frames[frame].setpoint_kpa;
  const Pressures led_kpa = next == frame ? held_kpa : led_setpoint(plan, frame, next);
  if (!motion.gate || !motion.estimate.has_state()) {
    return {led_kpa, next};
  }
  if (std::exchange(motion.sent_of, &plan) != &plan) {
    motion.waited = 0;
  }
  const bool is_over = next + static_cast<std::size_t>(plan.hold_frame_count) >= plan.frames.size();
  const std::size_t following = std::min(frame + 1, plan.frames.size() - 1);
  std::vector<CertifiedFrame::Wanted> wanted{{led_kpa, next},
                                             {plan.frames[following].setpoint_kpa, following}};
  if (next != frame) {
    wanted.push_back({held_kpa, is_over ? next : frame});
  }
  const CertifiedFrame::Sent sent = motion.gate->next(motion.estimate.state(), plan, wanted);
  const std::size_t reached = sent.frame.value_or(is_over ? next : frame);
  motion.waited = reached == frame ? motion.waited + 1 : 0;
  return {sent.kpa, reached, sent.is_certified};
}

/// Along the plan's shapes; when it has ended, into the goal. An arm that waits is left alone, and
/// so is one that is well inside, or has to come to rest before corrections begin.
Pressures ClosedLoop::led_setpoint(const Plan& plan, std::size_t frame, std::size_t next) {
  Motion& motion = *motion_;
  const Pressures& held_kpa = plan.frames[frame].setpoint_kpa;
  if (!motion.is_led(plan)) {
    return plan.frames[next].setpoint_kpa;
  }
  if (motion.followed != &plan) {
    motion.followed = &plan;
    motion.follower.forget();
  }
  const Backbone& shape = motion.estimate.state().backbone;
  const int held = static_cast<int>(next) + plan.hold_frame_count - plan.frame_count();
  const int settles = motion.times_led_on > 0 ? 0 : motion.arm.frames_in(kSettleS);
  const bool is_seen = motion.estimate.frames_unseen() == 0;
  if (held < settles || motion.is_moving()) {
    if (is_seen) {
      motion.follower.learn(plan.frames[frame].backbone, shape);
    }
  } else if (!is_seen || !motion.may_be_led_to_goal(plan, shape) ||
             held >= plan.hold_frame_count - motion.arm.frames_in(kStillS)) {
    return held_kpa;
  } else {
    motion.follower.learn_from_goal(motion.goal, shape);
  }
  return motion.follower.setpoint(plan.frames[next].setpoint_kpa, held_kpa,
                                  limits_after(plan, motion.settings.corrections.limits));
}

bool ClosedLoop::may_hold() {
  Motion& motion = *motion_;
  return !motion.gate || !motion.estimate.has_state() ||
         motion.gate->may_hold(motion.estimate.state());
}

std::function<MotionAdvice()> ClosedLoop::advise(const Plan& plan, std::size_t next) {
  Motion& motion = *motion_;
  const bool is_moving = static_cast<int>(next) + plan.hold_frame_count < plan.frame_count();
  if (motion.settings.motion_queries == 0 || !motion.estimate.has_state() || !is_moving) {
    return {};
  }
  if (motion.is_blind()) {
    return [blind_s = motion.settings.blind_s] {
      return MotionAdvice{
          MotionAdvice::Kind::stop, std::nullopt,
          fmt::format("the arm was not tracked for more than {} s: it was stopped", blind_s)};
    };
  }
  // What is measured and sent meanwhile is the next question's.
  return [&motion, plan, next, now = motion.estimate.state(),
          miss = motion.is_correction ? ModelMiss{} : motion.estimate.miss(),
          follower = motion.is_led(plan) ? std::optional(motion.follower) : std::nullopt] {
    MotionAdvice advice = motion.guide->advise(plan, next, motion.aim, now, miss, follower);
    if (advice.kind == MotionAdvice::Kind::stop && motion.leads_on(plan, next, now)) {
      return MotionAdvice{.has_searched = true};
    }
    return advice;
  };
}

bool ClosedLoop::may_go_on(const Plan& plan, std::size_t frame, const ArmState& state) {
  return (motion_->waited <= motion_->arm.frames_in(kLongestWaitS) &&
          motion_->corrections->may_go_on(plan, frame, state)) ||
         !motion_->may_stop();
}

std::optional<Plan> ClosedLoop::next(const Plan& plan, std::size_t frame, const ArmState& state) {
  {
    const std::lock_guard lock(motion_->estimate_mutex);
    if (motion_->is_led_on(plan, frame, state)) {
      ++motion_->times_led_on;
      return held_on(plan);
    }
  }
  std::optional<Plan> found = motion_->corrections->next(plan, frame, motion_->at_rest(state));
  motion_->aim = motion_->corrections->aim();
  motion_->is_correction = motion_->model.has_network() && motion_->corrections->is_correction();
  motion_->times_led_on = 0;
  motion_->followed = nullptr;
  const std::lock_guard lock(motion_->estimate_mutex);
  motion_->estimate.forget_miss();
  return found;
}

void ClosedLoop::obstacle_appeared(const Environment& now) {
  motion_->move_in(now);
}

std::unique_ptr<PlanSource> make_replanner(const ArmDescription& arm, const MotionModel& model,
                                           const Environment& environment, const ErrorRoom& room,
                                           std::uint64_t seed) {
  return std::make_unique<ClosedLoop>(arm, model, environment, room, ClosedLoopSettings{}, seed);
}

}  // namespace limber
