#pragma once

#include <vector>

#include "limber/arm/arm_description.hpp"
#include "log_tracks.hpp"

namespace limber {

/// How the clocks of a motion log and a command log belong together.
struct ClockMatch {
  double offset_s = 0.0;     ///< motion clock − command clock: to be added to the commands' times
  double correlation = 0.0;  ///< there, in [−1, 1]
  double lag_s = 0.0;        ///< by which the arm follows its commands, each of two stages
  double runner_up = 0.0;    ///< the largest farther than a second from there
  double opposite = 0.0;     ///< the smallest anywhere: near −1 if signs are turned
};

/// Compares how fast each segment turns with how fast the no-load model would turn it under the
/// commands (where that model is straight: with how fast the command changes, whatever the sign).
/// Both are differences over 0.1 s, at 100 Hz; their normalised correlation, summed over the
/// segments, is searched over every offset that leaves an overlap of half of the shorter log, and
/// at least 5 s; a parabola through the peak gives fractions of 10 ms. An arm follows its commands
/// late: that lag, two stages of first order, is fitted along with the offset, so that it does not
/// end up in it.
ClockMatch match_clocks(const BackboneTrack& motion, const CommandTrack& commands,
                        const ArmDescription& arm);

/// The correlation of each segment, n numbers, where the clocks are `offset_s` apart; 0 if
/// nothing moves.
std::vector<double> segment_correlations(const BackboneTrack& motion, const CommandTrack& commands,
                                         const ArmDescription& arm, double offset_s);

}  // namespace limber
