#include "clock_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace limber {

void fit_driver_clock(const CalibrationLog& log, double frame_period_s, ClockCalibration& clocks) {
  if (!log.real_time || log.frames.empty()) {
    return;
  }
  double mean_t = 0.0;
  double mean_offset = 0.0;
  const auto count = static_cast<double>(log.frames.size());
  const auto middle = [](const CalibrationFrame& f) {
    return 0.5 * (f.sent_s + f.received_s) - f.state.time_s;
  };
  for (const CalibrationFrame& frame : log.frames) {
    mean_t += frame.state.time_s / count;
    mean_offset += middle(frame) / count;
  }
  double product = 0.0;
  double square = 0.0;
  for (const CalibrationFrame& frame : log.frames) {
    const double t = frame.state.time_s - mean_t;
    product += t * (middle(frame) - mean_offset);
    square += t * t;
  }
  clocks.driver_drift = square > 0.0 ? product / square : 0.0;
  double low_s = -std::numeric_limits<double>::infinity();
  double high_s = std::numeric_limits<double>::infinity();
  for (const CalibrationFrame& frame : log.frames) {
    const double drifted_s = clocks.driver_drift * (frame.state.time_s - mean_t);
    low_s = std::max(low_s, frame.sent_s - frame.state.time_s - drifted_s);
    high_s = std::min(high_s, frame.received_s - frame.state.time_s - drifted_s);
  }
  if (low_s > high_s) {  // samples are older than requests: how much is not known
    low_s = high_s - frame_period_s;
  }
  clocks.driver = TimeInterval{0.5 * (low_s + high_s), low_s, high_s};
}

}  // namespace limber
