#include "chart_renderer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "chart_area.hpp"
#include "chart_shapes.hpp"
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

}  // namespace

std::string render_chart(const ChartSettings& settings, const std::vector<Series>& series) {
  const Picture picture = picture_of(settings, series);
  return svg::open_picture(picture.width_px, picture.height_px, settings.title) + picture.body +
         "</svg>\n";
}

std::string render_grid(const std::vector<Chart>& charts, int columns, std::string_view title) {
  constexpr double kGapPx = 12.0;
  std::string body;
  double bottom = 0.0;
  double right = 0.0;
  if (!title.empty()) {
    body += svg::text(12.0, 26.0, title, {.size_px = 19.0, .bold = true});
    bottom = 38.0;
    right = 24.0 + svg::text_width(title, 19.0);
  }
  for (std::size_t first = 0; first < charts.size(); first += static_cast<std::size_t>(columns)) {
    const std::size_t end = std::min(charts.size(), first + static_cast<std::size_t>(columns));
    double x = 0.0;
    double row_height = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const Picture picture = picture_of(charts[i].settings(), charts[i].series());
      body += translated(x, bottom, picture.body);
      x += picture.width_px + kGapPx;
      row_height = std::max(row_height, picture.height_px);
    }
    right = std::max(right, x - kGapPx);
    bottom += row_height + kGapPx;
  }
  return svg::open_picture(std::max(right, 1.0), std::max(bottom, 1.0), title) + body + "</svg>\n";
}

}  // namespace limber
