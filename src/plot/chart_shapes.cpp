#include "chart_shapes.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/plot/svg_text.hpp"
#include "svg_elements.hpp"

namespace limber {

namespace {

double silverman_bandwidth(const std::vector<double>& values, const Spread& spread) {
  const double deviation = standard_deviation(values);
  const double quartiles = (spread.p75 - spread.p25) / 1.34;
  const double width = quartiles > 0.0 ? std::min(deviation, quartiles) : deviation;
  return 0.9 * width * std::pow(double(values.size()), -0.2);
}

constexpr double kBandOpacity = 0.22;
constexpr double kHistogramOpacity = 0.45;

ShapeStyle stroke_style(const SeriesStyle& style) {
  return {.stroke = style.color,
          .width_px = style.width_px,
          .opacity = style.opacity,
          .dashed = style.dashed};
}

ShapeStyle fill_style(const SeriesStyle& style, double opacity) {
  return {.fill = style.color, .stroke = "none", .opacity = style.opacity * opacity};
}

/// Runs of drawable points, in pixels.
std::vector<std::vector<Pixel>> runs(const ChartArea& area, const std::vector<double>& x,
                                     const std::vector<double>& y) {
  std::vector<std::vector<Pixel>> out;
  bool broken = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_drawable(x[i]) || !is_drawable(y[i], area.logarithmic())) {
      broken = true;
      continue;
    }
    if (broken) {
      out.emplace_back();
      broken = false;
    }
    out.back().push_back({area.pixel_x(x[i]), area.pixel_y(y[i])});
  }
  return out;
}

/// What a report calls the line where the pointer is.
std::string named(const std::string& label) {
  return label.empty() ? "" : svg::attribute("data-name", label);
}

std::string filled_path(const std::string& data, const ShapeStyle& style) {
  return fmt::format("<path d=\"{}Z\"{}/>\n", data, svg::look(style));
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  return {mean(values),   quantile(values, 0.05), quantile(values, 0.25),
          median(values), quantile(values, 0.75), quantile(values, 0.95)};
}

DensityOutline density_outline(const std::vector<double>& values, int steps) {
  assert(!values.empty() && steps >= 2);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest;
  const double width = *highest - low;
  const double bandwidth = silverman_bandwidth(values, spread_of(values));
  if (width <= 0.0 || bandwidth <= 0.0) {
    return {{low}, {1.0}};
  }
  // Values are counted in fine bins first, so that a million of them cost no more than a thousand.
  constexpr int kFineBins = 512;
  std::vector<double> counts(kFineBins, 0.0);
  for (const double value : values) {
    const long bin = std::lround((value - low) / width * (kFineBins - 1));
    counts[bin] += 1.0;
  }
  DensityOutline outline;
  for (int step = 0; step < steps; ++step) {
    const double at = low + width * step / (steps - 1);
    double density = 0.0;
    for (int bin = 0; bin < kFineBins; ++bin) {
      const double distance = (low + width * bin / (kFineBins - 1) - at) / bandwidth;
      density += counts[bin] * std::exp(-0.5 * distance * distance);
    }
    outline.at.push_back(at);
    outline.density.push_back(density);
  }
  const double largest = *std::max_element(outline.density.begin(), outline.density.end());
  for (double& density : outline.density) {
    density = largest > 0.0 ? density / largest : 1.0;
  }
  return outline;
}

std::vector<Pixel> decimate(const std::vector<Pixel>& points) {
  std::vector<Pixel> kept;
  for (std::size_t first = 0; first < points.size();) {
    const double column = std::floor(points[first].x);
    std::size_t end = first + 1;
    std::size_t lowest = first;
    std::size_t highest = first;
    while (end < points.size() && std::floor(points[end].x) == column) {
      lowest = points[end].y < points[lowest].y ? end : lowest;
      highest = points[end].y > points[highest].y ? end : highest;
      ++end;
    }
    std::array indices{first, lowest, highest, end - 1};
    std::sort(indices.begin(), indices.end());
    const auto unique_end = std::unique(indices.begin(), indices.end());
    for (auto index = indices.begin(); index != unique_end; ++index) {
      kept.push_back(points[*index]);
    }
    first = end;
  }
  return kept;
}

