#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/json.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

inline constexpr int kFolds = 4;

/// A way to learn, and what it is worth: mean errors at the tip on episodes that the networks had
/// not seen, one step ahead, and over rollouts of 32 and of up to 600 frames. Infinite where one of
/// them diverged; 0 where the arm was tracked too rarely to measure it.
struct WayTried {
  int epochs = 0;
  std::vector<int> hidden_units;
  Optimiser optimiser = Optimiser::adam;
  int folds = 0;  ///< networks; fewer than kFolds where one was worse than another's, or diverged
  double one_step_cm = 0.0;
  double window_32_cm = 0.0;
  double window_600_cm = 0.0;
  /// What decides: the mean, as of factors, of those that were measured; 0 if none was.
  double score_cm() const {
    double product = 1.0;
    int measured = 0;
    for (const double error_cm : {one_step_cm, window_32_cm, window_600_cm}) {
      if (error_cm > 0.0) {
        product *= error_cm;
        ++measured;
      }
    }
    return measured > 0 ? std::pow(product, 1.0 / measured) : 0.0;
  }
  bool operator==(const WayTried&) const = default;
};

/// How to learn from a recording, and how wrong one is that learnt from it
/// (docs/training.md, Learning from little).
struct CrossValidation {
  std::string identity;  ///< folds_identity of what it was found for
  int folds = 0;
  std::vector<WayTried> tried;
  int chosen = 0;                                   ///< index in `tried`
  std::optional<PredictionError> prediction_error;  ///< of the chosen networks' runs
  std::optional<Tube> tube;                         ///< of the same runs
  std::string widest_where;                         ///< RunErrors::widest_where of them
  const WayTried& best() const { return tried[chosen]; }
  int epochs() const { return best().epochs; }
  bool operator==(const CrossValidation&) const = default;
};

/// Whether so little was recorded that nothing of it should be held back: at most an hour, of which
/// enough moves for kFolds folds.
bool is_little(const ArmDescription& arm, const std::vector<Episode>& episodes);

/// The default preset as it learns from little: early frames of a window count more still. It says
/// no hidden units, which cross-validation then chooses.
TrainingSettings preset_for_little();

/// Hash of what decides `cross_validate`.
std::string folds_identity(const ArmDescription& arm, const std::vector<Episode>& episodes,
                           const TrainingSettings& settings);

/// Deals the episodes that move to kFolds folds of about equal length (long ones are cut where
/// there are few), and trains a network for each fold on all that is not in it. What rests is
/// learnt from in all of them, and judges none. So in several ways: one wide layer learns less
/// noise than three, and SOAP more than Adam where it does not diverge. After the first fold only
/// ways that are nearly as good as the best go on. Depends on data, settings and seed, not on
/// threads.
/// @param settings  of each run; its checkpoint, ensemble, epochs and keep_epoch are not used. With
/// hidden units, networks have those
/// @param valves  of the recording, before the network; PredictionError is about set points
/// @throws InputError as `train`, and where no fold's network is finite; Interrupted on Ctrl-C, or
/// where hooks.should_stop says so.
CrossValidation cross_validate(const ArmDescription& arm, const std::vector<Episode>& episodes,
                               const TrainingSettings& settings, const IdentifiedValves& valves,
                               const TrainingHooks& hooks = {});

/// After the chosen way diverged on everything: chooses the best of the others, of those with all
/// folds if there are some. Their networks carry no error. @returns false where none is left.
[[nodiscard]] bool take_another_way(CrossValidation& found);

/// One network that learns from all `episodes`, in the way that `found` says; it carries its valves
/// and what it has learnt and, if it was trained to the end, the folds' error.
[[nodiscard]] TrainingResult train_on_everything(const ArmDescription& arm,
                                                 const std::vector<Episode>& episodes,
                                                 const TrainingSettings& settings,
                                                 const IdentifiedValves& valves,
                                                 const CrossValidation& found,
                                                 const TrainingHooks& hooks = {});

/// The object `cross_validation` of `train --json`, and of the file by which a stopped run goes on.
Json to_json(const CrossValidation& found);
/// @throws InputError naming `where` and the field.
CrossValidation read_cross_validation(const std::string& text, const std::string& where);
/// For people, and for the model's record.
std::string to_text(const CrossValidation& found);

}  // namespace limber
