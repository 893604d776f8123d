#include "limber/plot/chart.hpp"

#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "chart_renderer.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace {

void check_sizes(const std::string& chart, const std::string& label, std::string_view first_name,
                 std::size_t first, std::string_view second_name, std::size_t second) {
  if (first != second) {
    throw InputError(fmt::format("chart '{}': series '{}' has {} {} and {} {}; expected as many",
                                 chart, label, first, first_name, second, second_name));
  }
}

std::pair<double, double> checked_range(const std::string& chart, char axis, double low,
                                        double high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low >= high) {
    throw InputError(fmt::format("chart '{}': {} range {} … {}; expected finite limits, low < high",
                                 chart, axis, low, high));
  }
  return {low, high};
}

}  // namespace

Chart::Chart(std::string title) {
  settings_.title = std::move(title);
}

Chart& Chart::x_axis(std::string label) {
  settings_.x.label = std::move(label);
  return *this;
}

Chart& Chart::y_axis(std::string label) {
  settings_.y.label = std::move(label);
  return *this;
}

Chart& Chart::x_range(double low, double high) {
  settings_.x.range = checked_range(settings_.title, 'x', low, high);
  return *this;
}

Chart& Chart::y_range(double low, double high) {
  settings_.y.range = checked_range(settings_.title, 'y', low, high);
  return *this;
}

Chart& Chart::logarithmic_y() {
  settings_.y.logarithmic = true;
  return *this;
}

Chart& Chart::equal_aspect() {
  settings_.equal_aspect = true;
  return *this;
}

Chart& Chart::size_px(int width_px, int height_px) {
  if (width_px < 200 || height_px < 150) {
    throw InputError(fmt::format("chart '{}': {} × {} px; expected at least 200 × 150",
                                 settings_.title, width_px, height_px));
  }
  settings_.width_px = width_px;
  settings_.height_px = height_px;
  return *this;
}

Chart& Chart::without_legend() {
  settings_.legend = false;
  return *this;
}

Chart& Chart::bins(int count) {
  if (count < 1) {
    throw InputError(
        fmt::format("chart '{}': {} bins; expected at least 1", settings_.title, count));
  }
  settings_.bins = count;
  return *this;
}

Chart& Chart::note(std::string text) {
  settings_.note = std::move(text);
  return *this;
}

template <typename SeriesType>
Chart& Chart::add(SeriesType series) {
  if (series.style.color.empty()) {
    series.style.color = palette_color(next_color_++);
  }
  series_.emplace_back(std::move(series));
  return *this;
}

Chart& Chart::line(std::string label, std::vector<double> x, std::vector<double> y,
                   SeriesStyle style) {
  check_sizes(settings_.title, label, "x", x.size(), "y", y.size());
  return add(LineSeries{std::move(label), std::move(x), std::move(y), std::move(style)});
}

Chart& Chart::points(std::string label, std::vector<double> x, std::vector<double> y,
                     SeriesStyle style) {
  check_sizes(settings_.title, label, "x", x.size(), "y", y.size());
  return add(PointSeries{std::move(label), std::move(x), std::move(y), std::move(style)});
}

Chart& Chart::band(std::string label, std::vector<double> x, std::vector<double> low,
                   std::vector<double> high, SeriesStyle style) {
  check_sizes(settings_.title, label, "x", x.size(), "low values", low.size());
  check_sizes(settings_.title, label, "x", x.size(), "high values", high.size());
  return add(BandSeries{std::move(label), std::move(x), std::move(low), std::move(high),
                        std::move(style)});
}

Chart& Chart::mean_band(std::string label, std::vector<double> x, const std::vector<double>& mean,
                        const std::vector<double>& deviation, SeriesStyle style) {
  check_sizes(settings_.title, label, "x", x.size(), "means", mean.size());
  check_sizes(settings_.title, label, "x", x.size(), "deviations", deviation.size());
  if (style.color.empty()) {
    style.color = palette_color(next_color_++);
  }
  std::vector<double> low = mean;
  std::vector<double> high = mean;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    low[i] -= deviation[i];
    high[i] += deviation[i];
  }
  band("", x, std::move(low), std::move(high), style);
  return line(std::move(label), std::move(x), mean, std::move(style));
}

Chart& Chart::bars(std::vector<std::string> categories, std::string label,
                   std::vector<double> values, std::vector<double> errors, SeriesStyle style) {
  check_sizes(settings_.title, label, "categories", categories.size(), "values", values.size());
  if (!errors.empty()) {
    check_sizes(settings_.title, label, "values", values.size(), "errors", errors.size());
  }
  if (!settings_.categories.empty() && settings_.categories != categories) {
    throw InputError(
        fmt::format("chart '{}': bars '{}' name other categories than the series before; all bars "
                    "of a chart share theirs",
                    settings_.title, label));
  }
  settings_.categories = std::move(categories);
  return add(BarSeries{std::move(label), std::move(values), std::move(errors), std::move(style)});
}

Chart& Chart::histogram(std::string label, std::vector<double> values, SeriesStyle style) {
  return add(HistogramSeries{std::move(label), std::move(values), std::move(style)});
}

Chart& Chart::distribution(std::string label, std::vector<double> values, SeriesStyle style) {
  for (const Series& series : series_) {
    if (std::holds_alternative<BarSeries>(series)) {
      throw InputError(
          fmt::format("chart '{}': distribution '{}' in a chart of bars; use a chart of its own",
                      settings_.title, label));
    }
  }
  settings_.categories.push_back(label);
  return add(DistributionSeries{std::move(label), std::move(values), std::move(style)});
}

Chart& Chart::horizontal_line(std::string label, double y, SeriesStyle style) {
  return add(ReferenceLine{std::move(label), y, true, std::move(style)});
}

Chart& Chart::vertical_line(std::string label, double x, SeriesStyle style) {
  return add(ReferenceLine{std::move(label), x, false, std::move(style)});
}

std::string Chart::svg() const {
  return render_chart(settings_, series_);
}

int Chart::undrawable_values() const {
  return measure_chart(settings_, series_).undrawable;
}

ChartGrid::ChartGrid(int columns, std::string title) : columns_(columns), title_(std::move(title)) {
  if (columns < 1) {
    throw InputError(fmt::format("chart grid: {} columns; expected at least 1", columns));
  }
}

ChartGrid& ChartGrid::add(Chart chart) {
  charts_.push_back(std::move(chart));
  return *this;
}

std::string ChartGrid::svg() const {
  return render_grid(charts_, columns_, title_);
}

}  // namespace limber
