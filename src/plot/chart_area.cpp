#include "chart_area.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "limber/plot/svg_text.hpp"
#include "svg_elements.hpp"

namespace limber {

namespace {

constexpr double kRightPx = 16.0;
constexpr double kTickPx = 5.0;
constexpr double kSlantRad = 0.5;
constexpr double kMargin = 1.08;  // shapes do not touch the frame

/// Where a value lies between `low` (0) and `high` (1).
double share(double value, double low, double high, bool logarithmic) {
  if (logarithmic) {
    return std::log(value / low) / std::log(high / low);
  }
  return (value - low) / (high - low);
}

/// Makes a range `factor` times as wide about its middle.
void widen(double factor, NiceRange& range) {
  const double grow = 0.5 * (factor - 1.0) * (range.high - range.low);
  range = {range.low - grow, range.high + grow};
}

double widest(const std::vector<std::string>& labels) {
  double width = 0.0;
  for (const std::string& label : labels) {
    width = std::max(width, svg::text_width(label, svg::kTextPx));
  }
  return width;
}

}  // namespace

ChartArea::ChartArea(const ChartSettings& settings, const ChartMeasure& measure)
    : settings_(settings), x_(measure.x), y_(measure.y), logarithmic_(settings.y.logarithmic) {
  top_px_ = settings.title.empty() ? 12.0 : 36.0;
  const auto make_y_ticks = [&] {
    y_ticks_ = logarithmic_ ? logarithmic_ticks(y_.low, y_.high)
                            : linear_ticks(y_.low, y_.high, std::max(2, settings.height_px / 60));
    left_px_ = 14.0 + widest(y_ticks_.labels) + (settings.y.label.empty() ? 0.0 : 24.0);
    width_px_ = settings.width_px - left_px_ - kRightPx;
  };
  make_y_ticks();
  const double slot = width_px_ / std::max<std::size_t>(1, settings.categories.size());
  const double longest = widest(settings.categories);
  slanted_ = longest > slot;
  below_px_ = settings.x.label.empty() ? 28.0 : 50.0;
  below_px_ += slanted_ ? longest * std::sin(kSlantRad) : 0.0;
  height_px_ = std::max(60.0, settings.height_px - top_px_ - below_px_);
  if (settings.equal_aspect && !logarithmic_ && settings.categories.empty()) {
    widen(settings.x.range ? 1.0 : kMargin, x_);
    widen(settings.y.range ? 1.0 : kMargin, y_);
    widen_to_equal_aspect();
    make_y_ticks();
    widen_to_equal_aspect();
  }
  if (settings.categories.empty()) {
    x_ticks_ = linear_ticks(x_.low, x_.high, std::max(2, int(width_px_ / 80.0)));
  }
}

void ChartArea::widen_to_equal_aspect() {
  const double x_scale = width_px_ / (x_.high - x_.low);
  const double y_scale = height_px_ / (y_.high - y_.low);
  if (x_scale > y_scale) {
    widen(x_scale / y_scale, x_);
  } else {
    widen(y_scale / x_scale, y_);
  }
}

double ChartArea::pixel_x(double x) const {
  return svg::tame(width_px_ * share(x, x_.low, x_.high, false));
}

double ChartArea::pixel_y(double y) const {
  return svg::tame(height_px_ * (1.0 - share(y, y_.low, y_.high, logarithmic_)));
}

double ChartArea::floor_px() const {
  return logarithmic_ ? height_px_ : pixel_y(std::clamp(0.0, y_.low, y_.high));
}

std::string ChartArea::edges() const {
  if (!settings_.categories.empty()) {
    return "";
  }
  return svg::attribute("data-x", fmt::format("{} {}", x_.low, x_.high)) +
         svg::attribute("data-y",
                        fmt::format("{} {}{}", y_.low, y_.high, logarithmic_ ? " log" : ""));
}

std::string ChartArea::grid() const {
  std::string data;
  for (const double x : x_ticks_.values) {
    data += "M" + svg::point(pixel_x(x), 0.0) + "V" + svg_number(height_px_);
  }
  for (const double y : y_ticks_.values) {
    data += "M" + svg::point(0.0, pixel_y(y)) + "H" + svg_number(width_px_);
  }
  return fmt::format("<path d=\"{}\" stroke=\"{}\" fill=\"none\"/>\n", data, svg::kGrid);
}

std::string ChartArea::x_ticks() const {
  std::string out;
  for (std::size_t i = 0; i < x_ticks_.values.size(); ++i) {
    const double x = pixel_x(x_ticks_.values[i]);
    out += svg::line(x, height_px_, x, height_px_ + kTickPx, svg::kInk, 1.0);
    out += svg::text(x, height_px_ + 20.0, x_ticks_.labels[i], {.anchor = TextAnchor::kMiddle});
  }
  for (std::size_t i = 0; i < settings_.categories.size(); ++i) {
    const double x = pixel_x(double(i));
    const double y = height_px_ + 20.0;
    const std::string turn = svg::attribute(
        "transform",
        fmt::format("rotate(-{} {})", svg_number(kSlantRad * 57.2958), svg::point(x, y)));
    out += svg::text(x, y, settings_.categories[i],
                     {.anchor = slanted_ ? TextAnchor::kEnd : TextAnchor::kMiddle},
                     slanted_ ? turn : "");
  }
  return out;
}

std::string ChartArea::frame() const {
  std::string out = svg::rectangle(0.0, 0.0, width_px_, height_px_,
                                   svg::look({.stroke = std::string(svg::kInk), .width_px = 1.0}));
  out += "<g data-ticks=\"x\">\n" + x_ticks() + "</g>\n";
  for (std::size_t i = 0; i < y_ticks_.values.size(); ++i) {
    const double y = pixel_y(y_ticks_.values[i]);
    out += svg::line(-kTickPx, y, 0.0, y, svg::kInk, 1.0);
    out += svg::text(-8.0, y + 5.0, y_ticks_.labels[i], {.anchor = TextAnchor::kEnd});
  }
  if (!settings_.x.label.empty()) {
    out += svg::text(width_px_ / 2.0, height_px_ + below_px_ - 8.0, settings_.x.label,
                     {.anchor = TextAnchor::kMiddle});
  }
  if (!settings_.y.label.empty()) {
    const double x = 16.0 - left_px_;
    const std::string turn =
        svg::attribute("transform", fmt::format("rotate(-90 {})", svg::point(x, height_px_ / 2.0)));
    out += svg::text(x, height_px_ / 2.0, settings_.y.label, {.anchor = TextAnchor::kMiddle}, turn);
  }
  return out;
}

}  // namespace limber
