#include "limber/run/executor.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <future>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "limber/arm/arm_identity.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/run/controller.hpp"
#include "limber/run/gated_driver.hpp"
#include "limber/run/plan_controller.hpp"
#include "limber/world/straight_motion.hpp"
#include "run_message.hpp"
#include "run_watch.hpp"

namespace limber {

const char* to_string(ExecutionStatus status) {
  return status == ExecutionStatus::done    ? "done"
         : status == ExecutionStatus::fault ? "fault"
                                            : "stopped";
}

namespace {

bool has_arrived(const ArmDescription& arm, const ArmDriver& driver,
                 const Pressures& setpoint_kpa) {
  constexpr double kArrived = 0.01;  // of the limit, as planning's hold has it
  for (Eigen::Index i = 0; i < setpoint_kpa.size(); ++i) {
    const double limit = arm.limits_of_channel(int(i)).largest_kpa();
    if (!(std::abs(double(driver.state().pressure_kpa[i]) - double(setpoint_kpa[i])) <=
          kArrived * limit)) {
      return false;
    }
  }
  return true;
}

/// Leads an arm at rest to `start_kpa`, straight in pressure space, and holds it there until it has
/// settled: a plan takes the arm to have long stood at its start, so slow valves get their time.
/// Does nothing where no pressure is asked for.
/// @param before_each  called before every set point
void approach_start(const ArmDescription& arm, ArmDriver& driver, const Pressures& start_kpa,
                    const std::function<void()>& before_each) {
  if (start_kpa.isZero()) {
    return;
  }
  constexpr double kSettlingS = 3.0;  // at least: what full reversals take, and shapes to rest
  constexpr double kLongestSettlingS = 60.0;
  const Pressures vented_kpa = Pressures::Zero(arm.channel_count());
  for (const Pressures& setpoint_kpa :
       straight_setpoints(vented_kpa, start_kpa, arm.pressure_step_limit_kpa())) {
    before_each();
    driver.command(setpoint_kpa);
  }
  const int min_frames = arm.frames_in(kSettlingS);
  const int max_frames = arm.frames_in(kLongestSettlingS);
  for (int k = 0; k < min_frames || (k < max_frames && !has_arrived(arm, driver, start_kpa)); ++k) {
    before_each();
    driver.command(start_kpa);
  }
}

/// One of a controller's questions at a time. In real time it is worked out on a thread of its own,
/// so that no set point waits for it; in simulated time at once, so that runs can be repeated.
///
/// Threads: used by one. The destructor stops the other, if there is one, and waits for it.
class BackgroundQuestion {
 public:
  explicit BackgroundQuestion(bool in_real_time) : in_real_time_(in_real_time) {}
  ~BackgroundQuestion() { stop_ = true; }
  BackgroundQuestion(const BackgroundQuestion&) = delete;
  BackgroundQuestion& operator=(const BackgroundQuestion&) = delete;

  /// @pre the one before was answered
  void begin(std::function<void()> question) {
    if (in_real_time_) {
      answered_ = std::async(std::launch::async, [this, asked = std::move(question)] {
        const StopScope scope(&stop_);
        asked();
      });
    } else {
      question();
    }
  }

  /// Whether it is still being worked out.
  bool is_busy() const {
    return answered_.valid() &&
           answered_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  }

  /// Of one that is not busy: throws what it threw, once.
  void end() {
    if (answered_.valid()) {
      answered_.get();
    }
  }

 private:
  bool in_real_time_;
  std::atomic<bool> stop_{false};
  std::future<void> answered_;  // waits when it goes, with `stop_` still there
};

class Execution {
 public:
  Execution(const ArmDescription& arm, const Environment& environment, const Plan& plan,
            ArmDriver& driver, RunWatch::Look look, const ExecutionSettings& settings)
      : arm_(at_rate_of(plan.arm(), arm, "plan")),
        environment_(environment),
        plan_(plan),
        driver_(arm_, driver, true),
        settings_(settings),
        controller_(settings.controller != nullptr ? *settings.controller : open_loop_),
        estimate_(arm_, controller_.estimate_with()),
        watch_(arm_, environment, driver, estimate_, std::move(look), settings) {
    result_.planned_goal_time_s = planned_goal_time_s(environment.goal, plan);
  }

  /// Takes in the arm between frames.
  void observe(double time_s, const BackboneD& backbone) { watch_.observe(time_s, backbone); }

  ExecutionResult run() {
    const VentGuard vent_at_the_end(driver_);
    try {
      const Pressures& start_kpa = plan_.frames.front().setpoint_kpa;
      (void)driver_.state();  // a fault where it is none of this arm's
      approach_start(arm_, driver_, start_kpa,
                     [this] { throw_if_interrupted(settings_.should_stop); });
      watch_.start(plan_);
      require_start();
      estimate_.observe(start_kpa, driver_.state());
      tell({0.0, start_kpa, driver_.state()});
      controller_.begin(
          {arm_, plan_, settings_.hold_s, driver_.is_real_time(), driver_.limits_kpa()});
      follow();
    } catch (const SystemFault& fault) {
      result_.status = ExecutionStatus::fault;
      result_.message = fault.what();
    } catch (const Interrupted&) {
      result_.status = ExecutionStatus::stopped;
      result_.message = fmt::format("stopped on request after {} frames", watch_.frames());
    }
    controller_.report(result_);
    watch_.judge(result_);
    explain();
    return std::move(result_);
  }

