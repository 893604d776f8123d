#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/logs/import_report.hpp"

namespace limber {

nlohmann::ordered_json to_json(const SpaceRunReport& report);

/// Lines of a log's report, each after a line break.
std::string to_text(const SpaceRunReport& report);

}  // namespace limber
