#pragma once

#include <vector>

#include "axis_ticks.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// Lowest and highest of the values seen.
class Extent {
 public:
  void include(double value);
  bool empty() const { return low_ > high_; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_ = 1.0;
  double high_ = 0.0;
};

/// What a chart needs to know about its data: ranges of the axes, the shared bins of its
/// histograms, and how many values can't be drawn.
struct ChartMeasure {
  NiceRange x, y;
  std::vector<double> bin_edges;  ///< empty without histograms
  int undrawable = 0;
  bool has_data = false;
};

ChartMeasure measure_chart(const ChartSettings& settings, const std::vector<Series>& series);

/// Finite, far from overflow, and positive where the axis is logarithmic.
bool is_drawable(double value, bool logarithmic = false);

/// How many of `values` fall into each bin; edges rise, the last bin includes its upper edge.
std::vector<int> bin_counts(const std::vector<double>& values, const std::vector<double>& edges);

}  // namespace limber
