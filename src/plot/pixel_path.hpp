#pragma once

#include <string>
#include <vector>

namespace limber {

/// A point in pixels.
struct Pixel {
  double x = 0.0;
  double y = 0.0;
};

/// Thins a line without changing its picture: of successive points that share a pixel column it
/// keeps the first, the lowest, the highest and the last, in their order.
std::vector<Pixel> decimate(const std::vector<Pixel>& points);

/// "M… L…" through the points; a lone point becomes a dot's worth of line.
std::string pixel_path(const std::vector<Pixel>& points);

}  // namespace limber
