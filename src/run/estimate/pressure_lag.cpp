#include "pressure_lag.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr double kLagMemory = 0.98;  // per frame: what is older counts less
constexpr double kClearlyLess =
    0.5;                             // of what the lag so far misses, so that noise changes nothing
constexpr double kHiddenKpa2 = 4.0;  // less than that per segment may be noise, or the valve model

}  // namespace

int PressureLag::note(const Pressures& setpoint_kpa, const Pressures& measured_kpa) {
  if (valves_.is_ideal()) {
    return 0;
  }
  if (state_.size() == 0) {
    state_ = valves_.settled_state(setpoint_kpa);
    predicted_kpa_.assign(kMaxFrames + 1, setpoint_kpa);
  } else {
    valves_.step(setpoint_kpa, state_);
    predicted_kpa_.pop_back();
    predicted_kpa_.emplace_front(state_.head(setpoint_kpa.size()));
  }
  for (std::size_t lag = 0; lag < missed_.size(); ++lag) {
    missed_[lag] =
        kLagMemory * missed_[lag] + double((predicted_kpa_[lag] - measured_kpa).squaredNorm());
  }
  const auto best = std::min_element(missed_.begin(), missed_.end());
  const double now = missed_[frames_];
  if (*best < kClearlyLess * now && now - *best > kHiddenKpa2 * double(setpoint_kpa.size())) {
    frames_ = int(best - missed_.begin());
  }
  return frames_;
}

}  // namespace limber
