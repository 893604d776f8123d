#include "limber/driver/vented_rest.hpp"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/run/rest_average.hpp"

namespace limber {

namespace {

constexpr double kLongestS = 10.0;
constexpr double kLongestBlindS = 1.0;

}  // namespace

ArmStart vented_rest(const ArmDescription& arm, const std::function<const ArmState&()>& look) {
  RestAverage rest(arm.frames_in(RestAverage::kRestS));
  std::optional<double> moved_m;
  int seen = 0;
  for (int frame = 0; frame <= arm.frames_in(kLongestS); ++frame) {
    throw_if_interrupted();
    const std::optional<Backbone>& backbone = look().backbone;
    if (!backbone || !backbone->allFinite()) {
      if (seen == 0 && frame >= arm.frames_in(kLongestBlindS)) {
        throw SystemFault(
            "the driver's state has no backbone: nothing tracks the arm, so where it lies is not "
            "known");
      }
      continue;  // what was seen before the gap counts: an arm that is vented is not moved
    }
    ++seen;
    rest.observe(backbone);
    if (const std::optional<Backbone> mean = rest.backbone()) {
      return {Pressures::Zero(arm.channel_count()), *mean};
    }
    moved_m = rest.moved_m();
  }
  if (!moved_m) {
    throw SystemFault(fmt::format("the vented arm was lost: it was tracked in {} frames of {:g} s",
                                  seen, kLongestS));
  }
  throw SystemFault(fmt::format(
      "the vented arm does not lie still: after {:g} s it was still {:.1f} mm from its mean of "
      "{:g} s, where {:.1f} mm are allowed. Is it being touched, or its tracking noisy?",
      kLongestS, 1e3 * *moved_m, RestAverage::kRestS, 1e3 * RestAverage::kStillM));
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
