#include "limber/driver/process_driver.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "driver_link.hpp"
#include "limber/common/arm_signals.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/run/safety_gate.hpp"
#include "punctual_thread.hpp"
#include "vent_watch.hpp"

namespace limber {

namespace {

using Clock = DriverLink::Clock;
using Time = DriverLink::Time;
using std::chrono::milliseconds;

constexpr auto kFirstReplyTime = milliseconds(2000);
constexpr auto kSimulatedReplyTime = milliseconds(10000);  // of a driver that keeps no frames
constexpr auto kBrokenReplyTime = milliseconds(500);       // of a broken driver, at most
constexpr double kReplyFrames = 2.0;                       // a state that takes longer is late
constexpr double kSilenceFrames = 3.0;  // without a `set`: the driver has vented by itself

std::atomic<bool> any_left_unsafe{false};

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

/// One driver from its start to its end.
class ProcessDriver::Session {
 public:
  Session(const ArmDescription& arm, const ProcessDriverSettings& settings)
      : arm_(arm),
        settings_(settings),
        link_((prepare(arm, settings), arm), settings),
        own_vent_(arm.frames_in(settings.safety.following_time_s)) {
    try {
      limits_kpa_ = limits_in_force(arm_, settings.limit_scale, link_.exchange_hellos().limit_kpa);
      gate_.emplace(arm_, limits_kpa_, settings.check_rate, settings.safety);
      watch_vent(kFirstReplyTime);
      require_vented();
    } catch (const BrokenDriver& broken) {
      stop_broken(broken.what());
    }
  }

  ~Session() {
    vent();
    if (link_.is_open()) {
      link_.say_bye();
      link_.end();
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
    throw_if_wrong(fault_);
    require_size(setpoint_kpa);
    try {
      throw_if_wrong(gate_->check_command(setpoint_kpa));
      throw_if_wrong(gate_->check_in_force(state_));  // of a vent: where a run begins
      resting_ = false;                               // a wait that is interrupted ends in a vent
      wait_for_slot();
      exchange(setpoint_kpa);
      throw_if_wrong(own_vent_.has_vented(state_)
                         ? "the driver has vented by itself: its set point in force is zero"
                         : "");
      throw_if_wrong(advised(gate_->check_state(state_)));
    } catch (const BrokenDriver& broken) {
      stop_broken(broken.what());
    } catch (const SystemFault& fault) {
      fault_ = fault.what();
      link_.log().note(fault_);
      vent();
      throw;
    }
    return state_;
  }

  void vent() noexcept {
    if (!link_.is_open() || resting_) {
      return;
    }
    try {
      watch_vent(reply_time());
    } catch (const std::exception& error) {
      any_left_unsafe = true;  // whatever the next vent confirms: a driver broke
      say(error.what());
      link_.end();
    }
  }

  const ArmState& look() {
    throw_if_wrong(fault_);
    watch_vent(reply_time());
    throw_if_wrong(fault_);
    return state_;
  }

  ArmState read_after_silence(double silence_s) {
    try {
      link_.forget_pace();
      link_.wait_quietly(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                            std::chrono::duration<double>(silence_s)));
      ArmState state = link_.vent(reply_time());
      vent();
      return state;
    } catch (const BrokenDriver& broken) {
      stop_broken(broken.what());
    }
  }

  void abandon(bool killed) {
    if (killed) {
      link_.kill();
    }
    fault_ = "the driver was abandoned";
    link_.end();
    if (link_.is_left_running()) {
      throw SystemFault("the driver can't be started again while it runs");
    }
  }

  const ArmState& first_state() const { return first_state_; }
  const ArmState& state() const { return state_; }
  const DriverHello& hello() const { return link_.hello(); }
  const std::optional<WireCalibration>& calibration() const { return settings_.calibration; }
  const DriverTiming& timing() const { return timing_; }
  const VentResult& last_vent() const { return vent_; }
  const std::vector<PressureLimits>& limits_kpa() const { return limits_kpa_; }

 private:
  static void prepare(const ArmDescription& arm, const ProcessDriverSettings& settings) {
    require_pressure_driven(arm, "a driver");
    if (settings.install_signals) {
      install_arm_signals();
    }
  }

