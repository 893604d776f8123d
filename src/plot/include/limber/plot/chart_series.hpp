#pragma once
// For those who show results.

#include <string>
#include <variant>
#include <vector>

namespace limber {

/// How one series looks. Lengths are pixels of the picture.
struct SeriesStyle {
  std::string color{};    ///< any CSS colour; empty: the next one of the palette
  double width_px = 2.0;  ///< of lines and outlines
  double radius_px = 3.0;
  double opacity = 1.0;  ///< in [0, 1]
  bool dashed = false;
};

/// Points joined in their order; the line breaks where a coordinate is not finite.
struct LineSeries {
  std::string label;
  std::vector<double> x, y;  ///< same size
  SeriesStyle style;
};

/// Unjoined points.
struct PointSeries {
  std::string label;
  std::vector<double> x, y;  ///< same size
  SeriesStyle style;
};

/// The area between two curves over x.
struct BandSeries {
  std::string label;
  std::vector<double> x, low, high;  ///< same size
  SeriesStyle style;
};

/// One bar in each of the chart's categories; several series stand side by side in a category.
struct BarSeries {
  std::string label;
  std::vector<double> values;  ///< one per category
  std::vector<double> errors;  ///< half lengths of the error bars: one per category, or none
  SeriesStyle style;
};

/// Counts of values in bins; all histograms of a chart share their bins' edges.
struct HistogramSeries {
  std::string label;
  std::vector<double> values;
  SeriesStyle style;
};

/// One category that shows how values spread: density outline, quartile box, median and mean, and
/// whiskers at the 5th and 95th percentile.
struct DistributionSeries {
  std::string label;
  std::vector<double> values;
  SeriesStyle style;
};

/// A straight line across the whole chart, such as a limit or a published figure.
struct ReferenceLine {
  std::string label;
  double at = 0.0;
  bool horizontal = true;
  SeriesStyle style;
};

using Series = std::variant<LineSeries, PointSeries, BandSeries, BarSeries, HistogramSeries,
                            DistributionSeries, ReferenceLine>;

}  // namespace limber
