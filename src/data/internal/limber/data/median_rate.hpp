#pragma once

#include <vector>

namespace limber {

/// Rows per second, by the median step. @pre at least 2 rows, in order.
double median_rate_hz(const std::vector<double>& time_s);

}  // namespace limber