  bool real_time() const { return link_.hello().real_time; }

  /// What is measured wrongly may be measured right, in another order, unit or frame.
  std::string advised(std::string wrong) const {
    if (!wrong.empty() && !settings_.calibration) {
      wrong +=
          ". If this driver was never calibrated: limber driver calibrate finds the order and the "
          "signs of its channels and the frame of its tracker (docs/first_day.md)";
    }
    return wrong;
  }

  Clock::duration frames(double count) const {
    return std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(count * arm_.frame_period_s()));
  }

  Clock::duration reply_time() const {
    return real_time() ? frames(kReplyFrames) : Clock::duration(kSimulatedReplyTime);
  }

  void require_size(const Eigen::Ref<const Pressures>& setpoint_kpa) const {
    refuse_if(setpoint_kpa.size() != arm_.channel_count(),
              "{} set points; arm '{}' has {} segments", setpoint_kpa.size(), arm_.name,
              arm_.channel_count());
  }

  void wait_for_slot() {
    const Time now = Clock::now();
    if (!running_ || !real_time()) {
      running_ = true;
      if (real_time()) {
        punctual_.emplace();
      }
      slot_ = real_time() ? std::max(now, asked_ + frames(1.0)) : now;
    } else {
      slot_ += frames(1.0);
      throw_if_silent(now);
      while (slot_ + frames(1.0) <= now) {
        slot_ += frames(1.0);
        ++timing_.skipped_slots;
      }
    }
    link_.wait_for_slot(slot_);
    const Time woken = Clock::now();
    if (real_time()) {
      throw_if_silent(woken);
    }
    timing_.late_s.push_back(seconds(woken - slot_));
  }

  /// What goes out after so long would meet an arm that has vented.
  void throw_if_silent(Time now) const {
    if (now - slot_ > frames(kSilenceFrames - 1.0)) {
      throw SystemFault(
          fmt::format("limber sent no set point for {:.2f} s, as it was stopped or the machine "
                      "too busy: by now the driver has vented by itself",
                      seconds(now - slot_ + frames(1.0))));
    }
  }

  void exchange(const Eigen::Ref<const Pressures>& setpoint_kpa) {
    own_vent_.note_sent(setpoint_kpa);
    asked_ = Clock::now();
    const double sent_s = link_.since_start_s();
    state_ = link_.set(setpoint_kpa, reply_time());
    timing_.last = {sent_s, link_.since_start_s(), link_.bodies()};
    timing_.round_trip_s.push_back(seconds(Clock::now() - asked_));
    const bool seen = state_.backbone || state_.space_backbone || link_.bodies();
    timing_.frames_unseen += hello().tracked && !seen ? 1 : 0;
  }

  /// Vents, and watches the pressures come down. @throws SystemFault as stop_broken
  void watch_vent(Clock::duration first_reply_time) try {
    const Time start = Clock::now();
    running_ = false;
    own_vent_.clear();
    link_.forget_pace();
    link_.wait_quietly(start);
    asked_ = start;
    state_ = link_.vent(first_reply_time);
    if (!started_) {
      first_state_ = state_;
    }
    VentWatch watch(arm_, settings_.safety, resting_);
    Time slot = Clock::now();
    for (int frame = 0;; ++frame) {
      // Simulated time counts where the driver runs as fast as it is asked.
      watch.note(state_,
                 real_time() ? seconds(Clock::now() - start) : frame * arm_.frame_period_s());
      if (watch.is_over()) {
        break;
      }
      slot = real_time() ? slot + frames(1.0) : Clock::now();
      link_.wait_quietly(slot);
      asked_ = Clock::now();
      state_ = link_.vent(reply_time());
    }
    end_vent(watch);
    punctual_.reset();
    gate_->note_vented(state_);
  } catch (const BrokenDriver& broken) {
    stop_broken(broken.what());
  }

  void end_vent(const VentWatch& watch) {
    vent_ = watch.result(state_.pressure_kpa);
    // Before the first run, and where the arm was at rest, nothing was to be vented.
    if (!std::exchange(resting_, true) || !vent_.confirmed) {
      say(vent_.message);
    }
    if (started_ && !vent_.confirmed) {  // whoever was told to shut off the supply comes near it
      any_left_unsafe = true;
      fault_ = fault_.empty() ? vent_.message : fault_;
    }
  }

