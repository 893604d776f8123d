#include "plan_changes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace limber {

namespace {

constexpr double kMaxShift = 0.3;  // standard deviation, of the limit
constexpr double kMinShift = 0.002;
constexpr std::uint32_t kMaxLeftOut = 4;
constexpr double kSplitShare = 0.1;  // of the changes

}  // namespace

Waypoints without_some(Waypoints waypoints_kpa, RandomStream& random) {
  const auto inner = std::uint32_t(waypoints_kpa.size()) - 2;
  const std::uint32_t first = 1 + random.index(inner);
  const std::uint32_t max_count = inner + 1 - first;
  const std::uint32_t count = 1 + random.index(std::min(max_count, kMaxLeftOut));
  waypoints_kpa.erase(waypoints_kpa.begin() + first, waypoints_kpa.begin() + first + count);
  return waypoints_kpa;
}

Waypoints straightened(Waypoints waypoints_kpa, RandomStream& random) {
  const auto count = std::uint32_t(waypoints_kpa.size());
  const std::uint32_t first = random.index(count - 2);
  const std::uint32_t last = first + 2 + random.index(count - first - 2);
  const auto segment = Eigen::Index(random.index(std::uint32_t(waypoints_kpa.front().size())));
  const float from = waypoints_kpa[first][segment];
  const float to = waypoints_kpa[last][segment];
  for (std::uint32_t i = first + 1; i < last; ++i) {
    waypoints_kpa[i][segment] = from + (to - from) * float(i - first) / float(last - first);
  }
  return waypoints_kpa;
}

Pressures random_shift(const ChangeSpace& space, RandomStream& random) {
  const double scale = kMinShift * std::pow(kMaxShift / kMinShift, random.uniform());
  const auto n = std::uint32_t(space.scale_kpa.size());
  const std::uint32_t only = random.index(2 * n);  // ≥ n: all of them
  Pressures shift = Pressures::Zero(space.scale_kpa.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    if (only >= n || only == i) {
      shift[i] = float(random.normal() * scale) * space.scale_kpa[i];
    }
  }
  return shift;
}

Waypoints with_end_shifted(Waypoints waypoints_kpa, const ChangeSpace& space,
                           const Pressures& shift_kpa) {
  const auto last = float(waypoints_kpa.size() - 1);
  for (std::size_t i = 1; i < waypoints_kpa.size(); ++i) {
    waypoints_kpa[i] = space.box.limited(waypoints_kpa[i] + shift_kpa * (float(i) / last));
  }
  return waypoints_kpa;
}

Waypoints split(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random) {
  if (waypoints_kpa.size() >= kMaxWaypoints) {
    return waypoints_kpa;
  }
  const std::uint32_t i = random.index(std::uint32_t(waypoints_kpa.size()) - 1);
  const auto share = float(random.uniform(0.2, 0.8));
  const Pressures between = waypoints_kpa[i] + share * (waypoints_kpa[i + 1] - waypoints_kpa[i]);
  waypoints_kpa.insert(waypoints_kpa.begin() + i + 1, space.box.limited(between));
  return waypoints_kpa;
}

Waypoints changed(Waypoints waypoints_kpa, const ChangeSpace& space, RandomStream& random) {
  // An added waypoint alone changes no cost: it comes with a change of the rest.
  if (random.uniform() < kSplitShare) {
    waypoints_kpa = split(std::move(waypoints_kpa), space, random);
  }
  const bool has_inner = waypoints_kpa.size() > 2;
  switch (const std::uint32_t kind = random.index(4)) {
    case 0:
    case 1:
      if (has_inner) {
        return kind == 0 ? without_some(std::move(waypoints_kpa), random)
                         : straightened(std::move(waypoints_kpa), random);
      }
      [[fallthrough]];
    case 2:
      return with_end_shifted(std::move(waypoints_kpa), space, random_shift(space, random));
    default: {  // one waypoint is moved, the end perhaps
      const std::size_t i = 1 + random.index(std::uint32_t(waypoints_kpa.size()) - 1);
      waypoints_kpa[i] = space.box.limited(waypoints_kpa[i] + random_shift(space, random));
      return waypoints_kpa;
    }
  }
}

}  // namespace limber
