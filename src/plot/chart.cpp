#include "limber/plot/chart.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "chart_area.hpp"
#include "chart_measure.hpp"
#include "chart_shapes.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/plot/svg_text.hpp"
#include "svg_elements.hpp"

namespace limber {

namespace {

struct Picture {
  std::string body;
  double width_px = 0.0;
  double height_px = 0.0;
};

std::string translated(double left_px, double top_px, const std::string& body) {
  return fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", svg_number(left_px),
                     svg_number(top_px), body);
}

/// Data, cut off at the area's edges by a nested <svg>: no id, which charts in one page would
/// share.
std::string data_of(const ChartArea& area, const ChartMeasure& measure,
                    const std::vector<Series>& series) {
  std::string out =
      fmt::format("<svg width=\"{}\" height=\"{}\" overflow=\"hidden\"{}>\n",
                  svg_number(area.width_px()), svg_number(area.height_px()), area.edges());
  out += area.grid();
  SeriesDrawer drawer(area, measure, series);
  for (const Series& each : series) {
    out += std::visit(drawer, each);
  }
  if (!measure.has_data) {
    out += svg::text(area.width_px() / 2.0, area.height_px() / 2.0, "no data",
                     {.color = "#767676", .anchor = TextAnchor::kMiddle});
  }
  return out + "</svg>\n";
}

Picture picture_of(const ChartSettings& settings, const std::vector<Series>& series) {
  const ChartMeasure measure = measure_chart(settings, series);
  const ChartArea area(settings, measure);
  Picture picture;
  picture.width_px = settings.width_px;
  if (!settings.title.empty()) {
    picture.body += svg::text(12.0, 24.0, settings.title, {.size_px = 17.0, .bold = true});
  }
  picture.body +=
      translated(area.left_px(), area.top_px(), data_of(area, measure, series) + area.frame());
  double bottom = area.top_px() + area.height_px() + area.below_px();

  std::vector<LegendEntry> entries;
  for (const Series& each : series) {
    LegendEntry entry = legend_entry(each);
    if (settings.legend && !entry.label.empty()) {
      entries.push_back(std::move(entry));
    }
  }
  const svg::Key key = svg::key(entries, 14.0, bottom + 10.0, picture.width_px - 28.0);
  picture.body += key.body;
  bottom += key.height_px;

  const auto small_text = [&](const std::string& text, const std::string& color) {
    bottom += 19.0;
    picture.body +=
        svg::text(14.0, bottom - 3.0, text, {.color = color, .size_px = svg::kSmallTextPx});
  };
  if (!settings.note.empty()) {
    small_text(settings.note, "#5a5a5a");
  }
  if (measure.undrawable > 0) {
    small_text(fmt::format("{} {} not drawn: not finite{}", measure.undrawable,
                           measure.undrawable == 1 ? "value" : "values",
                           settings.y.logarithmic ? " or not positive" : ""),
               "#b00020");
  }
  picture.height_px = bottom + 6.0;
  return picture;
}

void check_sizes(const std::string& chart, const std::string& label, std::string_view first_name,
                 std::size_t first, std::string_view second_name, std::size_t second) {
  refuse_if(first != second, "chart '{}': series '{}' has {} {} and {} {}; expected as many", chart,
            label, first, first_name, second, second_name);
}

std::pair<double, double> checked_range(const std::string& chart, char axis, double low,
                                        double high) {
  refuse_if(!std::isfinite(low) || !std::isfinite(high) || low >= high,
            "chart '{}': {} range {} … {}; expected finite limits, low < high", chart, axis, low,
            high);
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
  refuse_if(width_px < 200 || height_px < 150,
            "chart '{}': {} × {} px; expected at least 200 × 150", settings_.title, width_px,
            height_px);
  settings_.width_px = width_px;
  settings_.height_px = height_px;
  return *this;
}

Chart& Chart::without_legend() {
  settings_.legend = false;
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
  refuse_if(!settings_.categories.empty() && settings_.categories != categories,
            "chart '{}': bars '{}' name other categories than the series before; all bars "
            "of a chart share theirs",
            settings_.title, label);
  settings_.categories = std::move(categories);
  return add(BarSeries{std::move(label), std::move(values), std::move(errors), std::move(style)});
}

Chart& Chart::histogram(std::string label, std::vector<double> values, SeriesStyle style) {
  return add(HistogramSeries{std::move(label), std::move(values), std::move(style)});
}

Chart& Chart::distribution(std::string label, std::vector<double> values, SeriesStyle style) {
  for (const Series& series : series_) {
    refuse_if(std::holds_alternative<BarSeries>(series),
              "chart '{}': distribution '{}' in a chart of bars; use a chart of its own",
              settings_.title, label);
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
  const Picture picture = picture_of(settings_, series_);
  return svg::open_picture(picture.width_px, picture.height_px, settings_.title) + picture.body +
         "</svg>\n";
}

ChartGrid::ChartGrid(int columns, std::string title) : columns_(columns), title_(std::move(title)) {
  refuse_if(columns < 1, "chart grid: {} columns; expected at least 1", columns);
}

ChartGrid& ChartGrid::add(Chart chart) {
  charts_.push_back(std::move(chart));
  return *this;
}

std::string ChartGrid::svg() const {
  constexpr double kGapPx = 12.0;
  std::string body;
  double bottom = 0.0;
  double right = 0.0;
  if (!title_.empty()) {
    body += svg::text(12.0, 26.0, title_, {.size_px = 19.0, .bold = true});
    bottom = 38.0;
    right = 24.0 + svg::text_width(title_, 19.0);
  }
  for (std::size_t first = 0; first < charts_.size(); first += std::size_t(columns_)) {
    const std::size_t end = std::min(charts_.size(), first + std::size_t(columns_));
    double x = 0.0;
    double row_height = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const Picture picture = picture_of(charts_[i].settings(), charts_[i].series());
      body += translated(x, bottom, picture.body);
      x += picture.width_px + kGapPx;
      row_height = std::max(row_height, picture.height_px);
    }
    right = std::max(right, x - kGapPx);
    bottom += row_height + kGapPx;
  }
  return svg::open_picture(std::max(right, 1.0), std::max(bottom, 1.0), title_) + body + "</svg>\n";
}

}  // namespace limber