 private:
  void follow() {
    BackgroundQuestion thinking(driver_.is_real_time());
    try {
      for (;;) {
        const bool is_busy = thinking.is_busy();
        if (!is_busy) {
          thinking.end();
          tell_of_obstacle();
        }
        if (is_held()) {
          controller_.held();
          send({.setpoint_kpa = Pressures(estimate_.setpoint_kpa()), .motion = motion_});
          continue;
        }
        Decision decision = controller_.step({estimate_, is_busy});
        if (decision.question && is_busy) {  // to wait for the first would leave the arm alone
          throw InputError("a controller asks a second question while its first is worked out");
        }
        if (decision.question) {
          thinking.begin(std::move(decision.question));
        } else if (!decision.setpoint_kpa) {
          vent_if_busy(thinking);
          end(decision);
          return;
        }
        if (decision.setpoint_kpa) {
          send(decision);
        }
      }
    } catch (...) {
      vent_if_busy(thinking);
      throw;
    }
  }

  /// Of a run that is over: now, not when the question is answered.
  void vent_if_busy(const BackgroundQuestion& thinking) {
    if (thinking.is_busy()) {
      driver_.vent();
    }
  }

  void send(const Decision& decision) {
    if (decision.begins_at_rest && !result_.open_loop_goal_error && watch_.shape()) {
      result_.open_loop_goal_error = pose_error(environment_.goal, tip_pose(*watch_.shape()));
    }
    followed_ = decision.plan != nullptr ? decision.plan : followed_;
    const Pressures& setpoint_kpa = *decision.setpoint_kpa;
    require_frame_rule(arm_, watch_.frames(), estimate_.setpoint_kpa(), setpoint_kpa);
    throw_if_interrupted(settings_.should_stop);
    const ArmState& state = driver_.command(setpoint_kpa);
    estimate_.observe(setpoint_kpa, state);
    motion_ = decision.motion;
    const Environment* now = watch_.take_in(setpoint_kpa, motion_);
    const std::string noticed = take_notice();
    tell({watch_.frames() * arm_.frame_period_s(), setpoint_kpa, state, now, noticed});
    appeared_ = now != nullptr ? now : appeared_;
    if (decision.plan != nullptr) {
      watch_.compare(*decision.plan, decision.frame);
    }
  }

  /// Of the arm, since the frame before.
  std::string take_notice() {
    std::string words = controller_.take_notice();
    const std::vector<PressureLoss>& losses = estimate_.pressure_losses();
    for (; losses_told_ < losses.size(); ++losses_told_) {
      words += (words.empty() ? "" : "; ") + to_text(losses[losses_told_]);
    }
    return words;
  }

  void tell(const ExecutedFrame& frame) const {
    if (settings_.on_frame) {
      settings_.on_frame(frame);
    }
  }

  void end(const Decision& decision) {
    const bool rests_in_goal = watch_.rests_in_goal(settings_.hold_s);
    result_.stopped_ahead = decision.has_left_plan && !rests_in_goal;
    if (!decision.reason.empty() && !(decision.has_left_plan && rests_in_goal)) {
      result_.status = ExecutionStatus::stopped;  // not done
      result_.message = decision.reason;
    }
  }

  void explain() {
    const Environment environment = with_appeared(environment_, result_);
    if (result_.message.empty()) {
      result_.message = why_not_arrived(result_, environment);
    }
    result_.hint = hint_of(result_, arm_, environment, followed_ != nullptr ? *followed_ : plan_,
                           correction());
    if (!result_.message.empty()) {
      result_.message += result_.hint;
    }
  }

  Correction correction() const {
    return settings_.controller == nullptr ? Correction::none
           : controller_.plans_again()     ? Correction::replans
                                           : Correction::feedback;
  }

  bool is_held() const {
    return driver_.is_real_time() && settings_.should_hold && settings_.should_hold();
  }

  /// While nothing is being worked out: that would be for the older environment.
  void tell_of_obstacle() {
    if (const Environment* now = std::exchange(appeared_, nullptr); now != nullptr) {
      controller_.obstacle_appeared(*now);
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

  const ArmDescription arm_;
  const Environment& environment_;
  const Plan& plan_;
  const Plan* followed_ = nullptr;  // the one that was followed last
  int motion_ = 0;                  // of the last frame
  GatedDriver driver_;
  const ExecutionSettings& settings_;
  OpenLoop open_loop_;
  Controller& controller_;
  ArmEstimate estimate_;
  RunWatch watch_;
  ExecutionResult result_;
  const Environment* appeared_ = nullptr;  // the controller does not know yet
  std::size_t losses_told_ = 0;
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
  refuse_if(plan.frames.empty(), "plan: no frames; expected at least its start");
  require_plan_of(plan, arm, "plan");
  require_plan_in(plan, environment, "plan");
  refuse_if(!(settings.hold_s >= 0.0) || settings.hold_s > 3600.0,
            "hold_s = {}; expected seconds from 0 to 3600", settings.hold_s);
  if (settings.max_start_error_m && !(*settings.max_start_error_m >= 0.0)) {
    throw InputError(fmt::format("max_start_error_m = {}; expected metres, at least 0",
                                 *settings.max_start_error_m));
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

Environment with_appeared(const Environment& environment, const ExecutionResult& result) {
  Environment all = environment;
  if (result.appeared) {
    all.obstacles.push_back(result.appeared->circle);
  }
  return all;
}

Recording recording_of(const ArmDescription& arm, const std::string& source, const Plan& plan,
                       const ExecutionResult& result, std::optional<std::uint64_t> motion_queries) {
  Recording recording = make_recording(arm, source, plan.seed);
  recording.settings =
      fmt::format("executed plan, environment '{}', model {}, planner {}, {}",
                  plan.environment_name, plan.model, plan.planner, to_string(result.status));
  if (motion_queries) {
    recording.settings += fmt::format(", closed loop, {} queries in motion", *motion_queries);
  }
  recording.episodes = {result.episode};
  return recording;
}

}  // namespace limber
