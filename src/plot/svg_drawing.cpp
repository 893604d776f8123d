#include "limber/plot/svg_drawing.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "chart_measure.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/plot/svg_text.hpp"
#include "svg_elements.hpp"

namespace limber {

namespace {

constexpr double kTickLengthPx = 5.0;
/// Points of a line nearer than this to the one before are left out.
constexpr double kFinestPx = 0.05;

bool is_finite(WorldPoint point) {
  return std::isfinite(point.x_m) && std::isfinite(point.y_m);
}

void check_box(const WorldBox& box, double width_px) {
  const bool finite = std::isfinite(box.x_min_m) && std::isfinite(box.x_max_m) &&
                      std::isfinite(box.y_min_m) && std::isfinite(box.y_max_m);
  refuse_if(!finite || box.x_min_m >= box.x_max_m || box.y_min_m >= box.y_max_m,
            "drawing: box x {} … {} m, y {} … {} m; each must rise from a "
            "finite minimum to a finite maximum",
            box.x_min_m, box.x_max_m, box.y_min_m, box.y_max_m);
  refuse_if(!std::isfinite(width_px) || width_px <= 0.0,
            "drawing: width {} px; expected a finite number > 0", width_px);
}

}  // namespace

std::string palette_color(int index) {
  assert(index >= 0);
  static constexpr std::array kColors{"#d55e00", "#0072b2", "#111111", "#009e73",
                                      "#cc79a7", "#e69f00", "#56b4e9", "#b8a900"};
  return kColors[std::size_t(index) % kColors.size()];
}

SvgDrawing::SvgDrawing(const WorldBox& box, double width_px, std::string title)
    : box_(box), scale_(0.0), title_(std::move(title)) {
  check_box(box, width_px);
  scale_ = width_px / (box.x_max_m - box.x_min_m);
}

double SvgDrawing::pixel_x(double x_m) const {
  return svg::tame((x_m - box_.x_min_m) * scale_);
}

double SvgDrawing::pixel_y(double y_m) const {
  return svg::tame((box_.y_max_m - y_m) * scale_);
}

double SvgDrawing::pixels(double length_m) const {
  return svg::tame(length_m * scale_);
}

bool SvgDrawing::drawable(std::span<const WorldPoint> points, double size) {
  const bool finite = std::all_of(points.begin(), points.end(), is_finite) && std::isfinite(size);
  undrawable_ += finite ? 0 : 1;
  return finite;
}

std::string SvgDrawing::path(std::span<const WorldPoint> points) const {
  std::string data;
  bool pen_down = false;
  double last_x = 0.0;
  double last_y = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) {
      pen_down = false;
      continue;
    }
    const double x = pixel_x(points[i].x_m);
    const double y = pixel_y(points[i].y_m);
    const bool last_of_run = i + 1 == points.size() || !is_finite(points[i + 1]);
    if (pen_down && !last_of_run && std::hypot(x - last_x, y - last_y) < kFinestPx) {
      continue;
    }
    data += (pen_down ? "L" : "M") + svg::point(x, y);
    pen_down = true;
    last_x = x;
    last_y = y;
  }
  return data;
}

void SvgDrawing::polyline(std::span<const WorldPoint> points, const ShapeStyle& style) {
  undrawable_ += int(std::count_if(points.begin(), points.end(),
                                   [](WorldPoint point) { return !is_finite(point); }));
  const std::string data = path(points);
  if (!data.empty()) {
    body_ += fmt::format("<path d=\"{}\"{} stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n",
                         data, svg::look(style));
  }
}

void SvgDrawing::polygon(std::span<const WorldPoint> points, const ShapeStyle& style) {
  if (points.empty() || !drawable(points)) {
    return;
  }
  body_ += fmt::format("<path d=\"{}Z\"{}/>\n", path(points), svg::look(style));
}

void SvgDrawing::circle(WorldPoint center, double radius_m, const ShapeStyle& style) {
  if (!drawable({&center, 1}, radius_m)) {
    return;
  }
  body_ += "<circle" + svg::attribute("cx", pixel_x(center.x_m)) +
           svg::attribute("cy", pixel_y(center.y_m)) +
           svg::attribute("r", std::abs(pixels(radius_m))) + svg::look(style) + "/>\n";
}

