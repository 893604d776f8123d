#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"

namespace limber {

class YamlReader;

/// Reads a number > 0, the limit of both sides, or [lower, upper]. @param meaning  "a gauge
/// pressure in kPa", for messages. @throws InputError naming file, line and field.
PressureLimits read_limits(const YamlReader& node, const std::string& meaning);

/// As arm files have it: "14", or "[-11, 13.8]".
std::string limits_to_yaml(const PressureLimits& limits);

/// The limits as JSON: a number where both sides have the same, else [lower, upper].
Json to_json(const PressureLimits& limits);

/// States of a segment that collections visit: off, and full to either side.
inline constexpr int kCornerStates = 3;

/// The set point of a state: 0 off, 1 full to the positive side, 2 to the negative one. A segment
/// that has one side only takes half of it in place of the missing one.
double corner_kpa(const PressureLimits& limits, int state);

/// Of the limits' range: by so much a measured pressure may lie beyond either, since valves
/// overshoot.
inline constexpr double kOvershootOfRange = 0.05;
/// What may be measured where set points keep `limits`.
PressureLimits measured_limits(const PressureLimits& limits);

/// Of every channel, base first.
std::vector<PressureLimits> limits_of(const ArmDescription& arm);

/// The arm, in the plane, within narrower limits; none: the arm.
ArmDescription with_limits(ArmDescription arm, const std::vector<PressureLimits>& limits);

}  // namespace limber
