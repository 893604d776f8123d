#include "limber/sim/virtual_arm.hpp"

#include <fmt/format.h>

#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

DriverFactory virtual_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options) {
  return [arm, options](int index) {
    VirtualArmOptions own = options;
    own.stream = std::uint64_t(index);
    return std::make_unique<VirtualArm>(arm, own);
  };
}

std::string describe(const ArmDescription& arm, const VirtualArmOptions& options) {
  constexpr std::size_t kShortHash = 8;
  std::string text = "physics " + virtual_arm_hash(arm).substr(0, kShortHash);
  const auto add = [&](const char* what, double value, const char* unit) {
    if (value != 0.0) {
      text += fmt::format(", {} {}{}", what, value, unit);
    }
  };
  add("noise", options.noise_m, " m");
  add("noise", options.noise_rad, " rad");
  add("noise", options.noise_kpa, " kPa");
  add("drop rate", options.drop_rate, "");
  add("latency", options.latency_s, " s");
  if (options.lost_for_s > 0.0) {
    text += fmt::format(", lost from {} s for {} s", options.lost_from_s, options.lost_for_s);
  }
  if (options.later) {
    text += fmt::format(", from {} s physics {}", options.later_from_s,
                        virtual_arm_hash(*options.later).substr(0, kShortHash));
  }
  return text;
}

CollectionSettings virtual_collection(const ArmDescription& arm, const ScheduleSettings& schedule,
                                      const VirtualArmOptions& options) {
  CollectionSettings settings;
  settings.schedule = schedule;
  settings.source = "virtual arm";
  settings.driver = describe(arm, options);
  settings.seed = options.seed;
  return settings;
}

}  // namespace limber
