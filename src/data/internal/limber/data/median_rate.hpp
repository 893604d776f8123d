#pragma once

#include <vector>

namespace limber {

/// From row to row, as quantile() has it. @pre at least 2 rows, in order.
double quantile_step_s(const std::vector<double>& time_s, double share);
/// Rows per second, by the median step. @pre as above
double median_rate_hz(const std::vector<double>& time_s);

}  // namespace limber
