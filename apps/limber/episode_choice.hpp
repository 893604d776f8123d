#pragma once

#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

/// Episodes of several files, and what messages call each: "train.h5, episode 3".
struct NamedEpisodes {
  std::vector<Episode> episodes;
  std::vector<std::string> names;

  /// @param file  without its folder
  void add(const std::string& file, std::vector<Episode> more);
};

/// Of the frames: what chooses the epoch, and what the finished model is measured on.
struct EpisodeShares {
  double validation = 0.1;
  double unseen = 0.1;  ///< 0: none
};

/// What is trained on, and which episodes choose the epoch.
struct EpisodeChoice {
  TrainingData data;
  std::vector<std::string> validation;  ///< names of those that validate
  std::vector<std::string> broken;      ///< of all episodes, with their errors
};

/// Takes out of both those in which the arm does not do what it does in the others
/// (`episode_errors` of all of them together). @return their names, and what is wrong with them
std::vector<std::string> leave_out_broken(const ArmDescription& arm, NamedEpisodes& all,
                                          NamedEpisodes& validation);

/// Holds back for validation and for the model's error.
/// @param validation  what validates; where there is none, episodes are held back.
/// @throws InputError as `hold_back_validation`.
EpisodeChoice choose_episodes(NamedEpisodes all, NamedEpisodes validation,
                              const EpisodeShares& shares, std::uint64_t seed);

}  // namespace limber
