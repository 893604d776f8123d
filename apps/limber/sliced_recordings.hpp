#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "episode_choice.hpp"

namespace limber {

/// A family's recordings without their frames.
struct OutlinedRecordings {
  /// Of an episode.
  struct Place {
    std::string path;
    int number = 0;  ///< in that file
  };

  NamedEpisodes all;  ///< times and texts (read_recording_outline)
  std::vector<Place> places;
  std::vector<int> arms;  ///< add_arms_of
};

OutlinedRecordings outline_recordings(const ArmDescription& arm,
                                      const std::vector<std::string>& paths);

/// What hold_back_arms() makes of them: the episodes that validate are read, and all others are
/// TrainingData::slices.
/// @param reader  reads them, and must live as long as that; the files are noted as its sources.
EpisodeChoice choose_sliced(OutlinedRecordings outlines, double fraction, std::uint64_t seed,
                            EpisodeReader& reader);

}  // namespace limber