void SvgDrawing::rectangle(WorldPoint center, double width_m, double height_m, double angle_rad,
                           const ShapeStyle& style) {
  const double cosine = std::cos(angle_rad);
  const double sine = std::sin(angle_rad);
  std::vector<WorldPoint> corners;
  for (const auto& [along, across] :
       {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
    const double x = along * width_m;
    const double y = across * height_m;
    corners.push_back({center.x_m + cosine * x - sine * y, center.y_m + sine * x + cosine * y});
  }
  polygon(corners, style);
}

void SvgDrawing::segments(std::span<const WorldPoint> end_points, const ShapeStyle& style) {
  std::string data;
  for (std::size_t i = 0; i + 1 < end_points.size(); i += 2) {
    if (drawable(end_points.subspan(i, 2))) {
      data += path(end_points.subspan(i, 2));
    }
  }
  if (!data.empty()) {
    body_ += fmt::format("<path d=\"{}\"{}/>\n", data, svg::look(style));
  }
}

void SvgDrawing::capsule_chain(std::span<const WorldPoint> points, std::span<const double> radii_m,
                               const ShapeStyle& style) {
  refuse_if(points.empty() || radii_m.size() + 1 != points.size(),
            "drawing: a chain of {} points with {} radii; expected one radius "
            "for each gap between two points",
            points.size(), radii_m.size());
  const bool radii_finite = std::all_of(radii_m.begin(), radii_m.end(),
                                        [](double radius) { return std::isfinite(radius); });
  if (!drawable(points, radii_finite ? 0.0 : std::nan(""))) {
    return;
  }
  // Strokes with round ends, twice: a wider one underneath leaves an outline.
  const auto strokes = [&](std::string_view color, double grow_px) {
    std::string out = fmt::format("<g{}>", svg::attribute("stroke", color));
    for (std::size_t first = 0; first < radii_m.size();) {
      std::size_t last = first + 1;
      while (last < radii_m.size() && radii_m[last] == radii_m[first]) {
        ++last;
      }
      out += fmt::format(
          "<path d=\"{}\"{}/>", path(points.subspan(first, last - first + 1)),
          svg::attribute("stroke-width", 2.0 * std::abs(pixels(radii_m[first])) + grow_px));
      first = last;
    }
    return out + "</g>";
  };
  body_ += "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
  body_ += style.opacity < 1.0 ? svg::attribute("opacity", style.opacity) + ">" : ">";
  body_ += style.stroke == "none" ? "" : strokes(style.stroke, 2.0 * style.width_px);
  body_ += style.fill == "none" ? "" : strokes(style.fill, 0.0);
  body_ += "</g>\n";
}

void SvgDrawing::star(WorldPoint center, double radius_m, const ShapeStyle& style) {
  constexpr double kInner = 0.42;  // radius of the inner corners over that of the points
  std::vector<WorldPoint> corners;
  for (int i = 0; i < 10; ++i) {
    const double angle = std::numbers::pi * (0.5 + i / 5.0);
    const double radius = i % 2 == 0 ? radius_m : kInner * radius_m;
    corners.push_back(
        {center.x_m + radius * std::cos(angle), center.y_m + radius * std::sin(angle)});
  }
  polygon(corners, style);
}

void SvgDrawing::arrow(WorldPoint from, WorldPoint to, const ShapeStyle& style) {
  if (!drawable(std::array{from, to})) {
    return;
  }
  const double length_px = scale_ * std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
  const double head_px = std::min(12.0, 0.6 * length_px);
  const double head_m = head_px / scale_;
  const double angle = std::atan2(to.y_m - from.y_m, to.x_m - from.x_m);
  const auto behind = [&](double offset) {
    return WorldPoint{to.x_m - head_m * std::cos(angle + offset),
                      to.y_m - head_m * std::sin(angle + offset)};
  };
  body_ += "<g" + svg::attribute("data-layer", "arrow") +
           (style.opacity < 1.0 ? svg::attribute("opacity", style.opacity) : "") + ">\n";
  ShapeStyle opaque = style;
  opaque.opacity = 1.0;
  polyline(std::array{from, behind(0.0)}, opaque);
  polygon(std::array{to, behind(0.4), behind(-0.4)}, {.fill = style.stroke, .stroke = "none"});
  body_ += "</g>\n";
}

void SvgDrawing::text(WorldPoint at, std::string_view text, const TextStyle& style) {
  if (drawable({&at, 1})) {
    body_ += svg::text(pixel_x(at.x_m), pixel_y(at.y_m), text, style);
  }
}

void SvgDrawing::axes() {
  axes_ = true;
  std::string grid;
  for (const double x : linear_ticks(box_.x_min_m, box_.x_max_m).values) {
    grid += "M" + svg::point(pixel_x(x), 0.0) + "V" + svg_number(pixel_y(box_.y_min_m));
  }
  for (const double y : linear_ticks(box_.y_min_m, box_.y_max_m).values) {
    grid += "M" + svg::point(0.0, pixel_y(y)) + "H" + svg_number(pixel_x(box_.x_max_m));
  }
  body_ += fmt::format("<path d=\"{}\" stroke=\"{}\" fill=\"none\"/>\n", grid, svg::kGrid);
}

void SvgDrawing::legend(std::string_view label, const ShapeStyle& style) {
  legend_.push_back({.label = std::string(label), .style = style});
}

std::string SvgDrawing::frame_and_ticks() const {
  const double right = pixel_x(box_.x_max_m);
  const double bottom = pixel_y(box_.y_min_m);
  std::string out = svg::rectangle(0.0, 0.0, right, bottom,
                                   svg::look({.stroke = std::string(svg::kInk), .width_px = 1.0}));
  if (!axes_) {
    return out;
  }
  const AxisTicks along = linear_ticks(box_.x_min_m, box_.x_max_m);
  for (std::size_t i = 0; i < along.values.size(); ++i) {
    const double x = pixel_x(along.values[i]);
    out += svg::line(x, bottom, x, bottom + kTickLengthPx, svg::kInk, 1.0);
    out += svg::text(x, bottom + 20.0, along.labels[i], {.anchor = TextAnchor::kMiddle});
  }
  const AxisTicks across = linear_ticks(box_.y_min_m, box_.y_max_m);
  for (std::size_t i = 0; i < across.values.size(); ++i) {
    const double y = pixel_y(across.values[i]);
    out += svg::line(-kTickLengthPx, y, 0.0, y, svg::kInk, 1.0);
    out += svg::text(-8.0, y + 5.0, across.labels[i], {.anchor = TextAnchor::kEnd});
  }
  out += svg::text(right / 2.0, bottom + 39.0, "x [m]", {.anchor = TextAnchor::kMiddle});
  out += svg::text(-46.0, bottom / 2.0, "y [m]", {.anchor = TextAnchor::kMiddle},
                   svg::attribute("transform", "rotate(-90 -46 " + svg_number(bottom / 2.0) + ")"));
  return out;
}

std::string SvgDrawing::svg() const {
  const double world_width = pixel_x(box_.x_max_m);
  const double world_height = pixel_y(box_.y_min_m);
  const double left = axes_ ? 66.0 : 8.0;
  const double top = title_.empty() ? 10.0 : 34.0;
  const double width = left + world_width + 14.0;
  double bottom = top + world_height + (axes_ ? 46.0 : 8.0);
  const svg::Key key = svg::key(legend_, left, bottom + 12.0, world_width);
  std::string below = key.body;
  bottom += key.height_px;
  if (undrawable_ > 0) {
    bottom += 20.0;
    below += svg::text(left, bottom - 6.0, fmt::format("{} not drawn: not finite", undrawable_),
                       {.color = "#b00020", .size_px = svg::kSmallTextPx});
  }
  std::string out = svg::open_picture(width, bottom + 6.0, title_);
  if (!title_.empty()) {
    out += svg::text(left, 23.0, title_, {.size_px = 17.0, .bold = true});
  }
  // A nested <svg> cuts off at its edges without needing an id, which many pictures in one page
  // would share.
  out += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" overflow=\"hidden\">\n",
                     svg_number(left), svg_number(top), svg_number(world_width),
                     svg_number(world_height));
  out += body_;
  out += fmt::format("</svg>\n<g transform=\"translate({} {})\">\n", svg_number(left),
                     svg_number(top));
  return out + frame_and_ticks() + "</g>\n" + below + "</svg>\n";
}

}  // namespace limber