std::string pixel_path(const std::vector<Pixel>& points) {
  std::string data;
  for (const Pixel& point : points) {
    data += (data.empty() ? "M" : "L") + svg::point(point.x, point.y);
  }
  if (points.size() == 1) {
    data += "h0.01";
  }
  return data;
}

SeriesDrawer::SeriesDrawer(const ChartArea& area, const ChartMeasure& measure,
                           const std::vector<Series>& series)
    : area_(area), measure_(measure) {
  bar_series_ = int(std::ranges::count_if(
      series, [](const Series& each) { return std::holds_alternative<BarSeries>(each); }));
}

std::string SeriesDrawer::operator()(const LineSeries& series) {
  std::string data;
  for (const std::vector<Pixel>& run : runs(area_, series.x, series.y)) {
    data += pixel_path(decimate(run));
  }
  if (data.empty()) {
    return "";
  }
  return fmt::format("<path d=\"{}\"{}{} stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
                     data, svg::look(stroke_style(series.style)), named(series.label));
}

std::string SeriesDrawer::operator()(const PointSeries& series) {
  // One path of round dots: a tenth of the size of as many circles.
  std::string data;
  for (const std::vector<Pixel>& run : runs(area_, series.x, series.y)) {
    for (const Pixel& point : run) {
      data += "M" + svg::point(point.x, point.y) + "h0";
    }
  }
  if (data.empty()) {
    return "";
  }
  ShapeStyle style = stroke_style(series.style);
  style.width_px = 2.0 * series.style.radius_px;
  style.dashed = false;
  return fmt::format("<path d=\"{}\"{}{} stroke-linecap=\"round\"/>\n", data, svg::look(style),
                     named(series.label));
}

std::string SeriesDrawer::operator()(const BandSeries& series) {
  std::vector<double> low = series.low;
  std::vector<double> high = series.high;
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (!is_drawable(low[i], area_.logarithmic()) || !is_drawable(high[i], area_.logarithmic())) {
      low[i] = std::nan("");
      high[i] = std::nan("");
    }
  }
  const auto lower = runs(area_, series.x, low);
  const auto upper = runs(area_, series.x, high);
  std::string out;
  for (std::size_t i = 0; i < lower.size(); ++i) {
    std::vector<Pixel> outline = decimate(upper[i]);
    const std::vector<Pixel> back = decimate(lower[i]);
    outline.insert(outline.end(), back.rbegin(), back.rend());
    out += filled_path(pixel_path(outline), fill_style(series.style, kBandOpacity));
  }
  return out;
}

std::string SeriesDrawer::operator()(const BarSeries& series) {
  constexpr double kGroupShare = 0.8;  // of a category's width, for all of its bars
  const double bar_width = kGroupShare / std::max(1, bar_series_);
  const double offset = -0.5 * kGroupShare + bar_width * next_bar_series_++;
  std::string out;
  for (std::size_t i = 0; i < series.values.size(); ++i) {
    const double error = series.errors.empty() ? 0.0 : series.errors[i];
    if (!is_drawable(series.values[i], area_.logarithmic()) || !is_drawable(error)) {
      continue;
    }
    const double left = area_.pixel_x(double(i) + offset);
    const double right = area_.pixel_x(double(i) + offset + bar_width);
    const double end = area_.pixel_y(series.values[i]);
    const double top = std::min(end, area_.floor_px());
    out +=
        svg::rectangle(left + 1.0, top, std::max(1.0, right - left - 2.0),
                       std::abs(end - area_.floor_px()), svg::look(fill_style(series.style, 1.0)));
    const double lower = series.values[i] - error;
    if (error != 0.0) {
      const double middle = 0.5 * (left + right);
      const double bottom =
          is_drawable(lower, area_.logarithmic()) ? area_.pixel_y(lower) : area_.height_px();
      out += svg::line(middle, area_.pixel_y(series.values[i] + error), middle, bottom, svg::kInk,
                       1.5);
    }
  }
  return out;
}

