#include "vent_watch.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/arm/names.hpp"

namespace limber {

namespace {

constexpr double kSetpointRoundingKpa = 1.0;  // of a device that counts in steps

}  // namespace

/// "; segment 1 rose by 7.0 kPa while venting", or nothing.
std::string VentWatch::what_rose() const {
  for (Eigen::Index s = 0; s < now_kpa_.size(); ++s) {
    const double rose_kpa =
        std::abs(double(now_kpa_[s])) - std::abs(double(first_->pressure_kpa[s]));
    if (rose_kpa > safety_.rise_kpa) {
      return fmt::format("; {} rose by {:.1f} kPa while venting", channel_name(arm_, s), rose_kpa);
    }
  }
  return "";
}

/// "segment 1 at 43 kPa", of the one with the highest pressure.
std::string VentWatch::highest(const Pressures& pressure_kpa) const {
  Eigen::Index worst = 0;
  pressure_kpa.cwiseAbs().maxCoeff(&worst);
  return fmt::format("{} at {:.0f} kPa", channel_name(arm_, worst), pressure_kpa[worst]);
}

void VentWatch::note(const ArmState& state, double after_s) {
  if (!first_) {
    first_ = state;
  }
  now_kpa_ = state.pressure_kpa;
  if (rising_.empty()) {
    rising_ = what_rose();
  }
  result_.pressure_kpa = now_kpa_.cwiseAbs().maxCoeff();
  result_.after_s = heard_s_ = after_s;
  result_.confirmed =
      result_.pressure_kpa <= safety_.vented_kpa && (was_resting_ || state.time_s > first_->time_s);
}

bool VentWatch::note(const VentAnswer& answer, double after_s) {
  is_unreadable_ = answer.is_unreadable;
  if (answer.state) {
    note(*answer.state, after_s);
  } else if (is_unreadable_) {
    heard_s_ = after_s;
  }
  return answer.state || is_unreadable_;
}

VentResult VentWatch::result(const Pressures& last_kpa) const {
  VentResult result = result_;
  if (!first_) {
    result.pressure_kpa = last_kpa.cwiseAbs().maxCoeff();
  }
  result.message = result_.confirmed
                       ? fmt::format("vented: {:.1f} kPa after {:.1f} s{}{}", result_.pressure_kpa,
                                     result_.after_s, rising_, rising_.empty() ? "" : ", then fell")
                       : unconfirmed(last_kpa);
  return result;
}

/// Says what was measured, and when: somebody has to decide by it.
std::string VentWatch::unconfirmed(const Pressures& last_kpa) const {
  if (is_over() && !is_unreadable_) {
    return fmt::format("VENT NOT CONFIRMED: {}, shut off the supply{}", highest(now_kpa_), rising_);
  }
  const char* why = is_unreadable_ ? "gives no readable answer" : "does not answer any more";
  if (!first_) {
    return fmt::format(
        "VENT NOT CONFIRMED: the driver {}; it last read {}, before the vent. Shut off the supply",
        why, highest(last_kpa));
  }
  return fmt::format(
      "VENT NOT CONFIRMED: the driver {}; it last read {}, {:.1f} s after the vent{}. Shut off the "
      "supply",
      why, highest(now_kpa_), result_.after_s, rising_);
}

void OwnVentWatch::note_sent(const Pressures& setpoint_kpa) {
  sent_kpa_.push_front(setpoint_kpa);
  if (sent_kpa_.size() > kept_) {
    sent_kpa_.pop_back();
  }
}

bool OwnVentWatch::has_vented(const ArmState& state) const {
  return state.setpoint_kpa && state.setpoint_kpa->isZero() && sent_kpa_.size() == kept_ &&
         std::none_of(sent_kpa_.begin(), sent_kpa_.end(), [](const Pressures& sent) {
           return sent.cwiseAbs().maxCoeff() <= kSetpointRoundingKpa;
         });
}

std::string not_zero_message(double pressure_kpa, const SafetySettings& safety) {
  constexpr double kAmbientLowKpa = 80.0;    // what an absolute sensor reads of a vented arm …
  constexpr double kAmbientHighKpa = 110.0;  // … from high mountains to the sea
  const bool ambient = pressure_kpa > kAmbientLowKpa && pressure_kpa < kAmbientHighKpa;
  return fmt::format("the vented arm reads {:.1f} kPa; expected at most {} kPa. {}", pressure_kpa,
                     safety.vented_kpa,
                     ambient
                         ? "Pressures on the wire are gauge, not absolute: "
                           "the driver has to subtract the ambient pressure"
                         : "Check supply, valves, the sensors' zero and the driver's unit (kPa)");
}

}  // namespace limber
