#pragma once

#include <string>
#include <vector>

#include "chart_measure.hpp"
#include "limber/plot/chart.hpp"

namespace limber {

/// The rectangle that a chart's data are drawn in, and the map from data to its pixels: (0, 0) is
/// its upper left corner.
class ChartArea {
 public:
  ChartArea(const ChartSettings& settings, const ChartMeasure& measure);

  double width_px() const { return width_px_; }
  double height_px() const { return height_px_; }
  double pixel_x(double x) const;
  double pixel_y(double y) const;
  /// Pixel of the value that bars and densities stand on: 0, or the lower end of the axis.
  double floor_px() const;
  bool logarithmic() const { return logarithmic_; }

  /// Space that title, labels and ticks need around the area.
  double left_px() const { return left_px_; }
  double top_px() const { return top_px_; }
  double below_px() const { return below_px_; }

  /// Attributes that say which data the edges stand for, where x counts numbers: reports can be
  /// hovered and zoomed by them (web/src/report.ts).
  std::string edges() const;
  std::string grid() const;
  /// Frame, ticks and axes' labels, drawn over the data.
  std::string frame() const;

 private:
  void widen_to_equal_aspect();
  std::string x_ticks() const;

  const ChartSettings& settings_;
  NiceRange x_, y_;
  AxisTicks x_ticks_, y_ticks_;
  bool logarithmic_;
  bool slanted_ = false;  ///< categories' names are, where they would overlap
  double left_px_ = 0.0, top_px_ = 0.0, below_px_ = 0.0;
  double width_px_ = 0.0, height_px_ = 0.0;
};

}  // namespace limber