std::string SeriesDrawer::operator()(const HistogramSeries& series) {
  if (measure_.bin_edges.empty()) {
    return "";
  }
  const std::vector<int> counts = bin_counts(series.values, measure_.bin_edges);
  const double floor = area_.floor_px();
  std::vector<Pixel> outline{{area_.pixel_x(measure_.bin_edges.front()), floor}};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double y = counts[i] > 0 ? area_.pixel_y(counts[i]) : floor;
    outline.push_back({area_.pixel_x(measure_.bin_edges[i]), y});
    outline.push_back({area_.pixel_x(measure_.bin_edges[i + 1]), y});
  }
  outline.push_back({area_.pixel_x(measure_.bin_edges.back()), floor});
  const std::string data = pixel_path(outline);
  return filled_path(data, fill_style(series.style, kHistogramOpacity)) +
         fmt::format("<path d=\"{}\"{}/>\n", data, svg::look(stroke_style(series.style)));
}

std::string SeriesDrawer::operator()(const DistributionSeries& series) {
  const double center = area_.pixel_x(next_distribution_);
  const double half_width = 0.42 * (area_.pixel_x(next_distribution_ + 1.0) - center);
  ++next_distribution_;
  std::vector<double> values;
  std::vector<double> heights;  // pixels; densities are estimated where they are drawn
  for (const double value : series.values) {
    if (is_drawable(value, area_.logarithmic())) {
      values.push_back(value);
      heights.push_back(area_.pixel_y(value));
    }
  }
  if (values.empty()) {
    return "";
  }
  const DensityOutline density = density_outline(heights, 96);
  auto outline = mapped<Pixel>(density.at.size(), [&](std::size_t i) {
    return Pixel{center + half_width * density.density[i], density.at[i]};
  });
  for (std::size_t i = density.at.size(); i-- > 0;) {
    outline.push_back({center - half_width * density.density[i], density.at[i]});
  }
  std::string out = filled_path(pixel_path(outline), fill_style(series.style, 0.35));

  const Spread spread = spread_of(values);
  const double box = std::min(0.22 * half_width, 14.0);
  const auto y = [&](double value) { return area_.pixel_y(value); };
  out += svg::line(center, y(spread.p95), center, y(spread.p05), svg::kInk, 1.5);
  out += svg::rectangle(
      center - box, y(spread.p75), 2.0 * box, std::abs(y(spread.p25) - y(spread.p75)),
      svg::look({.fill = series.style.color, .stroke = std::string(svg::kInk), .width_px = 1.2}));
  out += svg::line(center - box, y(spread.median), center + box, y(spread.median), "#ffffff", 3.0);
  out += "<circle" + svg::attribute("cx", center) + svg::attribute("cy", y(spread.mean)) +
         svg::attribute("r", 4.0) +
         svg::look({.fill = "#ffffff", .stroke = std::string(svg::kInk), .width_px = 1.5}) + "/>\n";
  return out;
}

std::string SeriesDrawer::operator()(const ReferenceLine& series) {
  if (!is_drawable(series.at, series.horizontal && area_.logarithmic())) {
    return "";
  }
  const ShapeStyle style = stroke_style(series.style);
  const double at = series.horizontal ? area_.pixel_y(series.at) : area_.pixel_x(series.at);
  const std::string data = series.horizontal
                               ? "M0 " + svg_number(at) + "H" + svg_number(area_.width_px())
                               : "M" + svg_number(at) + " 0V" + svg_number(area_.height_px());
  return fmt::format("<path d=\"{}\"{}/>\n", data, svg::look(style));
}

LegendEntry legend_entry(const Series& series) {
  if (std::holds_alternative<DistributionSeries>(series)) {
    return {};  // named under the axis
  }
  return std::visit(
      [](const auto& each) -> LegendEntry {
        using Type = std::decay_t<decltype(each)>;
        if constexpr (std::is_same_v<Type, LineSeries> || std::is_same_v<Type, ReferenceLine>) {
          return {.label = each.label, .style = stroke_style(each.style)};
        } else if constexpr (std::is_same_v<Type, BandSeries>) {
          return {.label = each.label, .style = fill_style(each.style, kBandOpacity)};
        } else if constexpr (std::is_same_v<Type, HistogramSeries>) {
          return {.label = each.label, .style = fill_style(each.style, kHistogramOpacity)};
        } else {
          return {.label = each.label,
                  .style = fill_style(each.style, 1.0),
                  .dot = std::is_same_v<Type, PointSeries>};
        }
      },
      series);
}

}  // namespace limber
