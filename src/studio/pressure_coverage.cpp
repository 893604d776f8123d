#include "pressure_coverage.hpp"

#include <algorithm>

namespace limber {

namespace {

constexpr int kCells = 24;  // per side
constexpr int kMaxPairs = 15;

int cell_of(double kpa, const PressureLimits& limits) {
  const double share = (kpa - limits.lower_kpa) / (limits.upper_kpa - limits.lower_kpa);
  return std::clamp(static_cast<int>(share * kCells), 0, kCells - 1);
}

}  // namespace

nlohmann::ordered_json coverage_to_json(const ArmDescription& arm,
                                        const std::vector<Episode>& episodes) {
  nlohmann::ordered_json json = {{"cells", kCells}, {"pairs", nlohmann::ordered_json::array()}};
  const auto segments = static_cast<int>(arm.segments.size());
  for (int i = 0; i < segments; ++i) {
    for (int j = i + 1; j < segments && json["pairs"].size() < kMaxPairs; ++j) {
      std::vector<int> frames(std::size_t{kCells} * kCells, 0);
      const PressureLimits& across = arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
      const PressureLimits& up = arm.segments[static_cast<std::size_t>(j)].pressure_limit_kpa;
      for (const Episode& episode : episodes) {
        for (Eigen::Index t = 0; t < episode.pressure_kpa.rows(); ++t) {
          const int column = cell_of(double(episode.pressure_kpa(t, i)), across);
          const int row = cell_of(double(episode.pressure_kpa(t, j)), up);
          ++frames[static_cast<std::size_t>(row * kCells + column)];
        }
      }
      json["pairs"].push_back({{"segments", {i, j}}, {"frames", frames}});
    }
  }
  return json;
}

}  // namespace limber
