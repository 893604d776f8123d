#include "pixel_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "svg_elements.hpp"

namespace limber {

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

}  // namespace limber
