#pragma once

#include <span>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/training_settings.hpp"
#include "limber/training/window_gradient.hpp"

namespace limber {

/// Frames of one episode within a table's columns.
struct EpisodeRange {
  int first = 0;
  int count = 0;
};

/// Episodes prepared for training: normalised columns, and where each episode lies.
struct TrainingTables {
  Normalisation input;   ///< 2n + D + N numbers
  Normalisation output;  ///< D numbers
  FrameTable<float> frames;
  StateMap<float> map;
  std::vector<EpisodeRange> episodes;
};

/// CompensationModel::past_commands of a network of `arm`.
std::vector<int> past_commands_of(const ArmDescription& arm, const TrainingSettings& settings);

/// Converts backbones to the settings' layout, measures ranges (constant columns get scale 1) and
/// normalises.
/// Frames in which the arm was not tracked tell nothing about ranges.
/// @param like  gives the normalisation in place of what is measured, and its map if it has one
/// @throws InputError if there is no frame, none was tracked, or no pressure ever changes.
TrainingTables make_training_tables(const ArmDescription& arm, const std::vector<Episode>& episodes,
                                    const TrainingSettings& settings,
                                    const TrainingTables* like = nullptr);

/// Has `tables.map` keep its states within `bounds`, by (20). @pre made for these settings
void set_bounds(TrainingTables& tables, const TrainingSettings& settings, const GapBounds& bounds);

/// First frames of windows of `window_frames` predicted frames that do not overlap; each episode's
/// first window begins `shift` frames after its start, or less where it would not fit. A window
/// begins at a frame in which the arm was tracked, and has at least one more such.
/// @param tracked  FrameTable::tracked; empty: always.
std::vector<int> window_starts(std::span<const EpisodeRange> episodes,
                               std::span<const std::uint8_t> tracked, int window_frames, int shift);

}  // namespace limber
