#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "limber/network/prediction_error.hpp"

namespace limber {

// What no scale of a tube is below: the certificate's deviation is no smaller.
inline constexpr double kMinScaleM = 1e-4;
inline constexpr double kMinScaleRad = 1e-3;

/// How far an arm was from its prediction over a motion (docs/tube.md, (1)).
struct MotionErrors {
  /// Largest over the motion's frames, one per plate, each over the share of its room that the
  /// plate has there.
  std::vector<double> plate_m;
  double end_m = 0.0;  ///< of the tip at the end, after the hold
  double end_heading_rad = 0.0;
};

/// Share of its room that a plate has where it starts, to choose from: 1 is a tube that does not
/// grow.
inline constexpr std::array kStartShares{0.4, 0.7, 1.0};

/// (2) of docs/tube.md with one of them.
RoomGrowth growth_of(std::size_t candidate, double arm_length_m);

/// A motion's errors as tubes see them that grow by each of kStartShares.
struct GrowingErrors {
  std::array<MotionErrors, kStartShares.size()> of;
  std::array<double, kStartShares.size()> tip_share{};  ///< mean over frames of what the tip has
};

/// Of each motion, as a tube sees them that grows by that candidate.
std::vector<MotionErrors> errors_of(const std::vector<GrowingErrors>& motions,
                                    std::size_t candidate);

/// Shape of a tube, without levels (docs/tube.md, (3)): what most of the motions stay below.
/// @param motions  at least one, all of one arm, with that growth
Tube tube_shape(const std::vector<MotionErrors>& motions, const RoomGrowth& growth);

/// The largest of a motion's errors over their scales, of the plates alone. @pre sizes agree
double score_of(const std::vector<double>& plate_m, const std::vector<double>& plate_scale_m);

struct GrowingTube {
  std::size_t candidate = 0;  ///< of kStartShares
  Tube tube;                  ///< with one level, which speaks of the plates alone
};

/// The tube of Tube::kDefaultLevel that is narrowest at the tip, on average over frames, of those
/// that grow by kStartShares: their shape is of the first half of the motions, their factor of the
/// second. @param motions  at least two
GrowingTube narrowest_tube(const std::vector<GrowingErrors>& motions, double arm_length_m);

}  // namespace limber
