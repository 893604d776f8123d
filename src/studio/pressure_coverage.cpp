#include "pressure_coverage.hpp"

#include <algorithm>

#include "limber/common/json.hpp"

namespace limber {

namespace {

constexpr int kCells = 24;  // per side
constexpr int kMaxPairs = 15;

int cell_of(double kpa, const PressureLimits& limits) {
  const double share = (kpa - limits.lower_kpa) / (limits.upper_kpa - limits.lower_kpa);
  return std::clamp(int(share * kCells), 0, kCells - 1);
}

}  // namespace

Json coverage_to_json(const ArmDescription& arm, const std::vector<Episode>& episodes) {
  Json json = {{"cells", kCells}, {"pairs", Json::array()}};
  const auto segments = int(arm.segments.size());
  for (int i = 0; i < segments; ++i) {
    for (int j = i + 1; j < segments && json["pairs"].size() < kMaxPairs; ++j) {
      std::vector<int> frames(std::size_t{kCells} * kCells, 0);
      const PressureLimits& across = arm.segments[i].pressure_limit_kpa;
      const PressureLimits& up = arm.segments[j].pressure_limit_kpa;
      for (const Episode& episode : episodes) {
        for (Eigen::Index t = 0; t < episode.pressure_kpa.rows(); ++t) {
          const int column = cell_of(double(episode.pressure_kpa(t, i)), across);
          const int row = cell_of(double(episode.pressure_kpa(t, j)), up);
          ++frames[row * kCells + column];
        }
      }
      json["pairs"].push_back({{"segments", {i, j}}, {"frames", frames}});
    }
  }
  return json;
}

}  // namespace limber
