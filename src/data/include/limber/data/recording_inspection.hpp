#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_findings.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Transitions between configurations whose segments are fully right, fully left or off.
struct TransitionCoverage {
  double possible = 0.0;       ///< (3^n)²; exact for n ≤ 16
  std::int64_t attempted = 0;  ///< different ones that were commanded
  std::int64_t covered = 0;    ///< of those, with both ends reached (data/reach.hpp)
};

/// Measured pressures and set points of one segment.
struct PressureRange {
  double lowest_kpa = 0.0;
  double highest_kpa = 0.0;
  double lowest_setpoint_kpa = 0.0;
  double highest_setpoint_kpa = 0.0;
};

/// A kind of suspicion, how often it came up, and where first.
struct Suspicion {
  std::string what;  ///< "a heading that jumps by a full turn: is it wrapped?"
  std::int64_t count = 0;
  int episode = 0;  ///< of the first one
  int frame = 0;
  std::string first;  ///< the numbers of the first one
};

/// What a recording holds, and what is odd about it although it is valid.
struct RecordingInspection {
  std::vector<PressureRange> pressures;  ///< one per segment
  std::vector<double> limits_kpa;        ///< that coverage was judged by
  bool limits_known = false;             ///< from an arm file, not guessed from the set points
  TransitionCoverage transitions;
  std::vector<Suspicion> suspicions;
  IdentifiedValves valves;  ///< between its set points and its pressures
};

/// @param arm  gives the limits; null: the largest set point of each segment stands for its
/// limit.
/// @throws InputError if the recording does not fit `arm`.
RecordingInspection inspect(const Recording& recording, const ArmDescription* arm,
                            const std::string& file);

/// A sentence if the base plate of an episode does not lie at the origin of frame B: on average
/// farther than 2 mm away or turned by more than 0.01 rad. Empty if every one does.
std::string base_warning(const Recording& recording);

TransitionCoverage transition_coverage(const Recording& recording,
                                       const std::vector<double>& limits_kpa);

nlohmann::ordered_json to_json(const Recording& recording, const RecordingInspection& inspection);
std::string inspection_to_text(const Recording& recording, const RecordingInspection& inspection);

}  // namespace limber
