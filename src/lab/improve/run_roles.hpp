#pragma once

#include <vector>

#include "limber/data/recording.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// What a recorded run is used for. It keeps its role in all later rounds.
enum class RunRole {
  training,
  validation,  ///< chooses the epoch
  held_back    ///< the finished model's error is measured on it
};

/// Of run `index` of a recording: of ten runs one validates and two are held back, and of as few as
/// three there is one of each.
RunRole role_of(int index);

/// What a round learns from: its own runs and those of the rounds before it, by their roles.
/// `data.unseen` is never trained on, and chooses nothing.
struct RoundData {
  TrainingData data;
  int chains = 0;  ///< of plans so far: roles go on where those of the last round ended

  /// Exploration: every episode as it is.
  void add_exploration(const std::vector<Episode>& episodes);
  /// Executed plans: episodes that begin at rest, and whose motions are the plans.
  void add_plans(const std::vector<Episode>& episodes, double frame_period_s);
  /// Runs that made a round's figures: the errors of later rounds' models are measured on them too.
  void hold_back(const std::vector<Episode>& plans, const std::vector<Episode>& motions,
                 double frame_period_s);
};

/// Executed plans as motions from rest: the frames before the first, in which the arm stood still
/// (docs/improving.md), are added, so that the model's error is measured over the whole of it.
Episode as_motions_from_rest(const Episode& plans, double frame_period_s);

}  // namespace limber
