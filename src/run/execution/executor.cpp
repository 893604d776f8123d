#include "limber/run/executor.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <future>
#include <list>
#include <utility>

#include <fmt/format.h>

#include "advice_job.hpp"
#include "limber/run/gated_driver.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/units.hpp"
#include "run_message.hpp"
#include "run_watch.hpp"
#include "start_approach.hpp"
#include "vent_guard.hpp"

namespace limber {

namespace {

constexpr double kHaltHoldS = 0.3;      // that a halted arm stands before it is asked how to go on
constexpr double kLongestBlindS = 1.0;  // waited for the arm to be tracked, before the next plan

class Execution {
 public:
  Execution(const ArmDescription& arm, const Environment& environment, const Plan& plan,
            ArmDriver& driver, RunWatch::Look look, const ExecutionSettings& settings)
      : arm_(arm),
        environment_(environment),
        plans_{plan},
        plan_(&plans_.back()),
        driver_(arm, driver, true),
        settings_(settings),
        watch_(arm, environment, driver, std::move(look), settings) {
    result_.planned_goal_time_s = planned_goal_time_s(environment.goal, plan);
  }

  /// Takes in the arm between frames.
  void observe(double time_s, const BackboneD& backbone) { watch_.observe(time_s, backbone); }

  ExecutionResult run() {
    const VentGuard vent_at_the_end(driver_);
    try {
      approach_start(arm_, driver_, plan_->frames.front().setpoint_kpa,
                     [this] { throw_if_stopped(); });
      watch_.start(*plan_);
      require_start();
      if (settings_.replanner != nullptr) {
        settings_.replanner->observe(plan_->frames.front().setpoint_kpa, driver_.state());
      }
      if (settings_.controller != nullptr) {
        follow_controller();
      } else {
        do {
          follow();
        } while (settings_.replanner != nullptr && go_on());
      }
    } catch (const SystemFault& fault) {
      result_.status = ExecutionStatus::fault;
      result_.message = fault.what();
    } catch (const Interrupted&) {
      result_.status = ExecutionStatus::stopped;
      result_.message =
          fmt::format("stopped on request after {} frames; the arm was vented", watch_.frames());
    }
    watch_.judge(result_);
    if (result_.message.empty()) {
      result_.message = why_not_arrived(result_, with_appeared(environment_, result_), *plan_,
                                        settings_.controller != nullptr  ? Correction::feedback
                                        : settings_.replanner != nullptr ? Correction::replans
                                                                         : Correction::none);
    }
    return std::move(result_);
  }

 private:
  /// The plan, or its beginning where its rest must not be followed, and the hold.
  void follow() {
    halted_ = !move();
    result_.halts += halted_ ? 1 : 0;
    // A plan's own hold counts: planner and executor judge the goal at the same moment.
    hold(halted_ ? 0 : plan_->hold_frame_count,
         halted_ ? std::min(kHaltHoldS, settings_.hold_s) : settings_.hold_s);
  }

  /// @param held  frames of the hold that are over
  /// @param until_s  since the hold began
  void hold(int held, double until_s) {
    int late = 0;  // frames after the plan's end, in which its last ones are seen
    for (int k = held; k < arm_.frames_in(until_s);) {
      k = hold_frame() ? k + 1 : 0;
      if (!halted_) {
        watch_.compare(*plan_, frame_ + static_cast<std::size_t>(++late));
      }
    }
  }

  /// Holds; or goes on along the plan, where its source has it that an arm held now strikes.
  /// @return whether the arm held
  bool hold_frame() {
    const std::size_t before = std::exchange(frame_, correct_setpoint(frame_));
    command(held_kpa());
    return frame_ == before;
  }

  /// Holds whatever becomes of it: a plan that starts there is being made.
  void hold_still() {
    if (settings_.replanner != nullptr && !settings_.replanner->may_hold()) {
      ++result_.frames_not_certified;
    }
    command(held_kpa());
  }

  /// Commands the plan's frames, and those of plans that replace it meanwhile.
  /// @return whether the last of them came to its end
  bool move() {
    AdviceJob job(driver_.is_real_time(), result_.advice);
    frame_ = 0;
    try {
      bool goes_on = true;
      for (bool waits = false; goes_on && frame_ + 1 < plan_->frames.size();) {
        const std::size_t wanted = waits ? frame_ : frame_ + 1;
        const Pressures planned_kpa = plan_->frames[wanted].setpoint_kpa;
        const std::size_t next = correct_setpoint(wanted);
        waits = next == frame_;
        ask_for_advice(job, next);
        command(plan_->frames[next].setpoint_kpa);
        if (!job.is_busy()) {
          tell_of_obstacle();
        }
        if (waits) {
          ++result_.waits;
        } else {
          frame_ = next;
          watch_.compare(*plan_, frame_);
          count_motion(planned_kpa);
        }
        goes_on = is_at_end() || may_go_on();
        if (std::optional<MotionAdvice> advice = job.end(); advice && goes_on) {
          waits = advice->kind == MotionAdvice::Kind::wait;
          goes_on = take(std::move(*advice));
        } else {
          waits = false;
        }
      }
      while (job.is_busy()) {
        hold_frame();  // nothing else may be asked before that
      }
      return is_at_end();
    } catch (...) {
      if (job.is_busy()) {
        driver_.vent();  // now, not when the search has ended
      }
      throw;
    }
  }

