#include "limber/run/safety_settings.hpp"

#include <utility>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {

namespace {

Fence read_fence(const YamlReader& node) {
  node.refuse_unknown_keys({"x_min_m", "x_max_m", "y_min_m", "y_max_m", "z_min_m", "z_max_m"});
  const auto length = [&](const char* key) {
    constexpr double kMaxM = 100.0;
    return node.at(key).number("a length in metres", -kMaxM, kMaxM);
  };
  Fence fence{length("x_min_m"), length("x_max_m"), length("y_min_m"), length("y_max_m")};
  for (const auto& [key, value] :
       {std::pair{"z_min_m", &fence.z_min_m}, {"z_max_m", &fence.z_max_m}}) {
    if (node.has(key)) {
      *value = length(key);
    }
  }
  node.refuse_if(!(fence.x_min_m < fence.x_max_m && fence.y_min_m < fence.y_max_m &&
                   fence.z_min_m < fence.z_max_m),
                 "expected x_min_m < x_max_m, y_min_m < y_max_m and z_min_m < z_max_m");
  return fence;
}

}  // namespace

SafetySettings load_safety(const fs::path& arm_file) {
  const YamlReader root = YamlReader::from_file(arm_file);
  SafetySettings safety;
  if (!root.has("safety")) {
    return safety;
  }
  const YamlReader node = root.at("safety");
  node.refuse_unknown_keys({"over_limit_percent", "following_error_kpa", "following_time_s",
                            "stuck_change_kpa", "jump_m", "rise_kpa", "vented_kpa", "vent_time_s",
                            "fence"});
  const auto take = [&](const char* key, const char* unit, double max, double& value) {
    if (node.has(key)) {
      constexpr double kMin = 1e-3;  // of every unit here: less is below what is measured
      value = node.at(key).number(unit, kMin, max);
    }
  };
  take("over_limit_percent", "per cent", 50.0, safety.over_limit_percent);
  take("following_error_kpa", "a pressure in kPa", 1e4, safety.following_error_kpa);
  take("following_time_s", "seconds", 60.0, safety.following_time_s);
  take("stuck_change_kpa", "a pressure in kPa", 1e4, safety.stuck_change_kpa);
  if (node.has("jump_m")) {
    take("jump_m", "a length in metres", 10.0, safety.jump_m.emplace());
  }
  take("rise_kpa", "a pressure in kPa", 1e4, safety.rise_kpa);
  take("vented_kpa", "a pressure in kPa", 50.0, safety.vented_kpa);
  take("vent_time_s", "seconds", 60.0, safety.vent_time_s);
  if (node.has("fence")) {
    safety.fence = read_fence(node.at("fence"));
  }
  return safety;
}

double largest_jump_m(const SafetySettings& safety, const ArmDescription& arm) {
  constexpr double kLengthsPerS = 4.0;
  return safety.jump_m.value_or(kLengthsPerS * arm.length_m() * arm.frame_period_s());
}

ArmDescription with_scaled_limits(const ArmDescription& arm, double scale) {
  refuse_if(!(scale > 0.0 && scale <= 1.0), "limit scale = {}; expected a number over 0, at most 1",
            scale);
  ArmDescription scaled = arm;
  for (Segment& segment : scaled.segments) {
    segment.pressure_limit_kpa *= scale;
    for (Chamber& chamber : segment.chambers) {
      chamber.limit_kpa *= scale;
    }
  }
  return scaled;
}

std::vector<PressureLimits> limits_in_force(const ArmDescription& arm, double scale,
                                            const std::vector<PressureLimits>& drivers_own) {
  std::vector<PressureLimits> limits = limits_of(with_scaled_limits(arm, scale));
  for (std::size_t s = 0; s < drivers_own.size(); ++s) {
    limits[s] = limits[s].within(drivers_own[s]);
  }
  return limits;
}

}  // namespace limber
