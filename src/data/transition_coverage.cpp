#include <cmath>
#include <optional>
#include <set>

#include "limber/arm/pressure_limits.hpp"
#include "limber/data/reach.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

namespace {

/// A configuration at the end of a motion.
struct Corner {
  std::vector<int> states;  ///< of each segment, as corner_kpa has them
  bool reached = false;
};

/// None if a set point is neither off nor full.
std::optional<int> state_at(double setpoint_kpa, const PressureLimits& limits) {
  for (const int state : {1, 2, 0}) {
    if (std::abs(setpoint_kpa - corner_kpa(limits, state)) <=
        kReachTolerance * limits.largest_kpa()) {
      return state;
    }
  }
  return std::nullopt;
}

/// None if a segment is at no state.
std::optional<Corner> corner_at(const Episode& episode, Eigen::Index frame,
                                const std::vector<PressureLimits>& limits_kpa) {
  Corner corner;
  corner.reached = true;
  for (std::size_t s = 0; s < limits_kpa.size(); ++s) {
    const auto column = static_cast<Eigen::Index>(s);
    const double setpoint_kpa = episode.setpoint_kpa(frame, column);
    const double tolerance_kpa = kReachTolerance * limits_kpa[s].largest_kpa();
    const std::optional<int> state = state_at(setpoint_kpa, limits_kpa[s]);
    if (!state) {
      return std::nullopt;
    }
    corner.states.push_back(*state);
    corner.reached &= std::abs(episode.pressure_kpa(frame, column) - setpoint_kpa) <= tolerance_kpa;
  }
  return corner;
}

}  // namespace

TransitionCoverage transition_coverage(const Recording& recording,
                                       const std::vector<PressureLimits>& limits_kpa) {
  using Transition = std::pair<std::vector<int>, std::vector<int>>;
  std::set<Transition> attempted;
  std::set<Transition> covered;
  for (const Episode& episode : recording.episodes) {
    // Frame 0 stands for the configuration that the first motion leaves.
    std::optional<Corner> from = corner_at(episode, 0, limits_kpa);
    for (int t = 1; t < episode.frame_count(); ++t) {
      const auto frame = static_cast<std::size_t>(t);
      const bool ends = t + 1 == episode.frame_count() ||
                        episode.motion_index[frame + 1] != episode.motion_index[frame];
      if (!ends) {
        continue;
      }
      std::optional<Corner> to = corner_at(episode, t, limits_kpa);
      if (from && to) {
        attempted.insert({from->states, to->states});
        if (from->reached && to->reached) {
          covered.insert({from->states, to->states});
        }
      }
      from = std::move(to);
    }
  }
  TransitionCoverage result;
  result.possible = std::pow(9.0, static_cast<double>(limits_kpa.size()));
  result.attempted = static_cast<std::int64_t>(attempted.size());
  result.covered = static_cast<std::int64_t>(covered.size());
  return result;
}

}  // namespace limber
