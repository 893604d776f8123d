#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Transitions between configurations whose segments are fully right, fully left or off.
struct TransitionCoverage {
  double possible = 0.0;       ///< (3^n)²; exact for n ≤ 16
  std::int64_t attempted = 0;  ///< different ones that were commanded
  std::int64_t covered = 0;    ///< of those, with both ends reached (data/reach.hpp); all of them
                               ///< where nothing was measured
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
  std::string log;  ///< that this episode came from; empty: of none
  int frame = 0;
  std::string first;  ///< the numbers of the first one
};

/// How far the tip is from where the simple model, fitted to all episodes, expects it.
struct EpisodeError {
  std::string name;          ///< "episode 7", with the log that it came from
  double tip_cm = 0.0;       ///< mean over the tracked frames; NaN where there are none
  double correlation = 0.0;  ///< of levels: turns with what the commands say, mean over segments
  bool moves = false;        ///< or should, by what it was told; one that rests is not judged
  bool is_outlier = false;
  std::string why;  ///< it is one, in words; else empty
};

/// The simple model's error in every episode. One that is far above the others' was broken, and so
/// was one that errs more than the middle one and does nothing of what it was told: a log of
/// another trial, a tracker that lost its bodies, a tube that came off. So was one that moves as if
/// its columns were exchanged, one of them had the other sign, or its commands came late or early.
struct EpisodeErrors {
  std::vector<EpisodeError> episodes;
  double median_cm = 0.0;
  double limit_cm = 0.0;  ///< above it an episode is an outlier; infinite for fewer than 5 episodes

  /// Numbers of the outliers, rising.
  std::vector<int> outliers() const;
};

/// @throws InputError as require_episodes_of, or where nothing was tracked.
EpisodeErrors episode_errors(const ArmDescription& arm, const std::vector<Episode>& episodes);

/// "episode 7: 12.3 cm, more than 9.1 cm" of every outlier, and what is usual; empty without one.
std::string to_text(const EpisodeErrors& errors);

/// Takes the outliers out of `episodes`; gives what was found of all of them.
EpisodeErrors leave_out_broken(const ArmDescription& arm, std::vector<Episode>& episodes);

/// Whether the tip goes anywhere, by more than a hundredth of the arm's length.
bool moves(const ArmDescription& arm, const Episode& episode);

/// What a recording holds and what is odd about it, though it is valid.
struct RecordingInspection {
  std::vector<PressureRange> pressures;    ///< one per segment
  std::vector<PressureLimits> limits_kpa;  ///< that coverage was judged by
  bool limits_known = false;               ///< from an arm file, not guessed from the set points
  TransitionCoverage transitions;
  std::vector<Suspicion> suspicions;
  IdentifiedValves valves;  ///< between its set points and its pressures
  /// None where neither `arm` nor the recording says what the arm is, or nothing was tracked.
  std::optional<EpisodeErrors> episode_errors;
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
                                       const std::vector<PressureLimits>& limits_kpa);

nlohmann::ordered_json to_json(const EpisodeErrors& errors);
nlohmann::ordered_json to_json(const Recording& recording, const RecordingInspection& inspection);
std::string to_text(const Recording& recording, const RecordingInspection& inspection);

}  // namespace limber