  /// After the first vent: what a vented arm reads says whether the driver's unit is right.
  void require_vented() {
    started_ = true;
    if (!vent_.confirmed) {
      link_.say_bye();
      link_.end();
      throw SystemFault(not_zero_message(vent_.pressure_kpa, settings_.safety));
    }
  }

  void say(const std::string& message) {
    link_.log().note(message);
    if (settings_.say) {
      settings_.say(message);
    }
  }

  /// Vents a driver that broke the protocol, ends it and throws.
  [[noreturn]] void stop_broken(const std::string& why) {
    fault_ = fmt::format("driver '{}' {}", settings_.command, why);
    link_.log().note(fault_);
    if (link_.is_open()) {
      watch_broken_vent();
      link_.end();
    }
    throw SystemFault(fault_);
  }

  /// As long as it answers in time, it is watched until it has vented. One that does not reads the
  /// end of its input at once, and may still say what it measures.
  void watch_broken_vent() {
    VentWatch watch(arm_, settings_.safety, resting_);
    const Time start = Clock::now();
    const auto note = [&](const VentAnswer& answer) {
      if (answer.state) {
        state_ = *answer.state;
      }
      return watch.note(answer, seconds(Clock::now() - start));
    };
    const auto in_time = std::min(reply_time(), Clock::duration(kBrokenReplyTime));
    Time sent;
    do {
      std::this_thread::sleep_until(sent + frames(1.0));
      sent = Clock::now();
      link_.send_vent();
    } while (note(link_.vent_answer(sent + in_time)) && !watch.is_over());
    link_.close_input();
    if (!watch.is_over()) {
      (void)note(link_.vent_answer(sent + kBrokenReplyTime));
    }
    if (started_ && !resting_) {
      end_vent(watch);
    }
  }

  ArmDescription arm_;
  ProcessDriverSettings settings_;
  DriverLink link_;
  OwnVentWatch own_vent_;
  std::vector<PressureLimits> limits_kpa_;
  std::optional<SafetyGate> gate_;
  ArmState state_;
  ArmState first_state_;
  DriverTiming timing_;
  VentResult vent_;
  std::string fault_;
  Time slot_;
  Time asked_;                              // of the last request
  bool running_ = false;                    // slots are counted since the last vent
  std::optional<PunctualThread> punctual_;  // until the next vent is confirmed
  bool resting_ = true;                     // nothing was commanded since the last vent
  bool started_ = false;                    // the first vent is over
};

ProcessDriver::ProcessDriver(const ArmDescription& arm, const ProcessDriverSettings& settings)
    : session_(std::make_unique<Session>(arm, settings)) {}
ProcessDriver::~ProcessDriver() = default;

const ArmState& ProcessDriver::state() const {
  return session_->state();
}

const ArmState& ProcessDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  return session_->command(setpoint_kpa);
}

bool ProcessDriver::is_real_time() const {
  return session_->hello().real_time;
}

void ProcessDriver::vent() noexcept {
  session_->vent();
}

const ArmState& ProcessDriver::look() {
  return session_->look();
}

ArmState ProcessDriver::read_after_silence(double seconds) {
  return session_->read_after_silence(seconds);
}

void ProcessDriver::abandon(bool killed) {
  session_->abandon(killed);
}

const ArmState& ProcessDriver::first_state() const {
  return session_->first_state();
}

const DriverHello& ProcessDriver::hello() const {
  return session_->hello();
}

const std::optional<WireCalibration>& ProcessDriver::calibration() const {
  return session_->calibration();
}

const DriverTiming& ProcessDriver::timing() const {
  return session_->timing();
}

const VentResult& ProcessDriver::last_vent() const {
  return session_->last_vent();
}

bool ProcessDriver::was_any_left_unsafe() {
  return any_left_unsafe || ChildProcess::was_any_left();
}

std::vector<PressureLimits> ProcessDriver::limits_kpa() const {
  return session_->limits_kpa();
}

}  // namespace limber