  bool is_at_end() const { return frame_ + 1 == plan_->frames.size(); }

  bool may_go_on() {
    return settings_.replanner == nullptr ||
           settings_.replanner->may_go_on(*plan_, frame_ - std::min(frame_, watch_.lag()),
                                          driver_.state());
  }

  /// As the source of plans wants it. The plan shows what is sent.
  /// @return the frame of the plan that is sent
  std::size_t correct_setpoint(std::size_t next) {
    if (settings_.replanner == nullptr) {
      return next;
    }
    FrameSetpoint sent = settings_.replanner->setpoint(*plan_, frame_, next);
    if (sent.frame < frame_ || sent.frame >= plan_->frames.size()) {
      throw InputError(fmt::format("a source of plans stands in {} of its plan; expected {} to {}",
                                   frame_name(static_cast<Eigen::Index>(sent.frame)), frame_,
                                   plan_->frames.size() - 1));
    }
    result_.frames_not_certified += sent.is_certified ? 0 : 1;
    require_frame_rule(arm_, watch_.frames(), held_kpa(), sent.kpa);
    plan_->frames[sent.frame].setpoint_kpa = std::move(sent.kpa);
    return sent.frame;
  }

  void ask_for_advice(AdviceJob& job, std::size_t next) {
    if (settings_.replanner != nullptr) {
      job.begin(settings_.replanner->advise(*plan_, next));
    }
  }

  /// @return whether the arm goes on
  bool take(MotionAdvice advice) {
    if (advice.kind == MotionAdvice::Kind::stop) {
      stop_reason_ = std::move(advice.reason);
      return is_at_end();
    }
    if (advice.plan) {
      go_over_to(std::move(*advice.plan), "the plan that replaces it in motion");
      ++result_.switches;
      frame_ = 0;
    }
    return true;
  }

  void go_over_to(Plan next, const std::string& name) {
    require_plan_of(next, arm_, name);
    if (next.frames.front().setpoint_kpa != held_kpa()) {
      throw InputError(name + " does not start at the set points that the arm holds");
    }
    plans_.push_back(std::move(next));
    plan_ = &plans_.back();
    first_motion_ = ++motion_;
  }

  /// Every frame's set points from the controller, until it ends the run.
  void follow_controller() {
    const std::vector<PlanFrame>& frames = plan_->frames;
    Pressures before_kpa = frames.front().setpoint_kpa;
    while (const std::optional<Pressures> next = settings_.controller->next(driver_.state())) {
      require_frame_rule(arm_, watch_.frames(), before_kpa, *next);
      command(*next);
      before_kpa = *next;
      if (watch_.frames() < static_cast<int>(frames.size())) {
        watch_.compare(*plan_, static_cast<std::size_t>(watch_.frames()));
      }
    }
    if (std::string reason = settings_.controller->stop_reason(); !reason.empty()) {
      result_.status = ExecutionStatus::stopped;
      result_.message = std::move(reason);
    }
  }

  const Pressures& held_kpa() const { return plan_->frames[frame_].setpoint_kpa; }

  /// @return whether there is another plan to follow
  bool go_on() {
    for (int k = 0; k < arm_.frames_in(kLongestBlindS) && !driver_.state().backbone; ++k) {
      hold_still();
    }
    std::optional<Plan> next = ask_for_next();
    if (!next && halted_) {  // it may still have moved a little
      hold(arm_.frames_in(kHaltHoldS), settings_.hold_s);
      next = ask_for_next();
    }
    if (!next) {
      const bool rests_in_goal = watch_.rests_in_goal(settings_.hold_s);
      result_.stopped_ahead = !is_at_end() && !rests_in_goal;
      if (!stop_reason_.empty() && !rests_in_goal) {
        result_.status = ExecutionStatus::stopped;  // not done: it was stopped in mid-motion
        result_.message = stop_reason_;
      }
      return false;
    }
    stop_reason_.clear();
    go_over_to(std::move(*next), "the next plan");
    if (result_.replans++ == 0 && watch_.shape()) {
      result_.open_loop_goal_error = pose_error(environment_.goal, tip_pose(*watch_.shape()));
    }
    return true;
  }

