#include "limber/world/hold.hpp"

#include <algorithm>

#include "limber/world/pressure_box.hpp"

namespace limber {

namespace {

constexpr float kSettledShare = 0.01F;         // of the limit: pressures this near have arrived
constexpr float kDeadBandRoundingKpa = 1e-3F;  // valves stop at the band's edge

}  // namespace

int hold_frame_count(const ArmDescription& arm, const ValveModel& valves,
                     const Eigen::Ref<const Eigen::VectorXf>& state) {
  const int min_frames = arm.frames_in(kHoldS);
  if (valves.is_ideal()) {
    return min_frames;
  }
  Pressures tolerance_kpa = kSettledShare * pressure_limits_kpa(arm);
  for (Eigen::Index i = 0; i < tolerance_kpa.size(); ++i) {
    const SegmentValves& segment = valves.parameters().segments[static_cast<std::size_t>(i)];
    tolerance_kpa[i] = std::max(tolerance_kpa[i],
                                static_cast<float>(segment.dead_band_kpa) + kDeadBandRoundingKpa);
  }
  return std::max(min_frames,
                  valves.frames_to_settle(state, tolerance_kpa, arm.frames_in(kLongestHoldS)));
}

}  // namespace limber
