#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/json.hpp"
#include "limber/forward/speed_report.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// Keys of `limber bench --json`, docs/formats.md.
Json to_json(const SpeedReport& report);
/// A table for people.
std::string to_text(const SpeedReport& report);
/// Bars, logarithmic, the paper's figures among them.
Chart speed_chart(const SpeedReport& report);

}  // namespace limber
