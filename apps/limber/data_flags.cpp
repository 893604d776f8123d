#include "data_flags.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "episode_choice.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/data/recording_part.hpp"
#include "limber/training/cross_validation.hpp"
#include "limber/training/episode_slices.hpp"

namespace limber {

fs::path folds_path_of(const fs::path& checkpoint) {
  return checkpoint.string() + ".folds.json";
}

namespace {

/// A family's recordings without their frames.
struct OutlinedRecordings {
  /// Of an episode.
  struct Place {
    std::string path;
    int number = 0;  ///< in that file
  };

  NamedEpisodes all;  ///< times and texts (read_recording_outline)
  std::vector<Place> places;
  std::vector<int> arms;            ///< add_arms_of
  std::vector<std::string> broken;  ///< which are not among them
};

using Place = OutlinedRecordings::Place;

/// The episodes at these of the places, whose numbers rise: file after file.
std::vector<Episode> read_at(const std::vector<Place>& places, std::span<const int> which,
                             EpisodeReader& reader) {
  std::vector<Episode> episodes;
  for (std::size_t first = 0; first < which.size();) {
    const std::string& path = places[which[first]].path;
    std::vector<int> numbers;
    for (; first < which.size(); ++first) {
      const Place& place = places[which[first]];
      if (place.path != path) {
        break;
      }
      numbers.push_back(place.number);
    }
    std::ranges::move(reader.read_part(path, numbers), std::back_inserter(episodes));
  }
  return episodes;
}

/// Without twins and, unless `keep_broken`, broken episodes. Only files of one arm are read for
/// them: what differs from episode to episode, virtual arms do, has no others to compare with.
OutlinedRecordings outline_recordings(const CommonFlags& flags, const ArmDescription& arm,
                                      const std::vector<std::string>& paths, bool keep_broken,
                                      EpisodeReader& reader) {
  OutlinedRecordings outlines;
  for (const std::string& path : paths) {
    Recording one = read_recording_outline(path);
    require_sizes_of(one, arm, path);
    reader.note_source(path);
    std::vector<int> arms = outlines.arms;
    add_arms_of(one, arms);
    NamedEpisodes all;
    all.add(path, std::move(one.episodes));
    NamedEpisodes kept;
    const std::size_t first = outlines.arms.size();
    const bool is_one_arm = arms[first] == std::ranges::max(arms);
    if (is_one_arm) {
      kept.add(path, reader.read_part(path, {}));
      leave_out_twins(flags, kept);
    }
    if (is_one_arm && !keep_broken) {
      std::ranges::move(leave_out_broken(arm, {&kept}), std::back_inserter(outlines.broken));
    }
    for (std::size_t i = 0; i < all.names.size(); ++i) {
      if (!is_one_arm || std::ranges::find(kept.names, all.names[i]) != kept.names.end()) {
        outlines.places.push_back({path, int(i)});
        outlines.arms.push_back(arms[first + i]);
        outlines.all.names.push_back(std::move(all.names[i]));
        outlines.all.episodes.push_back(std::move(all.episodes[i]));
      }
    }
  }
  return outlines;
}

/// What hold_back_arms() makes of them: the episodes that validate are read, and all others are
/// TrainingData::slices.
/// @param reader  reads them, and must live as long as that
EpisodeChoice choose_sliced(OutlinedRecordings outlines, double fraction, std::uint64_t seed,
                            EpisodeReader& reader) {
  EpisodeChoice choice;
  TrainingData& data = choice.data;
  data = hold_back_arms(std::move(outlines.all.episodes), outlines.arms, fraction, seed);
  std::vector<Place> learnt;
  auto held = data.held_back.begin();
  for (int i = 0; i < int(outlines.places.size()); ++i) {
    if (held != data.held_back.end() && *held == i) {
      choice.validation.push_back(outlines.all.names[i]);
      ++held;
    } else {
      learnt.push_back(outlines.places[i]);
    }
  }
  data.validation = read_at(outlines.places, data.held_back, reader);
  for (const Episode& outline : data.training) {
    data.slices.frame_counts.push_back(outline.frame_count());
  }
  data.training.clear();
  data.slices.read = [places = std::move(learnt), &reader](std::span<const int> which) {
    return read_at(places, which, reader);
  };
  return choice;
}

constexpr double kUnseenShare = 0.1;
constexpr double kMostHeldBack = 100'000.0;  // frames of arms that validate: 200 of half a minute

void write_folds(const CrossValidation& found, const fs::path& checkpoint) {
  write_file_atomically(folds_path_of(checkpoint), to_json(found).dump(2) + "\n");
}

}  // namespace

void DataFlags::add_to(CLI::App& app) {
  app.add_option("--data", data_, "Recording to learn from; repeat for more")->required();
  app.add_option(
      "--validation", validation_,
      "Recording that chooses the best epoch; else whole episodes are held back, or, of "
      "an hour at most, four networks that each miss a quarter say when to stop, and one "
      "learns from everything");
  app.add_option("--unseen", unseen_,
                 "Recording for measuring the model's error, used neither for training nor for "
                 "choosing; else as for --validation");
  app.add_flag("--keep-broken", keep_broken_,
               "Learn also from episodes in which the arm does not do what it does in the others");
  app.add_flag("--setpoints", setpoints_,
               "Learn from set points alone, also where pressures "
               "were measured: for recordings of both kinds");
}

void DataFlags::add_old_data_to(CLI::App& app, CLI::Option* from) {
  app.add_option("--old-data", old_data_,
                 "Recording that --from was trained on: errors on it are shown before and after, "
                 "and it is replayed; repeat for more")
      ->needs(from);
}

EpisodeChoice DataFlags::load_old(const CommonFlags& flags, const ArmDescription& arm,
                                  EpisodeReader& reader) const {
  EpisodeChoice choice;
  if (!old_data_.empty()) {
    NamedEpisodes old = reader.read_all(old_data_);
    leave_out_twins(flags, old);
    if (!keep_broken_) {
      choice.broken = leave_out_broken(arm, {&old});
    }
    choice.data = hold_back_validation(std::move(old.episodes), kValidationShare, flags.seed);
  }
  return choice;
}

IdentifiedValves DataFlags::valves_of(const std::vector<Episode>& episodes,
                                      const ArmDescription& arm) const {
  const auto files = mapped<std::string>(
      data_, [&](const std::string& path) { return fs::path(path).filename().string(); });
  return identify_valves(episodes, arm, fmt::format("{}", fmt::join(files, ", ")));
}

EpisodeChoice DataFlags::load_arms(const CommonFlags& flags, const ArmDescription& arm,
                                   EpisodeReader& reader, int slice_frames,
                                   IdentifiedValves& valves) const {
  refuse_if(!validation_.empty() || !unseen_.empty(),
            "--family: leave out --validation and --unseen: whole arms are held back");
  OutlinedRecordings outlines = outline_recordings(flags, arm, data_, keep_broken_, reader);
  std::vector<std::string> broken = std::move(outlines.broken);
  const std::int64_t frames = frame_count(outlines.all.episodes);
  if (frames > slice_frames) {
    say(flags, "{} frames: each epoch reads them in slices of about {}, and none stays in memory",
        frames, slice_frames);
    const double share = std::min(kValidationShare, kMostHeldBack / double(frames));
    EpisodeChoice choice = choose_sliced(std::move(outlines), share, flags.seed, reader);
    choice.data.slices.slice_frames = slice_frames;
    choice.broken = std::move(broken);
    valves = valves_of(training_sample(choice.data), arm);
    return choice;
  }
  std::vector<int> every(outlines.places.size());
  std::iota(every.begin(), every.end(), 0);
  std::vector<Episode> episodes = read_at(outlines.places, every, reader);
  valves = valves_of(episodes, arm);
  EpisodeChoice choice;
  choice.broken = std::move(broken);
  choice.data = hold_back_arms(std::move(episodes), outlines.arms, kValidationShare, flags.seed);
  for (const int held : choice.data.held_back) {
    choice.validation.push_back(outlines.all.names[held]);
  }
  return choice;
}

NamedEpisodes DataFlags::load_validation(const CommonFlags& flags, EpisodeReader& reader) const {
  NamedEpisodes validation;
  if (!validation_.empty()) {
    validation.add(validation_, reader.read(validation_).episodes);
    if (reader.is_source(validation_)) {
      warn(flags,
           "--validation {} is learnt from too: the epoch is chosen, and its error "
           "reported, by what the network knows",
           validation_);
    }
  }
  return validation;
}

NamedEpisodes DataFlags::load_unseen(EpisodeReader& reader) const {
  NamedEpisodes unseen;
  if (!unseen_.empty()) {
    refuse_if(
        reader.is_source(unseen_) ||
            (!validation_.empty() && file_hash(unseen_) == file_hash(validation_)),
        "--unseen {}: learnt from, or validated on, too; the error on it would say too little",
        unseen_);
    unseen.add(unseen_, reader.read(unseen_).episodes);
  }
  return unseen;
}

std::vector<std::string> DataFlags::leave_out(const ArmDescription& arm, NamedEpisodes& all,
                                              NamedEpisodes& validation,
                                              NamedEpisodes& unseen) const {
  if (keep_broken_) {
    return {};
  }
  std::vector<std::string> broken = leave_out_broken(arm, {&all, &validation, &unseen});
  for (const auto& [flag, file, part] : {std::tuple{"--validation", &validation_, &validation},
                                         std::tuple{"--unseen", &unseen_, &unseen}}) {
    if (!file->empty() && part->episodes.empty()) {
      throw InputError(fmt::format(
          "{} {}: the arm does nothing there of what it does in --data ({}); --keep-broken takes "
          "it as it is",
          flag, *file, fmt::join(broken, "; ")));
    }
  }
  return broken;
}

EpisodeChoice DataFlags::load(const CommonFlags& flags, const ArmDescription& arm,
                              EpisodeReader& reader, bool may_be_little,
                              IdentifiedValves& valves) const {
  NamedEpisodes all = reader.read_all(data_);
  leave_out_twins(flags, all);
  NamedEpisodes validation = load_validation(flags, reader);
  NamedEpisodes unseen = load_unseen(reader);
  std::vector<std::string> broken = leave_out(arm, all, validation, unseen);
  valves = valves_of(all.episodes, arm);
  EpisodeChoice choice;
  if (may_be_little && validation_.empty() && is_little(arm, all.episodes)) {
    choice.is_little = true;
    choice.data.training = std::move(all.episodes);
  } else {
    choice = choose_episodes(std::move(all), std::move(validation),
                             unseen_.empty() ? kUnseenShare : 0.0, flags.seed);
  }
  choice.broken = std::move(broken);
  if (!unseen_.empty()) {
    choice.data.unseen = std::move(unseen.episodes);
  }
  for (const std::string& path : data_) {
    if (!choice.is_little && reader.was_learnt_before(path)) {
      warn(flags,
           "the model of --from has learnt {} already: what is held back of it is no news "
           "to the network, and an error on it says too little",
           path);
    }
  }
  return choice;
}

CrossValidation choose_by_folds(const CommonFlags& flags, const ArmDescription& arm,
                                const std::vector<Episode>& episodes,
                                const TrainingSettings& settings, const IdentifiedValves& valves) {
  const fs::path file = folds_path_of(settings.checkpoint);
  const bool is_there = settings.resume && fs::exists(file);
  const CrossValidation found = is_there ? read_cross_validation(read_file(file), file.string())
                                         : cross_validate(arm, episodes, settings, valves);
  refuse_if(
      is_there && found.identity != folds_identity(arm, episodes, settings),
      "{}: a run with other data or settings began there; give the same, or leave out --resume",
      file.string());
  if (!is_there) {
    write_folds(found, settings.checkpoint);
  }
  say(flags, "{}", to_text(found));
  return found;
}

TrainingResult train_as_found(const CommonFlags& flags, const ArmDescription& arm,
                              const std::vector<Episode>& episodes, TrainingSettings settings,
                              const IdentifiedValves& valves, CrossValidation& found) {
  TrainingResult result = train_on_everything(arm, episodes, settings, valves, found);
  while (result.status == TrainingStatus::diverged && take_another_way(found)) {
    say(flags, "{}; so it learns by {} instead, whose error is not known", result.message,
        to_string(found.best().optimiser));
    std::error_code ignored;
    fs::remove(settings.checkpoint, ignored);  // of the way that diverged: --resume would refuse it
    write_folds(found, settings.checkpoint);
    settings.resume = false;
    result = train_on_everything(arm, episodes, settings, valves, found);
  }
  return result;
}

}  // namespace limber
