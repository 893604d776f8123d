#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "demo_stages.hpp"
#include "limber/common/json.hpp"
#include "limber/report/report_page.hpp"

namespace limber {

/// Arrivals over planning time, as a table and under "arrivals" in summary.json.
ReportTable arrivals_table(const std::vector<Arrivals>& rows);
Json arrivals_to_json(const std::vector<Arrivals>& rows);

}  // namespace limber
