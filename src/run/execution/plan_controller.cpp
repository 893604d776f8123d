#include "limber/run/plan_controller.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"

namespace limber {

namespace {

constexpr double kHaltHoldS = 0.3;      // that a halted arm stands before it is asked how to go on
constexpr double kLongestBlindS = 1.0;  // waited for the arm to be tracked, before the next plan

}  // namespace

void PlanController::begin(const RunStart& start) {
  refuse_if(plan_ != nullptr,
            "a controller that follows plans runs once; make another one for another run");
  run_.emplace(start);
  plan_ = &start.plan;
  sent_kpa_ = start.plan.frames.front().setpoint_kpa;
}

Decision PlanController::step(const Moment& now) {
  observe(now);
  if (is_in_frame_) {
    end_frame(now);
  }
  for (;;) {
    switch (phase_) {
      case Phase::moving:
        if (goes_on_ && !is_at_end()) {
          drop_late_advice(now.is_thinking);
          return move(now.arm);
        }
        is_late_ = advised_ != nullptr;
        if (now.is_thinking) {
          return hold_frame(now.arm);  // nothing else may be asked before that is answered
        }
        drop_late_advice(false);
        begin_hold();
        break;
      case Phase::holding:
        if (held_ < run_->arm.frames_in(hold_until_s_)) {
          const std::size_t before = frame_;
          Decision decision = hold_frame(now.arm);
          held_ = frame_ == before ? held_ + 1 : 0;
          if (!halted_) {
            decision.plan = plan_;
            decision.frame = frame_ + std::size_t(++after_end_);
          }
          return decision;
        }
        if (!plans_again()) {
          return end();
        }
        phase_ = asks_again_ ? Phase::asking : Phase::waiting_for_sight;
        break;
      case Phase::waiting_for_sight:
        if (!now.arm.measured().backbone && blind_ < run_->arm.frames_in(kLongestBlindS)) {
          ++blind_;
          return hold_still(now.arm);
        }
        phase_ = Phase::asking;
        break;
      case Phase::asking:
        if (!found_) {
          if (Decision decision = ask(now.arm); decision.question) {
            return decision;
          }
        } else if (now.is_thinking) {
          return hold_still(now.arm);
        }
        if (std::optional<Decision> ended = end_asking(now)) {
          return *std::move(ended);
        }
        break;
    }
  }
}

Decision PlanController::sent(const Pressures& setpoint_kpa, bool is_certified) {
  frames_not_certified_ += is_certified ? 0 : 1;
  sent_kpa_ = setpoint_kpa;
  return {.setpoint_kpa = setpoint_kpa, .motion = motion_, .is_certified = is_certified};
}

/// The next frame of the plan, or the last one again; and what is asked about it.
Decision PlanController::move(const ArmEstimate& arm) {
  const std::size_t wanted = waits_ ? frame_ : frame_ + 1;
  FrameSetpoint frame = setpoint(progress(), wanted, arm);
  if (frame.frame < frame_ || frame.frame >= plan_->frames.size()) {
    throw InputError(fmt::format("a controller stands in {} of its plan; expected {} to {}",
                                 frame_name(Eigen::Index(frame.frame)), frame_,
                                 plan_->frames.size() - 1));
  }
  waits_ = frame.frame == frame_;
  next_frame_ = frame.frame;
  is_in_frame_ = true;
  Decision decision = sent(frame.kpa, frame.is_certified);
  decision.begins_at_rest = std::exchange(begins_at_rest_, false);
  if (!waits_) {
    decision.plan = plan_;
    decision.frame = next_frame_;
  }
  if (advised_) {
    return decision;  // the last one is late, and is still being worked out
  }
  if (std::function<MotionAdvice()> question = advise({*plan_, next_frame_, sent_kpa_}, arm)) {
    advised_ = std::make_shared<std::optional<Advised>>();
    decision.question = [question = std::move(question), answer = advised_] {
      const auto begun = std::chrono::steady_clock::now();
      MotionAdvice advice = question();
      *answer = Advised{std::move(advice), seconds_since(begun)};
    };
  }
  return decision;
}

/// After a frame of a motion: where the arm is along the plan, and whether it goes on.
void PlanController::end_frame(const Moment& now) {
  is_in_frame_ = false;
  if (std::exchange(waits_, false)) {
    ++waited_;
  } else {
    const Pressures& planned_kpa = plan_->frames[next_frame_].setpoint_kpa;
    frame_ = next_frame_;
    const auto next = std::size_t(motion_ - first_motion_) + 1;
    if (next + 1 < plan_->waypoints_kpa.size() && planned_kpa == plan_->waypoints_kpa[next]) {
      ++motion_;  // ends where its edge of the plan does
    }
  }
  const auto lag = std::size_t(now.arm.lag_frames());
  goes_on_ = is_at_end() || may_go_on(*plan_, frame_ - std::min(frame_, lag), now.arm);
  if (!advised_) {
    return;
  }
  if (now.is_thinking || is_late_) {
    is_late_ = true;
    return;
  }
  MotionAdvice advice = take_answer(run_->in_real_time);
  if (goes_on_) {
    take(std::move(advice));
  }
}

/// What came after its frame counts for nothing, but took its time.
void PlanController::drop_late_advice(bool is_thinking) {
  if (!advised_ || !is_late_ || is_thinking) {
    return;
  }
  times_.late += run_->in_real_time ? 1 : 0;
  (void)take_answer(run_->in_real_time);
  is_late_ = false;
}

/// To `advise`. @param is_timed  what it took is noted
MotionAdvice PlanController::take_answer(bool is_timed) {
  Advised advised = std::move(**std::exchange(advised_, nullptr));
  if (is_timed) {
    times_.all_s.push_back(advised.took_s);
    if (advised.advice.has_searched) {
      times_.searches_s.push_back(advised.took_s);
    }
  }
  return std::move(advised.advice);
}

void PlanController::take(MotionAdvice advice) {
  waits_ = advice.kind == MotionAdvice::Kind::wait;
  if (advice.kind == MotionAdvice::Kind::stop) {
    stop_reason_ = std::move(advice.reason);
    goes_on_ = is_at_end();
  } else if (advice.plan) {
    go_over_to(*std::move(advice.plan), "the plan that replaces it in motion");
    ++switches_;
  }
}

/// Holds; or goes on along the plan, where an arm that is held now strikes.
Decision PlanController::hold_frame(const ArmEstimate& arm) {
  FrameSetpoint frame = setpoint(progress(), frame_, arm);
  frame_ = frame.frame;
  return sent(frame.kpa, frame.is_certified);
}

/// Holds whatever becomes of it: a plan that starts there is being made.
Decision PlanController::hold_still(const ArmEstimate& arm) {
  return sent(Pressures(sent_kpa_), may_hold(arm));
}

/// A plan's own hold counts: planner and executor judge the goal at the same moment.
void PlanController::begin_hold() {
  halted_ = !is_at_end();
  halts_ += halted_ ? 1 : 0;
  held_ = halted_ ? 0 : plan_->hold_frame_count;
  hold_until_s_ = halted_ ? std::min(kHaltHoldS, run_->hold_s) : run_->hold_s;
  after_end_ = 0;
  blind_ = 0;
  asks_again_ = false;
  phase_ = Phase::holding;
}

/// Without a question there is no other plan.
Decision PlanController::ask(const ArmEstimate& arm) {
  found_ = std::make_shared<std::optional<FollowedPlan>>();
  Decision decision;
  if (NextPlan question = next(progress(), arm)) {
    decision.question = [question = std::move(question), answer = found_] { *answer = question(); };
  }
  return decision;
}

/// @return the end of the run; none: it goes on
std::optional<Decision> PlanController::end_asking(const Moment& now) {
  std::optional<FollowedPlan> found = std::move(*std::exchange(found_, nullptr));
  take_next(now.arm);
  if (!found) {
    if (!halted_ || asks_again_) {
      return end();
    }
    asks_again_ = true;  // it may still have moved a little
    held_ = run_->arm.frames_in(kHaltHoldS);
    hold_until_s_ = run_->hold_s;
    phase_ = Phase::holding;
    return std::nullopt;
  }
  stop_reason_.clear();
  go_over_to(*std::move(found), "the next plan");
  ++replans_;
  begins_at_rest_ = true;
  goes_on_ = true;
  waits_ = false;
  phase_ = Phase::moving;
  return std::nullopt;
}

Decision PlanController::end() const {
  const bool has_left_plan = !is_at_end();  // else it came to its end all the same
  return {.reason = has_left_plan ? stop_reason_ : "", .has_left_plan = has_left_plan};
}

void PlanController::go_over_to(FollowedPlan next, const std::string& name) {
  require_plan_of(next.plan, run_->arm, name);
  if (next.plan.frames.front().setpoint_kpa != sent_kpa_) {
    throw InputError(name + " does not start at the set points that the arm holds");
  }
  plans_.push_back(std::move(next));
  plan_ = &plans_.back().plan;
  frame_ = 0;
  first_motion_ = ++motion_;
}

void PlanController::report(ExecutionResult& result) const {
  result.replans = replans_;
  result.switches = switches_;
  result.waits = waited_;
  result.halts = halts_;
  result.frames_not_certified = frames_not_certified_;
  result.advice = times_;
  if (advised_ && run_->in_real_time) {
    ++result.advice.late;  // the run has ended before it
  }
}

}  // namespace limber
