#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "chart_measure.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// A whole chart as one <svg> element.
std::string render_chart(const ChartSettings& settings, const std::vector<Series>& series);

/// Charts row by row as one <svg> element.
std::string render_grid(const std::vector<Chart>& charts, int columns, std::string_view title);

}  // namespace limber
