#pragma once

#include "limber/arm/arm_description.hpp"
#include "log_rows.hpp"

namespace limber {

/// How the clocks of a motion log and a command log belong together.
struct ClockMatch {
  double offset_s = 0.0;     ///< motion clock − command clock: to be added to the commands' times
  double correlation = 0.0;  ///< there, in [−1, 1]
  double lag_s = 0.0;        ///< by which the arm follows its commands, each of two stages
  double runner_up = 0.0;    ///< the largest outside of that peak
  double opposite = 0.0;     ///< the smallest anywhere: near −1 where signs are turned
  double opposite_offset_s = 0.0;  ///< where that is

  /// Whether the offset is beyond doubt: it correlates, and no other does nearly as well.
  bool is_decisive() const;
};

/// Compares how fast each segment turns with how fast the no-load model would turn it under the
/// commands (where that model is straight: with how fast the command changes, whatever the sign).
/// Both are differences, at 100 Hz, over 0.1 s; where those are not decisive, over 0.5 s and over
/// 2 s, which tell slow motions from noise. Their normalised correlation, summed over the segments,
/// is searched over every offset that leaves an overlap of half of the shorter log, and at least
/// 5 s; a parabola through the peak gives fractions of 10 ms. An arm follows
/// its commands late: that lag, two stages of first order, is fitted along with
/// the offset, so that it does not end up in it.
ClockMatch match_clocks(const BackboneTrack& motion, const CommandTrack& commands,
                        const ArmDescription& arm);

/// The offset at which as much moves in both logs, whichever segment and to whichever side: for
/// logs whose columns are permuted or mirrored, where nothing else can be compared yet.
double offset_by_activity(const BackboneTrack& motion, const CommandTrack& commands,
                          const ArmDescription& arm);

}  // namespace limber
