#pragma once

#include <vector>

#include "limber/training/trainer.hpp"

namespace limber {

/// The numbers of the episodes of each slice, which rise: one partition of all of them per seed and
/// epoch, in parts of about equally many frames. One empty slice where there are no episodes.
std::vector<std::vector<int>> slices_of(const SlicedEpisodes& episodes, std::uint64_t seed,
                                        int epoch);

/// A random share of the training data as small as a slice: all of them where they are in memory.
std::vector<Episode> training_sample(const TrainingData& data);

}  // namespace limber
