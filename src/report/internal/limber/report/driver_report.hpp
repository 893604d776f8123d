#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/valve_parameters.hpp"
#include "limber/common/json.hpp"
#include "limber/driver/driver_check.hpp"

namespace limber {

inline constexpr double kMsPerS = 1e3;

/// {"count": …, "p50": …, "p99": …, "p999": …, "max": …} of times in seconds, in ms; null where
/// there are none.
Json times_in_ms(const std::vector<double>& seconds);

/// The object of `limber driver check --json`.
Json to_json(const DriverCheck& check, const IdentifiedValves& valves);

/// The same in a few lines for people.
std::string to_text(const DriverCheck& check);

/// A page with plots of the set points and of what was measured.
std::string driver_check_to_html(const DriverCheck& check, const ArmDescription& arm,
                                 const IdentifiedValves& valves);

}  // namespace limber
