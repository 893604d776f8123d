#include "limber/world/hold.hpp"

#include <algorithm>

#include "limber/world/pressure_box.hpp"

namespace limber {

namespace {

// Of the largest command.
constexpr float kSettledShare = 0.01F;      // pressures this near have arrived
constexpr float kDeadBandRounding = 1e-5F;  // valves stop at the band's edge

}  // namespace

int hold_frame_count(const ArmDescription& arm, const ValveModel& valves,
                     const Eigen::Ref<const Eigen::VectorXf>& state) {
  const int min_frames = arm.frames_in(kHoldS);
  if (valves.is_ideal()) {
    return min_frames;
  }
  const Pressures limits_kpa = pressure_limits_kpa(arm);
  Pressures tolerance_kpa = kSettledShare * limits_kpa;
  for (Eigen::Index i = 0; i < tolerance_kpa.size(); ++i) {
    const SegmentValves& segment = valves.parameters().segments[i];
    tolerance_kpa[i] = std::max(tolerance_kpa[i],
                                float(segment.dead_band_kpa) + kDeadBandRounding * limits_kpa[i]);
  }
  return std::max(min_frames,
                  valves.frames_to_settle(state, tolerance_kpa, arm.frames_in(kLongestHoldS)));
}

}  // namespace limber