  /// A driver in real time gets its set points while the next plan is searched for; simulated time
  /// stands still meanwhile, so that runs can be repeated.
  std::optional<Plan> ask_for_next() {
    tell_of_obstacle();
    if (!driver_.is_real_time()) {
      return settings_.replanner->next(*plan_, frame_, driver_.state());
    }
    std::future<std::optional<Plan>> next =
        std::async(std::launch::async, [this, state = driver_.state()] {
          return settings_.replanner->next(*plan_, frame_, state);
        });
    try {
      while (next.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        hold_still();
      }
    } catch (...) {
      driver_.vent();  // now, not when the search has ended
      throw;
    }
    return next.get();
  }

  void throw_if_stopped() const {
    throw_if_interrupted();
    if (settings_.should_stop && settings_.should_stop()) {
      throw Interrupted("stopped on request");
    }
  }

  void command(const Pressures& setpoint_kpa) {
    throw_if_stopped();
    const ArmState& state = driver_.command(setpoint_kpa);
    const Environment* now = watch_.take_in(setpoint_kpa, motion_);
    if (settings_.replanner != nullptr) {
      settings_.replanner->observe(setpoint_kpa, state);
      appeared_ = now != nullptr ? now : appeared_;
    }
  }

  /// While nothing is being worked out: that would be for the environment of before.
  void tell_of_obstacle() {
    if (const Environment* now = std::exchange(appeared_, nullptr);
        now != nullptr && settings_.replanner != nullptr) {
      settings_.replanner->obstacle_appeared(*now);
    }
  }

  void require_start() const {
    if (settings_.max_start_error_m && watch_.start_error_m() > *settings_.max_start_error_m) {
      throw InputError(fmt::format(
          "the arm is {:.1f} cm from where the plan starts; at most {:.1f} cm are allowed. Plan "
          "from where it is (limber plan --start-from-driver, or `start` in the environment file), "
          "or allow more (--max-start-error-m). If a vented arm never lies there, the lengths in "
          "the arm file are not its own",
          kCmPerM * watch_.start_error_m(), kCmPerM * *settings_.max_start_error_m));
    }
  }

  /// A motion ends where its edge of the plan does.
  void count_motion(const Pressures& setpoint_kpa) {
    const auto next = static_cast<std::size_t>(motion_ - first_motion_) + 1;
    if (next + 1 < plan_->waypoints_kpa.size() && setpoint_kpa == plan_->waypoints_kpa[next]) {
      ++motion_;
    }
  }

  const ArmDescription& arm_;
  const Environment& environment_;
  std::list<Plan> plans_;  // one after another, with the set points that were sent
  Plan* plan_;             // the one that is followed
  std::size_t frame_ = 0;  // the last one of it that was commanded
  GatedDriver driver_;
  const ExecutionSettings& settings_;
  RunWatch watch_;
  ExecutionResult result_;
  bool halted_ = false;
  int motion_ = 0;
  int first_motion_ = 0;                   // of the plan that is followed
  std::string stop_reason_;                // of the plan that was left last
  const Environment* appeared_ = nullptr;  // the source of plans does not know yet
};

/// Sees every shape of the arm as long as it lives.
class ObserverGuard {
 public:
  ObserverGuard(const TrueShape& truth, Execution& execution) : truth_(truth) {
    truth_.observe([&execution](double time_s, const BackboneD& backbone) {
      execution.observe(time_s, backbone);
    });
  }
  ~ObserverGuard() { truth_.observe({}); }
  ObserverGuard(const ObserverGuard&) = delete;
  ObserverGuard& operator=(const ObserverGuard&) = delete;

 private:
  const TrueShape& truth_;
};

void check(const ArmDescription& arm, const Environment& environment, const Plan& plan,
           const ExecutionSettings& settings) {
  if (plan.frames.empty()) {
    throw InputError("plan: no frames; expected at least its start");
  }
  require_plan_of(plan, arm, "plan");
  require_plan_in(plan, environment, "plan");
  if (!(settings.hold_s >= 0.0) || settings.hold_s > 3600.0) {
    throw InputError(fmt::format("hold_s = {}; expected seconds from 0 to 3600", settings.hold_s));
  }
}

}  // namespace

ExecutionResult execute(const ArmDescription& arm, const Environment& environment, const Plan& plan,
                        ArmDriver& driver, const ExecutionSettings& settings) {
  check(arm, environment, plan, settings);
  const RunWatch::Look measured = [&driver]() -> std::optional<BackboneD> {
    const std::optional<Backbone>& backbone = driver.state().backbone;
    return backbone ? std::optional<BackboneD>(backbone->cast<double>()) : std::nullopt;
  };
  return Execution(arm, environment, plan, driver, measured, settings).run();
}

ExecutionResult execute(const ArmDescription& arm, const Environment& environment, const Plan& plan,
                        ArmDriver& driver, const TrueShape& truth,
                        const ExecutionSettings& settings) {
  check(arm, environment, plan, settings);
  Execution execution(
      arm, environment, plan, driver, [&truth] { return std::optional<BackboneD>(truth.now()); },
      settings);
  const ObserverGuard observer(truth, execution);
  return execution.run();
}

}  // namespace limber
