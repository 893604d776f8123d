#include "limber/run/closed_loop.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "certified_frame.hpp"
#include "estimate/live_arm_fit.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/controller.hpp"
#include "motion_guide.hpp"
#include "shape_feedback.hpp"

namespace limber {

namespace {

constexpr double kSettleS = 0.25;      // of a hold: the arm comes to where its plan ends
constexpr double kLongestWaitS = 0.5;  // in mid-motion; then the plan is left …
constexpr double kStandsAfterS = 2.0;  // … at last also where the model has a held arm strike
constexpr float kOtherArm = 0.1F;      // e moved by so much of the family's spread

}  // namespace

struct ClosedLoop::Motion {
  Motion(const ArmDescription& the_arm, const MotionModel& the_model,
         const Environment& the_environment, const ErrorRoom& the_room,
         const ClosedLoopSettings& the_settings, std::uint64_t the_seed)
      : arm(the_arm),
        own(own_of(arm, the_model, the_settings)),
        model(own ? MotionModel(*own, the_model.valves()) : the_model),
        environment(the_environment),
        room(the_room),
        settings(the_settings),
        seed(the_seed),
        planner(make_planner("default", settings.corrections.planner_jobs)),
        start(start_of(PlanningProblem{arm, model, environment, 0.0}).backbone),
        feedback(arm, model.no_load(), model.valves()) {
    if (own) {
      family = family_of(own->compensation());
      fit.emplace(arm, own->compensation());
      missed_by = fit->member().e;
    }
  }

  /// What the arm's e is changed in; none: it is left alone.
  static std::unique_ptr<ForwardModel> own_of(const ArmDescription& arm, const MotionModel& model,
                                              const ClosedLoopSettings& settings) {
    return settings.adapts && model.compensation().member_of_family
               ? std::make_unique<ForwardModel>(arm, model.compensation())
               : nullptr;
  }

  void move_in(const Environment& now) {
    settings.corrections.max_replans -= corrections ? corrections->replans() : 0;
    corrections.emplace(arm, model, now, room, settings.corrections, seed);
    guide.emplace(arm, model, now, room, settings, *planner, certificate_check(arm, model), seed);
    gate.emplace(arm, model, now, MotionGuide::kShareInMotion * room.margin_m,
                 settings.corrections.limits);
    aim = now.goal;
  }

  /// An arm that is not as its model has it keeps more of the room, up to all of it, until e has
  /// settled.
  void keep_room() {
    const double share = std::min(1.0, fit->times_off() * MotionGuide::kShareInMotion);
    guide->keep(share);
    gate->keep(share * room.margin_m);
  }

  /// Corrections are short and their goals shifted. Led, an arm swings about its plan; where that
  /// is too near to something, it is better predicted than led.
  bool is_led(const Plan& plan, const ArmEstimate& estimate) const {
    const bool has_room = plan.tube || plan.clearance_m >= room.margin_m;
    return settings.motion_queries > 0 && !is_correction && has_room && estimate.has_state();
  }

  /// Whether the arm, if it is halted now, comes to rest free.
  bool may_stop(const ArmEstimate& estimate) const {
    return !estimate.has_state() || gate->may_stop(estimate.state());
  }

  /// Whether the rest of a plan is certified for an arm that is sent `at` after `now`. It is led
  /// along that, while nothing corrects an arm that is halted.
  bool leads_on(const PlanProgress& at, MotionState now) const {
    MotionModel::Workspace workspace;
    model.step(at.sent_kpa, now, workspace);
    return gate->leads_on(now, at.plan, at.frame);
  }

  /// Of its family, as the model had it when the plan was certified.
  void note_arm(Plan& plan) const {
    if (own) {
      plan.arm_of_family = own->compensation().member_of_family->e;
    }
  }

