#pragma once

#include <string>
#include <vector>

#include "chart_area.hpp"
#include "limber/plot/svg_drawing.hpp"

namespace limber {

/// Figures that describe how values spread (common/statistics.hpp).
struct Spread {
  double mean = 0.0;
  double p05 = 0.0, p25 = 0.0, median = 0.0, p75 = 0.0, p95 = 0.0;
};

/// @param values  finite, at least one.
Spread spread_of(const std::vector<double>& values);

/// Density at even steps from the lowest to the highest value, the largest being 1: a Gaussian
/// kernel, bandwidth by Silverman's rule (1986, 3.31). One step of density 1 if all are equal.
struct DensityOutline {
  std::vector<double> at;
  std::vector<double> density;  ///< in [0, 1]
};
DensityOutline density_outline(const std::vector<double>& values, int steps);

/// A point in pixels.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// Thins a line without changing its picture: of successive points that share a pixel column it
/// keeps the first, the lowest, the highest and the last, in their order.
std::vector<Pixel> decimate(const std::vector<Pixel>& points);

/// "M… L…" through the points; a lone point becomes a dot's worth of line.
std::string pixel_path(const std::vector<Pixel>& points);

/// Draws series into an area, in the area's pixels.
class SeriesDrawer {
 public:
  /// All three must outlive the drawer.
  SeriesDrawer(const ChartArea& area, const ChartMeasure& measure,
               const std::vector<Series>& series);

  std::string operator()(const LineSeries& series);
  std::string operator()(const PointSeries& series);
  std::string operator()(const BandSeries& series);
  std::string operator()(const BarSeries& series);
  std::string operator()(const HistogramSeries& series);
  std::string operator()(const DistributionSeries& series);
  std::string operator()(const ReferenceLine& series);

 private:
  const ChartArea& area_;
  const ChartMeasure& measure_;
  int bar_series_ = 0;       ///< in the chart
  int next_bar_series_ = 0;  ///< the one to be drawn next
  int next_distribution_ = 0;
};

/// The key's entry for a series, with an empty label if it needs none.
LegendEntry legend_entry(const Series& series);

}  // namespace limber
