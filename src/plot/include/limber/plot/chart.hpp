#pragma once
// For those who show results.

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "limber/plot/svg_drawing.hpp"

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

/// One axis of a chart.
struct AxisSettings {
  std::string label;                               ///< quantity and unit: "time [s]"
  std::optional<std::pair<double, double>> range;  ///< unset: the data's, widened to nice numbers
  bool logarithmic = false;
};

/// Everything about a chart but its series.
struct ChartSettings {
  std::string title;
  AxisSettings x, y;
  std::vector<std::string> categories;  ///< of the x axis; empty: the x axis counts numbers
  bool equal_aspect = false;
  bool legend = true;
  int width_px = 560;
  int height_px = 380;
  std::string note;  ///< a small line under the chart
};

/// A chart as a value: fill it, then ask for its SVG. Made to be read on a phone, printed, and told
/// apart by colour-blind readers (palette of Okabe and Ito, 2008); its white background also serves
/// pages in dark mode.
///
/// Values that can't be drawn (not finite, or not positive on a logarithmic axis) are left out.
/// Lines break there, and the chart says underneath how many there were. Lines with more points
/// than pixels keep the first, lowest, highest and last point of each pixel column.
///
///   Chart chart("Error over time");
///   chart.x_axis("time [s]").y_axis("position error [cm]");
///   chart.line("no-load", time_s, no_load_cm).line("network", time_s, network_cm);
///   write_file_atomically("error.svg", chart.svg());
///
/// Series functions throw InputError if vectors that belong together differ in size.
class Chart {
 public:
  explicit Chart(std::string title);

  Chart& x_axis(std::string label);
  Chart& y_axis(std::string label);
  /// Fixed limits, low < high and both finite, else InputError.
  Chart& x_range(double low, double high);
  Chart& y_range(double low, double high);
  Chart& logarithmic_y();
  /// Makes a unit of x as long as a unit of y; the ranges grow to fill the area.
  Chart& equal_aspect();
  Chart& size_px(int width_px, int height_px);
  Chart& without_legend();
  Chart& note(std::string text);

  Chart& line(std::string label, std::vector<double> x, std::vector<double> y,
              SeriesStyle style = {});
  Chart& points(std::string label, std::vector<double> x, std::vector<double> y,
                SeriesStyle style = {});
  Chart& band(std::string label, std::vector<double> x, std::vector<double> low,
              std::vector<double> high, SeriesStyle style = {});
  /// A line and the band one `deviation` to either side of it, in one colour.
  Chart& mean_band(std::string label, std::vector<double> x, const std::vector<double>& mean,
                   const std::vector<double>& deviation, SeriesStyle style = {});
  /// One group of bars for all series: every call must name the same categories.
  Chart& bars(std::vector<std::string> categories, std::string label, std::vector<double> values,
              std::vector<double> errors = {}, SeriesStyle style = {});
  Chart& histogram(std::string label, std::vector<double> values, SeriesStyle style = {});
  /// A category of its own, named `label`. Not in one chart with bars.
  Chart& distribution(std::string label, std::vector<double> values, SeriesStyle style = {});
  Chart& horizontal_line(std::string label, double y, SeriesStyle style = {});
  Chart& vertical_line(std::string label, double x, SeriesStyle style = {});

  /// The whole picture: well-formed XML, one `svg` element, nothing external.
  std::string svg() const;

  const ChartSettings& settings() const { return settings_; }
  const std::vector<Series>& series() const { return series_; }

 private:
  /// Gives the series the next colour of the palette if it has none, and stores it.
  template <typename SeriesType>
  Chart& add(SeriesType series);

  ChartSettings settings_;
  std::vector<Series> series_;
  int next_color_ = 0;
};

/// Several charts in one picture, row by row, `columns` (at least 1) in a row.
class ChartGrid {
 public:
  explicit ChartGrid(int columns, std::string title = "");
  ChartGrid& add(Chart chart);
  std::string svg() const;

 private:
  int columns_;
  std::string title_;
  std::vector<Chart> charts_;
};

}  // namespace limber
