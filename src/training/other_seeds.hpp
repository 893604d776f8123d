#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "limber/common/random_stream.hpp"
#include "limber/training/trainer.hpp"

namespace limber {

inline constexpr int kMostOtherSeeds = 3;  // two networks of 64 from 20 minutes ran away, with one

/// Trains; where a long rollout of the network runs away (LongRollout::bounded), again with other
/// seeds, until one does not. Where all do, the first one stays. The network that is taken names
/// the seeds that were passed over. What is trained again leaves no checkpoint: it takes as long as
/// the first, whose checkpoint stays.
/// @param train_with  settings to TrainingResult
template <class TrainWith>
TrainingResult train_until_bounded(const TrainWith& train_with, TrainingSettings settings) {
  constexpr std::uint64_t kOtherSeeds = 0x6f746865725f7365;
  const auto is_done = [](const TrainingResult& result) {
    return result.status != TrainingStatus::finished || result.long_rollout.frames == 0 ||
           result.long_rollout.bounded;
  };
  TrainingResult first = train_with(settings);
  RandomStream seeds(settings.seed, kOtherSeeds);
  std::string passed_over = std::to_string(settings.seed);
  settings.checkpoint.clear();
  settings.resume = false;
  for (int i = 0; i < kMostOtherSeeds && !is_done(first); ++i) {
    settings.seed = seeds.next_u32();
    TrainingResult other = train_with(settings);
    if (other.status == TrainingStatus::interrupted) {
      first.status = other.status;
    } else if (other.status == TrainingStatus::finished && is_done(other)) {
      other.model.training["passed_over_seeds"] = passed_over;
      other.wall_time_s += first.wall_time_s;
      return other;
    }
    passed_over += " " + std::to_string(settings.seed);
  }
  return first;
}

}  // namespace limber
