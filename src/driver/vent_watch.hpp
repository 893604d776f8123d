#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

/// What a driver that broke the protocol says to a `vent`.
struct VentAnswer {
  std::optional<ArmState> state;  // its pressures alone
  bool is_unreadable = false;     // lines came, and none was a state
};

/// A vent, as the states show it that answer it. Only a sample that was taken after it confirms it:
/// one that is newer than the first answer, which may be of before.
class VentWatch {
 public:
  /// @param was_resting  nothing was commanded since the last vent: any sample confirms it
  VentWatch(const ArmDescription& arm, const SafetySettings& safety, bool was_resting)
      : arm_(arm), safety_(safety), was_resting_(was_resting) {}

  /// Takes in the state that answered the latest `vent`, `after_s` after the first.
  void note(const ArmState& state, double after_s);
  /// The same of a broken driver. @return whether it said anything
  bool note(const VentAnswer& answer, double after_s);

  /// Whether there is nothing to wait for: it is confirmed, or its time is over.
  bool is_over() const { return result_.confirmed || heard_s_ >= safety_.vent_time_s; }

  /// What came of it. Where it is not over, the driver has stopped answering.
  /// @param last_kpa  measured last, for where nothing was measured since
  VentResult result(const Pressures& last_kpa) const;

 private:
  std::string unconfirmed(const Pressures& last_kpa) const;
  std::string what_rose() const;
  std::string highest(const Pressures& pressure_kpa) const;

  const ArmDescription& arm_;
  SafetySettings safety_;
  bool was_resting_;
  VentResult result_;
  double heard_s_ = 0.0;           // when anything came last, readable or not
  bool is_unreadable_ = false;     // what came last
  std::optional<ArmState> first_;  // that answered
  Pressures now_kpa_;
  std::string rising_;
};

/// Notices a driver that has vented by itself: what is in force is zero, though nothing that was
/// sent recently is.
class OwnVentWatch {
 public:
  /// @param frames  in which a set point comes into force
  explicit OwnVentWatch(int frames) : kept_(std::size_t(std::max(frames, kFewestFrames))) {}

  void note_sent(const Pressures& setpoint_kpa);
  void clear() { sent_kpa_.clear(); }
  bool has_vented(const ArmState& state) const;

 private:
  static constexpr int kFewestFrames = 5;  // at low rates: a state may be of the frame before

  std::size_t kept_;
  std::deque<Pressures> sent_kpa_;  // the last ones, newest first; any of them may be in force
};

/// What is wrong with an arm that reads `pressure_kpa` after its first vent.
std::string not_zero_message(double pressure_kpa, const SafetySettings& safety);

}  // namespace limber
