#include "src/plot/chart_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>

namespace limber {
namespace {

/// A jagged line of many points a pixel column, with one lone spike.
std::vector<Pixel> jagged_line() {
  std::vector<Pixel> points;
  for (int i = 0; i < 50000; ++i) {
    points.push_back({i * 0.01, 100.0 + 40.0 * std::sin(i * 0.37) + 30.0 * std::cos(i * 0.011)});
  }
  points[31234].y = 900.0;
  return points;
}

TEST(Decimate, KeepsEndsAndEveryColumnsExtremes) {
  const std::vector<Pixel> points = jagged_line();
  const std::vector<Pixel> kept = decimate(points);
  const auto extremes = [](const std::vector<Pixel>& line) {
    std::map<int, std::pair<double, double>> columns;
    for (const Pixel& point : line) {
      auto& [low, high] =
          columns.try_emplace(static_cast<int>(point.x), point.y, point.y).first->second;
      low = std::min(low, point.y);
      high = std::max(high, point.y);
    }
    return columns;
  };
  EXPECT_EQ(extremes(kept), extremes(points));
  EXPECT_EQ(kept.front().x, points.front().x);
  EXPECT_EQ(kept.back().x, points.back().x);
  EXPECT_LE(kept.size(), 4U * 500U);
}

TEST(Decimate, KeepsTheOrderOfPoints) {
  const std::vector<Pixel> kept = decimate(jagged_line());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(),
                             [](const Pixel& a, const Pixel& b) { return a.x < b.x; }));
}

TEST(Decimate, LeavesShortLinesAlone) {
  const std::vector<Pixel> points{{0.0, 1.0}, {10.0, 5.0}, {4.0, 2.0}, {4.2, 1.0}};
  EXPECT_EQ(decimate(points).size(), points.size());
  EXPECT_TRUE(decimate({}).empty());
}

TEST(PixelPath, JoinsPointsAndShowsALoneOne) {
  EXPECT_EQ(pixel_path({{0.0, 1.5}, {2.0, 3.25}}), "M0 1.5L2 3.25");
  EXPECT_EQ(pixel_path({{1.0, 2.0}}), "M1 2h0.01");
  EXPECT_EQ(pixel_path({}), "");
}

}  // namespace
}  // namespace limber