  ArmDescription arm;  // at the rate of the plan that the run begins with
  std::unique_ptr<ForwardModel> own;
  CompensationModel family;  // of `own`, for which each e gives the bits that `verify` has
  MotionModel model;
  const Environment& environment;  // that the run begins in
  std::optional<LiveArmFit> fit;
  int seen = -1;                    // ArmEstimate::frames: a frame may be asked about twice
  Eigen::VectorXf missed_by;        // e of the model whose misses the estimate holds
  std::optional<double> changed_s;  // when the fit was first surprised
  std::string notice;               // of that, until it is taken
  bool is_refitted = false;         // since `own` was changed last
  ErrorRoom room;
  ClosedLoopSettings settings;
  std::uint64_t seed;
  std::unique_ptr<Planner> planner;
  Backbone start;
  ShapeFeedback feedback;
  const Plan* followed = nullptr;  // by the feedback
  std::optional<Replanner> corrections;
  std::optional<MotionGuide> guide;
  std::optional<CertifiedFrame> gate;
  const Plan* sent_of = nullptr;  // what was sent last; compared, never read
  int waited = 0;                 // frames of that in a row in which the arm was held in mid-motion
  PoseGoal aim;                   // of the plan that is followed
  PoseGoal next_aim;              // of the last answer to `next`, and whether that corrects
  bool next_is_correction = false;
  RestMiss next_missed;
  /// It starts at rest, and its goal is shifted by what the model has a held arm do: that is not
  /// missed once more.
  bool is_correction = false;
};

ClosedLoop::ClosedLoop(const ArmDescription& arm, const MotionModel& model,
                       const Environment& environment, const ErrorRoom& room,
                       const ClosedLoopSettings& settings, std::uint64_t seed) {
  require_model_of_arm(arm, model, "closed loop");
  refuse_if(!model.has_network(),
            "the closed loop needs a network: the no-load model errs as much after a correction as "
            "before. Give one (--model), or execute the plan open loop");
  motion_ = std::make_unique<Motion>(arm, model, environment, room, settings, seed);
}

ClosedLoop::~ClosedLoop() = default;

EstimateModel ClosedLoop::estimate_with() const {
  return {&motion_->model, motion_->start};
}

void ClosedLoop::begin(const RunStart& start) {
  PlanController::begin(start);
  Motion& motion = *motion_;
  motion.arm.pressure_rate_limit_kpa_per_s = start.arm.pressure_rate_limit_kpa_per_s;
  motion.feedback = ShapeFeedback(motion.arm, motion.model.no_load(), motion.model.valves());
  if (!start.limits.empty()) {
    motion.settings.corrections.limits = start.limits;
  }
  motion.move_in(motion.environment);
}

/// The frames in between go unobserved: those beside them are no neighbours.
void ClosedLoop::held() {
  PlanController::held();
  if (motion_->fit) {
    motion_->fit->lose_track();
  }
}

/// All that predict hold the one model that is changed here, while none of them is at work.
void ClosedLoop::observe(const Moment& now) {
  Motion& motion = *motion_;
  if (!motion.fit) {
    return;
  }
  if (std::exchange(motion.seen, now.arm.frames()) != now.arm.frames()) {
    // As it was measured, noise would pass for a velocity, and e be moved to explain that.
    std::optional<Backbone> shape;
    if (now.arm.has_state() && now.arm.frames_unseen() == 0) {
      shape = now.arm.shown_state().backbone;
    }
    motion.is_refitted |= motion.fit->observe(now.arm.measured().pressure_kpa, shape);
    if (!motion.changed_s && motion.fit->is_surprised()) {
      motion.changed_s = motion.seen * motion.arm.frame_period_s();
      motion.notice = fmt::format(
          "after {:.1f} s the arm is far from where it was predicted: load or friction may have "
          "changed",
          *motion.changed_s);
    }
    if (motion.fit->has_left_family()) {
      throw SystemFault(fmt::format(
          "the arm moves like none of its model's family: short predictions were off by {:.1f} cm "
          "again and again, whichever of its arms was tried. Look for what has changed, and adapt "
          "the model again (limber adapt)",
          kCmPerM * motion.fit->last_error_m()));
    }
  }
  if (now.is_thinking) {
    return;
  }
  motion.keep_room();
  if (motion.is_refitted) {
    motion.is_refitted = false;
    *motion.own = ForwardModel(motion.arm, model_of_arm(motion.family, motion.fit->member()));
    const Eigen::VectorXf& e = motion.fit->member().e;
    if ((e - motion.missed_by).norm() > kOtherArm * std::sqrt(float(e.size()))) {
      motion.missed_by = e;  // what another arm's model missed says nothing of this one
      now.arm.forget_miss();
      now.arm.take(RestMiss{});
    }
  }
}

/// What leads the arm, the plan's own, or what the arm has: the first of these that is certified.
FrameSetpoint ClosedLoop::setpoint(const PlanProgress& at, std::size_t next,
                                   const ArmEstimate& arm) {
  Motion& motion = *motion_;
  const Plan& plan = at.plan;
  const std::size_t frame = at.frame;
  const Pressures& held_kpa = at.sent_kpa;
  const Pressures led_kpa = next == frame ? held_kpa : led_setpoint(at, next, arm);
  if (!arm.has_state()) {
    return {led_kpa, next};
  }
  if (std::exchange(motion.sent_of, &plan) != &plan) {
    motion.waited = 0;
  }
  const bool is_over = next + std::size_t(plan.hold_frame_count) >= plan.frames.size();
  const std::size_t following = std::min(frame + 1, plan.frames.size() - 1);
  std::vector<CertifiedFrame::Wanted> wanted{{led_kpa, next}};
  if (following != next || at.setpoint_kpa(following) != led_kpa) {
    wanted.push_back({at.setpoint_kpa(following), following});
  }
  if (next != frame) {
    wanted.push_back({held_kpa, is_over ? next : frame});
  }
  const CertifiedFrame::Sent sent = motion.gate->next(arm.state(), at, wanted);
  const std::size_t reached = sent.frame.value_or(is_over ? next : frame);
  motion.waited = reached == frame ? motion.waited + 1 : 0;
  return {sent.kpa, reached, sent.is_certified};
}

/// Along the plan's shapes, until the arm has come to rest after the plan's end.
Pressures ClosedLoop::led_setpoint(const PlanProgress& at, std::size_t next,
                                   const ArmEstimate& arm) {
  Motion& motion = *motion_;
  const Plan& plan = at.plan;
  const Pressures& held_kpa = at.sent_kpa;
  if (!motion.is_led(plan, arm)) {
    return plan.frames[next].setpoint_kpa;
  }
  if (motion.followed != &plan) {
    motion.followed = &plan;
    motion.feedback.forget();
  }
  const int held = int(next) + plan.hold_frame_count - plan.frame_count();
  if (held >= motion.arm.frames_in(kSettleS) && !arm.is_moving()) {
    return held_kpa;
  }
  if (arm.frames_unseen() == 0) {
    motion.feedback.learn(plan.frames[at.frame].backbone, arm.state().backbone);
  }
  return motion.feedback.setpoint(plan.frames[next].setpoint_kpa, held_kpa,
                                  limits_after(plan, motion.settings.corrections.limits));
}

bool ClosedLoop::may_hold(const ArmEstimate& arm) {
  return !arm.has_state() || motion_->gate->may_hold(arm.state());
}

std::function<MotionAdvice()> ClosedLoop::advise(const PlanProgress& at, const ArmEstimate& arm) {
  Motion& motion = *motion_;
  const Plan& plan = at.plan;
  const bool is_in_motion = int(at.frame) + plan.hold_frame_count < plan.frame_count();
  if (!arm.has_state() || !is_in_motion) {
    return {};
  }
  if (arm.frames_unseen() > motion.arm.frames_in(motion.settings.blind_s)) {
    return [blind_s = motion.settings.blind_s] {
      return MotionAdvice{
          MotionAdvice::Kind::stop, std::nullopt,
          fmt::format("the arm was not tracked for more than {} s: it was stopped", blind_s)};
    };
  }
  if (motion.settings.motion_queries == 0) {
    return {};
  }
  // What is measured and sent meanwhile is the next question's.
  return [&motion, &plan, frame = at.frame, sent_kpa = at.sent_kpa, now = arm.state(),
          miss = motion.is_correction ? ModelMiss{} : arm.miss(),
          feedback = motion.is_led(plan, arm) ? std::optional(motion.feedback) : std::nullopt] {
    const PlanProgress sent{plan, frame, sent_kpa};
    MotionAdvice advice = motion.guide->advise(sent, motion.aim, now, miss, feedback);
    if (advice.plan) {
      motion.note_arm(advice.plan->plan);
    }
    if (advice.kind == MotionAdvice::Kind::stop && motion.leads_on(sent, now)) {
      return MotionAdvice{.has_searched = true};
    }
    return advice;
  };
}

bool ClosedLoop::may_go_on(const Plan& plan, std::size_t seen, const ArmEstimate& arm) {
  if (motion_->waited > motion_->arm.frames_in(kStandsAfterS)) {
    return false;
  }
  return (motion_->waited <= motion_->arm.frames_in(kLongestWaitS) &&
          motion_->corrections->may_go_on(plan, seen, arm.measured().backbone)) ||
         !motion_->may_stop(arm);
}

PlanController::NextPlan ClosedLoop::next(const PlanProgress& at, const ArmEstimate& arm) {
  Motion& motion = *motion_;
  // Where it rests, free of most of the tracker's noise.
  const std::optional<Backbone> mean = arm.rest();
  const std::optional<Backbone> rest = mean ? mean : arm.measured().backbone;
  return [&motion, &plan = at.plan, frame = at.frame, held_kpa = at.sent_kpa, rest,
          missed = arm.rest_miss()] {
    std::optional<Plan> plan_after = motion.corrections->next(plan, frame, held_kpa, rest, missed);
    std::optional<FollowedPlan> found;
    if (plan_after) {
      motion.note_arm(*plan_after);
      found = {*std::move(plan_after), motion.corrections->planned_for()};
    }
    motion.next_missed = motion.corrections->missed();
    motion.next_aim = motion.corrections->aim();  // an obstacle that appears now has another
    motion.next_is_correction = motion.corrections->is_correction();
    return found;
  };
}

void ClosedLoop::take_next(ArmEstimate& arm) {
  motion_->aim = motion_->next_aim;
  motion_->is_correction = motion_->next_is_correction;
  motion_->followed = nullptr;
  arm.take(motion_->next_missed);
  arm.forget_miss();
}

void ClosedLoop::report(ExecutionResult& result) const {
  PlanController::report(result);
  if (const auto& fit = motion_->fit) {
    result.arm = fit->member();
    result.arm_changed_s = motion_->changed_s;
    if (!fit->has_left_family()) {  // else no change of e explains the arm
      result.arm_changes = fit->explained_changes();
    }
    result.largest_window_error_m = fit->largest_error_m();
    result.last_window_error_m = fit->last_error_m();
  }
}

void ClosedLoop::obstacle_appeared(const Environment& now) {
  if (forget_answers() && !motion_->next_is_correction) {
    ++motion_->settings.corrections.max_replans;  // that one was counted, and is not followed
  }
  motion_->move_in(now);
}

std::string ClosedLoop::take_notice() {
  return std::exchange(motion_->notice, {});
}

std::unique_ptr<Controller> make_closed_loop(const ArmDescription& arm, const MotionModel& model,
                                             const Environment& environment, const ErrorRoom& room,
                                             std::uint64_t seed, bool adapts) {
  ClosedLoopSettings settings;
  settings.adapts = adapts;
  return std::make_unique<ClosedLoop>(arm, model, environment, room, settings, seed);
}

}  // namespace limber
