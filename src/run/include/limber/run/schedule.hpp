#pragma once
// For those who move an arm, real or virtual.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"

namespace limber {

enum class ScheduleKind {
  transitions,  ///< between configurations whose segments are fully right, fully left or off
  random        ///< between configurations sampled uniformly within ± each segment's limit
};

/// How set points go from one configuration to the next.
enum class Approach {
  step,     ///< they jump; each valve ramps its own segment at its own rate, as in the paper
  straight  ///< all move together along the straight line in pressure space, as fast as the
            ///< arm's step limit per frame allows: as a plan's edges do
};

struct ScheduleSettings {
  ScheduleKind kind = ScheduleKind::transitions;
  int count = 0;  ///< motions: of each episode (random, ≥ 1), or in all (transitions, 0: every one)
  int episodes = 0;  ///< 0: 16 for transitions, 1 for random; fixed, so that results don't depend
                     ///< on the number of threads
  Approach approach = Approach::step;
  double hold_s = 3.0;  ///< how long a motion's final set point is commanded, > 0
  /// If set, each hold is sampled uniformly from [hold_min_s, hold_s], and motions may be cut short
  /// as those of a plan are. If not, a motion also lasts until its measured pressures have arrived.
  std::optional<double> hold_min_s = {};
  /// Set points stay within so many times the segments' limits, in (0, 1].
  double limit_scale = 1.0;
};

/// The minute that tells most about which arm it is (docs/families.md): 36 random motions, in space
/// 68 shorter ones, straight and with short holds.
ScheduleSettings identifying_schedule(Dimension dimension);

struct Motion {
  Pressures setpoint_kpa;      ///< size n, where it ends
  double hold_s = 0.0;         ///< at least this long at that set point
  bool until_reached = false;  ///< and until the measured pressures are there
  /// Passed on the way without a halt, straight from one to the next; with `straight` alone.
  std::vector<Pressures> via_kpa = {};
};

/// One unbroken run. Before it, the arm is led from rest to `first_kpa`; this is not recorded.
struct EpisodeSchedule {
  Pressures first_kpa;  ///< zero: from rest, nothing to lead to
  std::vector<Motion> motions;
  Approach approach = Approach::step;  ///< of every motion
};

/// Transitions: all (3^n)² ordered ones, each exactly once, as an Eulerian walk of the complete
/// directed graph with self-loops. `seed` decides its order, and it is cut into episodes. With
/// `count`, the first ones of that walk (above 6 channels, where the walk would be huge, a random
/// walk).
/// Random: `count` motions in each of `episodes` episodes, from rest.
/// @throws InputError if a number is out of its range, or where n > 3 and no count is given
/// (with the time that all transitions would take).
std::vector<EpisodeSchedule> make_schedule(const ArmDescription& arm,
                                           const ScheduleSettings& settings, std::uint64_t seed);

/// The settings in one line, "transitions, all, step, hold 3 s and until reached": equal
/// lines and seeds give equal schedules.
std::string describe(const ScheduleSettings& settings);

/// Of each channel: 0 off, 1 fully right, 2 fully left.
using CornerStates = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, 1>;

/// The configuration of these states, size n. A segment or chamber whose limits leave it one side
/// takes half of that one instead of the other.
Pressures corner_configuration(const ArmDescription& arm,
                               const Eigen::Ref<const CornerStates>& states);

}  // namespace limber
