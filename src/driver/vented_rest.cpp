#include "limber/driver/vented_rest.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <thread>

#include <fmt/format.h>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kWindowS = 0.25;
constexpr double kStillM = 0.003;
constexpr double kLongestS = 10.0;
constexpr double kLongestBlindS = 1.0;

/// How far any plate has moved since any of the shapes: a swing ends where it began.
double largest_motion_m(const std::deque<Backbone>& shapes) {
  double largest_m = 0.0;
  for (const Backbone& before : shapes) {
    largest_m = std::max(largest_m, largest_plate_distance_m(shapes.back(), before));
  }
  return largest_m;
}

}  // namespace

ArmStart vented_rest(const ArmDescription& arm, const std::function<const ArmState&()>& look) {
  const auto window = static_cast<std::size_t>(arm.frames_in(kWindowS));
  std::deque<Backbone> seen;  // the newest last
  double moved_m = 0.0;
  for (int frame = 0; frame <= arm.frames_in(kLongestS); ++frame) {
    throw_if_interrupted();
    const std::optional<Backbone>& backbone = look().backbone;
    if (!backbone || !backbone->allFinite()) {
      if (seen.empty() && frame >= arm.frames_in(kLongestBlindS)) {
        throw SystemFault(
            "the driver's state has no backbone: nothing tracks the arm, so where it lies is not "
            "known");
      }
      continue;
    }
    seen.push_back(*backbone);
    if (seen.size() <= window) {
      continue;
    }
    moved_m = largest_motion_m(seen);
    if (moved_m <= kStillM) {
      return {Pressures::Zero(arm.segment_count()), seen.back()};
    }
    seen.pop_front();
  }
  if (seen.size() < window) {
    throw SystemFault(fmt::format("the vented arm was lost: it was tracked in {} frames of {:g} s",
                                  seen.size(), kLongestS));
  }
  throw SystemFault(
      fmt::format("the vented arm does not lie still: after {:g} s it still moved by {:.1f} cm in "
                  "{:g} s, and {:.1f} cm are allowed. Is it being touched, or its tracking noisy?",
                  kLongestS, kCmPerM * moved_m, kWindowS, kCmPerM * kStillM));
}

ArmStart vented_rest(const ArmDescription& arm, ProcessDriver& driver) {
  const std::chrono::duration<double> frame(driver.is_real_time() ? arm.frame_period_s() : 0.0);
  bool is_first = true;
  return vented_rest(arm, [&]() -> const ArmState& {
    if (!is_first) {
      std::this_thread::sleep_for(frame);
    }
    is_first = false;
    const ArmState& state = driver.look();
    if (!driver.last_vent().confirmed) {
      throw SystemFault(driver.last_vent().message);
    }
    return state;
  });
}

}  // namespace limber
