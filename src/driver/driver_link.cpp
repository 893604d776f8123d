#include "driver_link.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/seconds_since.hpp"

namespace limber {

namespace {

using std::chrono::milliseconds;

constexpr auto kHelloTime = milliseconds(10000);  // a board that resets when its port is opened
constexpr auto kUntilKilled = milliseconds(500);  // after its input was closed
constexpr auto kLastWords = milliseconds(20);     // for `vent` and `bye` to a driver in trouble
constexpr auto kUntilEnded = milliseconds(100);   // after it closed its output, on a busy machine
constexpr double kMaxStepFrames = 20.0;           // between two samples by the driver's clock
constexpr double kMaxRepeatFrames = 3.0;          // that a sample may be the newest for
constexpr double kMinStepS = 1e-6;       // of others: no device samples pressures faster …
constexpr int kPaceFrames = 20;          // … and over so many frames
constexpr double kMinPace = 0.1;         // they go on by this share of them at least
constexpr auto kLook = milliseconds(5);  // whether a vent is asked for
constexpr std::size_t kQuoted = 80;      // bytes of a wrong line in a message

}  // namespace

DriverLink::DriverLink(const ArmDescription& arm, const ProcessDriverSettings& settings)
    : settings_(settings),
      host_(host_hello(arm)),
      period_s_(arm.frame_period_s()),
      child_(command_words(settings.command), kMaxDriverLine),
      log_(settings.log, settings.command, settings.append_to_log) {
  last_words_.emplace(child_.input());
  if (settings_.calibration) {
    host_.limit_kpa = settings_.calibration->to_wire(host_.limit_kpa);
    log_.note("calibration: " + to_yaml(*settings_.calibration));
  }
}

const DriverHello& DriverLink::exchange_hellos() {
  try_to_send(to_line(host_));
  const Time deadline = Clock::now() + kHelloTime;
  while (!child_.output().has_input(std::min(deadline, Clock::now() + milliseconds(100)))) {
    if (interrupt_requested()) {
      end();
      throw Interrupted("stopped on request, before the driver had answered");
    }
    if (Clock::now() >= deadline) {
      break;
    }
  }
  const std::string line = next_line(deadline, "hello");
  try {
    hello_ = parse_driver_hello(line, host_);
  } catch (const InputError& error) {
    throw BrokenDriver(fmt::format("does not fit: {}", error.what()));
  } catch (const SystemFault& fault) {
    throw BrokenDriver(fault.what());
  }
  if (!hello_.real_time && !settings_.simulated) {
    end();
    throw InputError(
        "the driver says that it is a simulation (real_time: false in its hello), which is asked "
        "as fast as it answers. If it is one, say --simulated (simulated=True in Python); the "
        "driver of an arm leaves real_time out");
  }
  if (settings_.calibration && !hello_.limit_kpa.empty()) {
    hello_.limit_kpa = settings_.calibration->from_wire(hello_.limit_kpa);
  }
  return hello_;
}

ArmState DriverLink::set(const Pressures& setpoint_kpa, Clock::duration reply_time) {
  ++seq_;
  const Pressures on_wire =
      settings_.calibration ? settings_.calibration->to_wire(setpoint_kpa) : setpoint_kpa;
  const Time deadline = Clock::now() + reply_time;
  send(set_line(seq_, since_start_s(), on_wire), deadline);
  if (is_vent_asked_until_input(deadline)) {
    try_to_send(vent_line(seq_ + 1, since_start_s()));
    vent_ahead_ = true;
    (void)receive(deadline);
    throw Interrupted("stopped on request");
  }
  ArmState state = receive(deadline);
  require_pace();
  return state;
}

/// Until the driver says something, or `until`.
bool DriverLink::is_vent_asked_until_input(Time until) {
  while (Clock::now() < until) {
    if (interrupt_requested() || (settings_.vent_asked && settings_.vent_asked())) {
      return true;
    }
    if (child_.output().has_input(std::min(until, Clock::now() + kLook))) {
      return false;
    }
  }
  return false;
}

void DriverLink::wait_for_slot(Time slot) {
  if (is_vent_asked_until_input(slot)) {
    throw Interrupted("stopped on request");
  }
  wait_quietly(slot);
}

/// Samples of frames in a row: a clock that hardly goes on is no clock, or one of another unit.
void DriverLink::require_pace() {
  if (!std::exchange(paced_, true)) {
    pace_frames_ = 0;
    pace_from_s_ = *sample_s_;
  } else if (++pace_frames_ == kPaceFrames) {
    const double passed_s = *sample_s_ - std::exchange(pace_from_s_, *sample_s_);
    if (passed_s < kMinPace * kPaceFrames * period_s_) {
      throw BrokenDriver(fmt::format(
          "sent samples whose time went on by {:.3g} s in {} frames, which last {:.3g} s. `t` is "
          "in seconds",
          passed_s, kPaceFrames, kPaceFrames * period_s_));
    }
    pace_frames_ = 0;
  }
}

ArmState DriverLink::vent(Clock::duration reply_time) {
  ++seq_;
  const Time deadline = Clock::now() + reply_time;
  if (!std::exchange(vent_ahead_, false)) {
    send(vent_line(seq_, since_start_s()), deadline);
  }
  return receive(deadline);
}

void DriverLink::send(const std::string& line, Time deadline) {
  since_last_s_ = since_start_s() - std::exchange(asked_s_, since_start_s());
  log_.sent(line);
  if (last_words_) {
    last_words_->prepare(vent_line(seq_ + 1, since_start_s()));
  }
  if (!child_.write_line(line, deadline)) {
    say_why_it_is_silent("does not read its input", kLastWords);
  }
}

ArmState DriverLink::receive(Time deadline) {
  const std::string line = next_line(deadline, fmt::format("request {}", seq_));
  DriverReply reply;
  ArmState state;
  try {
    reply = parse_state(line, host_);
    state = calibrated(reply);
  } catch (const InputError& error) {
    throw BrokenDriver(fmt::format("answered request {} wrongly: {}", seq_, error.what()));
  } catch (const SystemFault& fault) {
    throw BrokenDriver(fault.what());
  }
  require_order(reply);
  if (sample_s_ != reply.state.time_s) {
    sample_s_ = reply.state.time_s;
    sample_since_ = Clock::now();
  }
  if (settings_.pass_bodies) {
    bodies_ = std::move(reply.bodies);
  }
  return state;
}

ArmState DriverLink::calibrated(DriverReply reply) {
  require_known_plane(reply);
  if (!settings_.calibration) {
    return std::move(reply.state);
  }
  ArmState state = settings_.calibration->from_wire(std::move(reply.state), reply.bodies);
  if (reply.bodies && !state.backbone && !seen_tilted_) {
    seen_tilted_ = true;
    Eigen::Index body = 0;
    const double tilt_rad =
        tilts_rad(*settings_.calibration->tracker->plane, *reply.bodies).maxCoeff(&body);
    log_.note(fmt::format(
        "marker body {} is turned {:.2f} rad out of the calibration's plane: while that is so, the "
        "arm counts as not seen. If it was moved: limber driver calibrate",
        body, tilt_rad));
  }
  return state;
}

void DriverLink::require_known_plane(const DriverReply& reply) const {
  const bool has_plane = settings_.calibration && settings_.calibration->tracker &&
                         settings_.calibration->tracker->plane;
  if (reply.bodies && !has_plane && !settings_.pass_bodies) {
    throw InputError(
        settings_.calibration
            ? "state: bodies: the calibration knows no plane for them; calibrate again: "
              "limber driver calibrate"
            : "state: bodies: only a calibration says where they are in the arm's frame; "
              "make one with limber driver calibrate, and give it with --calibration");
  }
  refuse_if(reply.state.backbone && has_plane,
            "state: backbone: the driver sent bodies when it was calibrated; calibrate it again: "
            "limber driver calibrate");
}

void DriverLink::require_order(const DriverReply& reply) const {
  if (reply.seq != seq_) {
    throw BrokenDriver(
        fmt::format("answered request {} with the state of request {}: {}", seq_, reply.seq,
                    reply.seq < seq_ ? "late, repeated or out of order" : "nobody asked for it"));
  }
  if (!sample_s_) {
    return;
  }
  const double step_s = reply.state.time_s - *sample_s_;
  if (!(step_s >= 0.0)) {
    throw BrokenDriver(
        fmt::format("sent a sample of {} s after one of {} s; by its own clock, time has to go on",
                    reply.state.time_s, *sample_s_));
  }
  if (step_s == 0.0) {
    return require_recent();
  }
  if (step_s < kMinStepS) {
    throw BrokenDriver(
        fmt::format("sent a sample {:.3g} s after the one before; no device samples so fast. `t` "
                    "is in seconds, when the sample was taken",
                    step_s));
  }
  if (paced_ && step_s > kMaxStepFrames * period_s_) {
    if (since_last_s_ > kMaxStepFrames * period_s_) {
      throw SystemFault(
          fmt::format("limber sent nothing for {:.2f} s, as it was stopped or the machine too busy",
                      since_last_s_));
    }
    throw BrokenDriver(fmt::format(
        "sent a sample {} s after the one before; a frame lasts {} s. `t` is in seconds", step_s,
        period_s_));
  }
}

/// Requests may overtake the sampling, so that the newest sample is one that limber has; but not
/// for long, and never in a simulation, which makes each sample when it is asked.
void DriverLink::require_recent() const {
  const double since_s = seconds_since(sample_since_);
  if (!hello_.real_time || since_s > kMaxRepeatFrames * period_s_) {
    throw BrokenDriver(
        fmt::format("sends its sample of {} s again {:.2f} s after it first did; by its own clock, "
                    "time has to go on",
                    *sample_s_, since_s));
  }
}

std::string DriverLink::next_line(Time deadline, const std::string& what) {
  std::string line;
  switch (child_.output().read_line(line, deadline)) {
    case LineReader::Read::line:
      log_.received(line);
      return line;
    case LineReader::Read::timeout:
      throw BrokenDriver(child_.output().has_part_of_line()
                             ? fmt::format("sent only part of a line in answer to {}", what)
                             : fmt::format("did not answer {} in time", what));
    case LineReader::Read::too_long:
      throw BrokenDriver(
          fmt::format("sent a line of more than {} bytes after {}", kMaxDriverLine, what));
    default:
      say_why_it_is_silent("closed its output", kUntilEnded);
  }
}

void DriverLink::wait_quietly(Time until) {
  if (vent_ahead_ || !child_.output().has_input(until)) {
    return;
  }
  const std::string line = next_line(Clock::now(), fmt::format("request {}", seq_));
  throw BrokenDriver(
      fmt::format("sent more than one answer to request {}: {}", seq_, in_one_line(line, kQuoted)));
}

void DriverLink::send_vent() {
  seq_ += std::exchange(vent_ahead_, false) ? 2 : 1;
  try_to_send(vent_line(seq_, since_start_s()));
}

VentAnswer DriverLink::vent_answer(Time until) {
  VentAnswer answer;
  std::string line;
  while (Clock::now() < until && child_.output().read_line(line, until) == LineReader::Read::line) {
    try {
      DriverReply reply = parse_vent_answer(line, host_);
      if (reply.seq == seq_) {
        log_.received(line);
        answer.state = settings_.calibration
                           ? settings_.calibration->from_wire(std::move(reply.state))
                           : std::move(reply.state);
        return answer;
      }
    } catch (const std::runtime_error&) {
      answer.is_unreadable = true;  // the next line may be the answer
    }
  }
  return answer;
}

void DriverLink::try_to_send(const std::string& line) {
  log_.sent(line);
  (void)child_.write_line(line, Clock::now() + kLastWords);
}

void DriverLink::end() {
  if (!open_) {
    return;
  }
  open_ = false;
  close_input();
  (void)child_.wait_for_end(*closed_at_ + kUntilKilled);
  child_.kill_group();
  if (const auto& left = child_.survivor()) {
    const std::string message = fmt::format(
        "the driver {} (pid {}). Its input is closed; see to it that it ends, and that the arm is "
        "vented, before anything else moves it",
        left->is_protected ? "can't be killed" : "was killed, and has not ended after a second",
        left->process);
    log_.note(message);
    if (settings_.say) {
      settings_.say(message);
    }
  }
}

void DriverLink::close_input() {
  last_words_.reset();
  child_.close_input();
  if (!closed_at_) {
    closed_at_ = Clock::now();
  }
}

void DriverLink::say_why_it_is_silent(const std::string& otherwise, milliseconds wait) {
  const bool ended = child_.wait_for_end(Clock::now() + wait);
  throw BrokenDriver(ended ? child_.how_it_ended() : otherwise);
}

}  // namespace limber
