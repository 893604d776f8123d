#pragma once

#include <string>
#include <vector>

#include "limber/plot/chart.hpp"

namespace limber {

/// Marks of an axis: rising values and the text beside each.
struct AxisTicks {
  std::vector<double> values;
  std::vector<std::string> labels;
};

/// A range widened so that both ends are nice: low ≤ data ≤ high.
struct NiceRange {
  double low = 0.0;
  double high = 1.0;
};

/// Distance between ticks, 1, 2 or 5 times a power of ten, such that about `count` (≥ 1) of them
/// fit `low` … `high` (finite, low < high).
double nice_step(double low, double high, int count);

/// `low` and `high` moved outwards to multiples of nice_step. Where they are equal, a range around
/// the value; the order does not matter. Finite values only.
NiceRange nice_range(double low, double high, int count = 5);

/// All multiples of nice_step within the range (finite, low < high).
AxisTicks linear_ticks(double low, double high, int count = 5);

/// Positive `low` and `high` moved outwards to 1, 2 or 5 times a power of ten.
NiceRange nice_logarithmic_range(double low, double high);

/// Powers of ten within the range and, where there are fewer than three of them, their multiples
/// by 2 and 5 (0 < low < high, finite).
AxisTicks logarithmic_ticks(double low, double high);

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
