#pragma once

#include <string>
#include <vector>

#include "chart_area.hpp"
#include "limber/plot/shape_style.hpp"

namespace limber {

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
