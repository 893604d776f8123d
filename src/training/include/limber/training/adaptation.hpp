#pragma once
// For those who train and evaluate models.

#include <cstdint>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// When `adapt` changes weights, beside e.
enum class AdaptWeights {
  automatic,  ///< where the family does not contain the arm, episodes are long enough to learn
              ///< from, and if that is better
  never,
};

struct AdaptationSettings {
  AdaptWeights weights = AdaptWeights::automatic;
  /// On seconds held back, by a second fit without them: half of the time. False: weights are not
  /// trained, and the model has no `prediction_error`.
  bool measures_errors = true;
  std::uint64_t seed = 1;  ///< of training weights
  int jobs = 0;            ///< threads, 0: one per core; never changes a result
};

/// What became of a family's network, and what its recording told. Errors are those of the tip over
/// the seconds held back, open loop, never corrected, in metres; they are the end of the recording,
/// a fifth of it. The model itself is then fitted to everything.
struct Adaptation {
  CompensationModel model;           ///< of this arm, an ordinary one
  double seconds = 0.0;              ///< recorded, tracked or not
  double moving_s = 0.0;             ///< … in which a plate moved by over 1 mm a frame
  double held_back_s = 0.0;          ///< 0: too little was recorded, or tracked, to hold some back
  double middle_error_m = 0.0;       ///< of the family's middle; these three NaN without held back
  double fitted_error_m = 0.0;       ///< of e alone
  double trained_error_m = 0.0;      ///< with weights; NaN where none were trained
  double family_error_m = 0.0;       ///< of arms of the family, after kFitFrames; NaN: not known
  double distance = 0.0;             ///< |e| / √k, about 1 for an arm of the family
  double distance_to_nearest = 0.0;  ///< the same from the nearest arm that it learnt from
  double uncertainty = 0.0;          ///< share of the family's spread that is left, 0 to 1
  double largest_uncertainty = 0.0;  ///< … of what the recording tells least about
  /// Of the tip, as far as the fit can tell: what it left, and what e's uncertainty makes of it.
  /// The width of the model's tube, where the family has one, is in proportion.
  double expected_error_m = 0.0;
  bool has_trained_weights = false;   ///< `model` has weights of its own
  std::vector<TraitEstimate> traits;  ///< what e tells of its physics, beside the arm's file
  bool is_of_family() const { return distance <= kFarFromFamily && !has_trained_weights; }
  /// The arm hardly moved, or some direction of e is hardly better known than before.
  bool tells_too_little() const { return moved_too_little() || largest_uncertainty > kHardlyKnown; }
  bool moved_too_little() const { return moving_s < kLeastMovingS; }

  static constexpr double kFarFromFamily = FamilyMember::kFar;
  static constexpr double kLeastMovingS = 4.0;
  static constexpr double kHardlyKnown = 0.7;
};

/// Makes a family's network one arm's, from seconds of that arm's motion (docs/families.md): e by
/// least squares, the valves between set points and pressures, and the error on seconds held back.
/// Of a family with a tube, the model has one, unless its weights were trained.
/// @throws InputError if the model is of no family, or the episodes are another arm's, too short,
/// or without a tracked frame; Interrupted on Ctrl-C.
[[nodiscard]] Adaptation adapt(const ArmDescription& arm, const CompensationModel& family,
                               const std::vector<Episode>& episodes,
                               const AdaptationSettings& settings = {});

}  // namespace limber
