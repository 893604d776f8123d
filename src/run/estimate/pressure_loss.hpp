#pragma once

#include <cstddef>
#include <vector>

#include "limber/arm/valve_model.hpp"
#include "limber/run/arm_estimate.hpp"

namespace limber {

/// Which segments lose pressure: measured pressures fall short of what the valves would make of
/// the set points by the same share, frame after frame. A hose that leaks behind a controller
/// without integral looks like that.
///
/// Ideal valves know no pressures beside the set points: nothing is found out there.
class PressureLossWatch {
 public:
  PressureLossWatch(const ValveModel& valves, double frame_period_s);

  /// Takes in a frame. @param expected_kpa  pressures of that frame by the set points alone
  void observe(const Pressures& expected_kpa, const Pressures& measured_kpa);

  /// In the order in which they were noticed; shares are the latest.
  const std::vector<PressureLoss>& found() const { return found_; }

 private:
  /// Faded sums over frames of one segment, and frames in a row in which it was short.
  struct Segment {
    double frames = 0.0;
    double expected2 = 0.0;
    double expected_measured = 0.0;
    double measured2 = 0.0;
    int short_for = 0;
    bool is_noticed = false;
  };

  double dead_band_kpa(std::size_t segment) const;

  const ValveModel& valves_;
  double frame_period_s_;
  std::vector<Segment> segments_;
  std::vector<PressureLoss> found_;
  int frames_ = 0;
};

}  // namespace limber
