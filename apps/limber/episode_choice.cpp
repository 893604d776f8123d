#include "episode_choice.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

void NamedEpisodes::add(const std::string& file, std::vector<Episode> more) {
  for (std::size_t i = 0; i < more.size(); ++i) {
    names.push_back(fmt::format("{}, {}", file, episode_name(i)));
    episodes.push_back(std::move(more[i]));
  }
}

EpisodeChoice choose_episodes(const ArmDescription& arm, NamedEpisodes all,
                              NamedEpisodes validation, const EpisodeShares& shares,
                              std::uint64_t seed) {
  const std::size_t own = all.episodes.size();
  std::ranges::move(validation.episodes, std::back_inserter(all.episodes));
  std::ranges::move(validation.names, std::back_inserter(all.names));
  const EpisodeErrors errors = episode_errors(arm, all.episodes);
  validation.episodes.assign(std::make_move_iterator(all.episodes.begin() + std::ptrdiff_t(own)),
                             std::make_move_iterator(all.episodes.end()));
  all.episodes.resize(own);
  EpisodeChoice choice;
  for (const int number : errors.outliers()) {
    const EpisodeError& episode = errors.episodes[static_cast<std::size_t>(number)];
    choice.broken.push_back(fmt::format("{} ({:.1f} cm, correlation {:.2f}; usual are {:.1f} cm)",
                                        all.names[static_cast<std::size_t>(number)], episode.tip_cm,
                                        episode.correlation, errors.median_cm));
  }
  std::vector<int> validating;
  if (validation.episodes.empty()) {
    choice.data = hold_back_validation(std::move(all.episodes), shares.validation, seed);
    hold_back_unseen(choice.data, shares.unseen, seed);
    validating = choice.data.held_back;
  } else {
    choice.data.training = std::move(all.episodes);
    hold_back_unseen(choice.data, shares.unseen, seed);
    choice.data.validation = std::move(validation.episodes);
    for (std::size_t i = own; i < all.names.size(); ++i) {
      validating.push_back(static_cast<int>(i));
    }
  }
  std::vector<bool> broken;
  for (const int number : validating) {
    broken.push_back(errors.episodes[static_cast<std::size_t>(number)].is_outlier);
  }
  leave_out_broken(choice.data, broken);
  const bool all_broken = std::ranges::find(broken, false) == broken.end();
  for (std::size_t i = 0; i < validating.size(); ++i) {
    if (!broken[i] || all_broken) {
      choice.validation.push_back(all.names[static_cast<std::size_t>(validating[i])]);
    }
  }
  return choice;
}

std::string prediction_error_line(const CompensationModel& model, bool has_unseen) {
  if (model.prediction_error) {
    return to_text(*model.prediction_error);
  }
  return has_unseen ? "the model's error could not be measured: its predictions diverge, or the "
                      "arm was not tracked often enough"
                    : "no motions were left to measure the "
                      "model's error on; give --unseen RECORDING";
}

}  // namespace limber
