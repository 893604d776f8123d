#include "svg_elements.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/plot/svg_text.hpp"

namespace limber::svg {

std::string open_picture(double width_px, double height_px, std::string_view title) {
  const std::string width = svg_number(width_px);
  const std::string height = svg_number(height_px);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"Helvetica,Arial,sans-serif\" role=\"img\">\n{2}"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      width, height, title.empty() ? "" : "<title>" + escape_xml(title) + "</title>\n");
}

std::string attribute(std::string_view name, std::string_view value) {
  return fmt::format(" {}=\"{}\"", name, escape_xml(value));
}

std::string attribute(std::string_view name, double value) {
  return fmt::format(" {}=\"{}\"", name, svg_number(value));
}

std::string look(const ShapeStyle& style) {
  std::string text = attribute("fill", style.fill);
  if (style.stroke != "none") {
    text += attribute("stroke", style.stroke) + attribute("stroke-width", style.width_px);
    if (style.dashed) {
      text += attribute("stroke-dasharray", "6 4");
    }
  }
  if (style.opacity < 1.0) {
    text += attribute("opacity", style.opacity);
  }
  return text;
}

std::string line(double x1, double y1, double x2, double y2, std::string_view color,
                 double width_px, bool dashed) {
  return fmt::format("<path d=\"M{}L{}\"{}/>\n", point(x1, y1), point(x2, y2),
                     look({.stroke = std::string(color), .width_px = width_px, .dashed = dashed}));
}

std::string rectangle(double x, double y, double width, double height, std::string_view look) {
  return "<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
         attribute("height", height) + std::string(look) + "/>\n";
}

std::string text(double x, double y, std::string_view content, const TextStyle& style,
                 std::string_view more_attributes) {
  std::string out = "<text" + attribute("x", x) + attribute("y", y) +
                    attribute("font-size", style.size_px) + attribute("fill", style.color);
  if (style.anchor != TextAnchor::kStart) {
    out += attribute("text-anchor", style.anchor == TextAnchor::kEnd ? "end" : "middle");
  }
  if (style.bold) {
    out += attribute("font-weight", "bold");
  }
  return out + std::string(more_attributes) + ">" + escape_xml(content) + "</text>\n";
}

double text_width(std::string_view content, double size_px) {
  const auto characters = std::count_if(content.begin(), content.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  });
  return 0.56 * size_px * double(characters);
}

std::string point(double x, double y) {
  return svg_number(x) + " " + svg_number(y);
}

double tame(double pixel) {
  constexpr double kFarPx = 1e5;
  return std::clamp(pixel, -kFarPx, kFarPx);
}

Key key(const std::vector<LegendEntry>& entries, double left_px, double top_px, double width_px) {
  constexpr double kSwatchPx = 22.0;
  constexpr double kGapPx = 18.0;
  constexpr double kRowPx = 21.0;
  Key out;
  double x = left_px;
  double y = top_px;
  for (const LegendEntry& entry : entries) {
    const double needed = kSwatchPx + 6.0 + text_width(entry.label, kTextPx);
    if (x > left_px && x + needed > left_px + width_px) {
      x = left_px;
      y += kRowPx;
    }
    if (entry.dot) {
      out.body += "<circle" + attribute("cx", x + kSwatchPx / 2.0) + attribute("cy", y) +
                  attribute("r", 4.5) + look(entry.style) + "/>\n";
    } else if (entry.style.fill == "none") {
      out.body += line(x, y, x + kSwatchPx, y, entry.style.stroke,
                       std::max(entry.style.width_px, 2.0), entry.style.dashed);
    } else {
      out.body += rectangle(x, y - 6.0, kSwatchPx, 12.0, look(entry.style));
    }
    out.body += text(x + kSwatchPx + 6.0, y + 5.0, entry.label, {.size_px = kTextPx});
    x += needed + kGapPx;
  }
  out.height_px = entries.empty() ? 0.0 : y - top_px + kRowPx;
  return out;
}

}  // namespace limber::svg
