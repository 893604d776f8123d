#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limber/plot/svg_drawing.hpp"

namespace limber::svg {

inline constexpr std::string_view kInk = "#222222";   ///< text and frames
inline constexpr std::string_view kGrid = "#e3e3e3";  ///< grid lines
inline constexpr double kTextPx = 15.0;               ///< about 9.6 px on a phone, 560 px wide
inline constexpr double kSmallTextPx = 13.0;

/// Start tag of a whole picture with its white background; close it with "</svg>".
std::string open_picture(double width_px, double height_px, std::string_view title);

/// ` name="value"`, the value escaped.
std::string attribute(std::string_view name, std::string_view value);
std::string attribute(std::string_view name, double value);

/// Fill, stroke, width, dashes and opacity of a shape, as attributes.
std::string look(const ShapeStyle& style);

std::string line(double x1, double y1, double x2, double y2, std::string_view color,
                 double width_px, bool dashed = false);
std::string rectangle(double x, double y, double width, double height, std::string_view look);
std::string text(double x, double y, std::string_view content, const TextStyle& style,
                 std::string_view more_attributes = "");

/// About how wide `content` will be: browsers' fonts differ.
double text_width(std::string_view content, double size_px);

/// "12.3 45.6"
std::string point(double x, double y);

/// Moves a pixel coordinate that is far outside nearer, so that numbers stay short.
double tame(double pixel);

/// A key whose entries fill rows of `width_px`, its first row's middle at `top_px`.
struct Key {
  std::string body;
  double height_px = 0.0;
};
Key key(const std::vector<LegendEntry>& entries, double left_px, double top_px, double width_px);

}  // namespace limber::svg
