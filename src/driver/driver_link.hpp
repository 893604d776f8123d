#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "child_process.hpp"
#include "limber/common/arm_signals.hpp"
#include "limber/common/error.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/driver/driver_protocol.hpp"
#include "limber/driver/driver_run.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "vent_watch.hpp"

namespace limber {

/// The driver broke the protocol, or does not answer: nothing that it says counts any more.
class BrokenDriver : public SystemFault {
 public:
  using SystemFault::SystemFault;
};

/// The protocol's rules over a running program: one state for each request, with its number, in
/// time, and samples whose time goes on, or that were new three frames ago.
/// Every rule that the driver breaks is a BrokenDriver.
/// Threads: one at a time.
class DriverLink {
 public:
  using Clock = ChildProcess::Clock;
  using Time = Clock::time_point;

  /// Starts the program. Everything but the log is on the arm's side of the calibration.
  /// @throws InputError where that can't be done.
  DriverLink(const ArmDescription& arm, const ProcessDriverSettings& settings);

  /// @throws BrokenDriver, Interrupted.
  const DriverHello& exchange_hellos();
  const DriverHello& hello() const { return hello_; }

  /// One request and its state, which has to come before `reply_time` has passed. A vent that is
  /// asked for meanwhile goes out at once, and is the next `vent`.
  /// @throws Interrupted after that.
  ArmState set(const Pressures& setpoint_kpa, Clock::duration reply_time);
  ArmState vent(Clock::duration reply_time);

  /// Waits until `until`, in which time the driver has nothing to say, but to a vent sent ahead.
  void wait_quietly(Time until);
  /// The same, before a `set`. @throws Interrupted where a vent is asked for.
  void wait_for_slot(Time slot);

  /// Another run of frames begins: its first sample may be any time after the last one.
  void forget_pace() { paced_ = false; }

  /// Of a driver that broke the protocol: what answers send_vent before `until`. Its shape counts
  /// for nothing, which may be what is broken; states of other requests are passed over.
  void send_vent();
  VentAnswer vent_answer(Time until);

  void say_bye() { try_to_send(bye_line()); }

  /// The driver reads the end of its input, and vents.
  void close_input();

  /// Closes its input, waits until it ends, for 0.5 s at most, and kills it and its process group.
  /// One that can't be killed is left after a second, and that is said.
  void end();
  /// At once; `end` is left to do.
  void kill() { child_.kill_group(); }
  bool is_open() const { return open_; }
  bool is_left_running() const { return child_.survivor().has_value(); }

  DriverLog& log() { return log_; }
  /// limber's clock, as requests have it.
  double since_start_s() const { return seconds_since(start_); }
  /// Of the last state, where bodies pass.
  const std::optional<BodyPoses>& bodies() const { return bodies_; }

 private:
  bool is_vent_asked_until_input(Time until);
  void send(const std::string& line, Time deadline);
  ArmState receive(Time deadline);
  void require_order(const DriverReply& reply) const;
  void require_recent() const;
  void require_pace();
  std::string next_line(Time deadline, const std::string& what);
  void try_to_send(const std::string& line);
  /// How it ended, if it ends within that time.
  [[noreturn]] void say_why_it_is_silent(const std::string& otherwise,
                                         std::chrono::milliseconds wait);
  ArmState calibrated(DriverReply reply);
  void require_known_plane(const DriverReply& reply) const;

  ProcessDriverSettings settings_;
  HostHello host_;
  double period_s_;
  ChildProcess child_;
  std::optional<LastWords> last_words_;  // until its input is closed
  DriverLog log_;
  bool vent_ahead_ = false;  // was sent before the state of seq_ was there, with the next number
  DriverHello hello_;
  Time start_ = Clock::now();
  std::int64_t seq_ = 0;
  std::optional<double> sample_s_;  // of the last state, by the driver's clock …
  Time sample_since_;               // … and when that came first
  double asked_s_ = 0.0;            // when the last request left …
  double since_last_s_ = 0.0;       // … and how long after the one before
  std::optional<BodyPoses> bodies_;
  bool seen_tilted_ = false;       // some body, which the log says once
  bool paced_ = false;             // the next sample is about a frame after it
  int pace_frames_ = 0;            // since this was checked …
  double pace_from_s_ = 0.0;       // … at this sample
  std::optional<Time> closed_at_;  // its input
  bool open_ = true;
};

}  // namespace limber
