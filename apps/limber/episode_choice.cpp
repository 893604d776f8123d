#include "episode_choice.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/data/recording_part.hpp"
#include "limber/data/space_fit.hpp"

namespace limber {

namespace {

const char* kind(bool setpoints_only) {
  return setpoints_only ? "set points only" : "what was measured";
}

/// Of all that an arm was told and did in an episode.
std::string frames_hash(const Episode& episode) {
  std::string hash;
  for (const FrameMatrix* part :
       {&episode.pressure_kpa, &episode.setpoint_kpa, &episode.backbone}) {
    const auto bytes = std::size_t(part->size()) * sizeof(float);
    hash += content_hash({reinterpret_cast<const char*>(part->data()), bytes});
  }
  return hash;
}

}  // namespace

void EpisodeReader::note_kind(const std::string& file, bool setpoints_only) {
  if (first_.empty()) {
    first_ = file;
    setpoints_only_ = setpoints_only;
  } else if (setpoints_only != setpoints_only_) {
    throw InputError(
        fmt::format("{}: {}; {}: {}. What is learnt from the one is wrong of the other: give "
                    "files of one kind. 'limber train --setpoints' leaves out what was measured",
                    first_, kind(setpoints_only_), file, kind(setpoints_only)));
  }
}

Recording read_recording_of(const ArmDescription& arm, const std::string& file) {
  Recording recording = read_recording(file);
  require_recording_of(recording, arm, file);
  return recording;
}

Recording EpisodeReader::read_of_arm(const std::string& path, std::span<const int> episodes) {
  Recording recording =
      episodes.empty() ? read_recording(path) : read_recording_part(path, episodes);
  require_recording_of(recording, arm_, path);
  if (setpoints_) {
    recording.episodes = with_setpoints_only(std::move(recording.episodes));
  }
  note_kind(path, recording.setpoints_only());
  return recording;
}

Recording as_learnt_from(const CompensationModel& network, const std::string& model_file,
                         Recording recording, const std::string& file) {
  if (network.learnt_from_setpoints && !recording.setpoints_only()) {
    recording.episodes = with_setpoints_only(std::move(recording.episodes));
  } else if (!network.learnt_from_setpoints && recording.setpoints_only()) {
    throw InputError(fmt::format(
        "{}: holds set points only; {} learnt from measured {}s and can't be asked without them. "
        "Train a network on recordings of set points (limber train --setpoints)",
        file, model_file, recording.command.name));
  }
  return recording;
}

void NamedEpisodes::add(const std::string& path, std::vector<Episode> more) {
  const std::string file = fs::path(path).filename().string();
  for (std::size_t i = 0; i < more.size(); ++i) {
    names.push_back(fmt::format("{}, {}", file, episode_name(i, more[i].log)));
    episodes.push_back(std::move(more[i]));
  }
}

Recording EpisodeReader::read(const std::string& path) {
  Recording recording = read_of_arm(path, {});
  warn_of_base(path, recording);
  return recording;
}

void EpisodeReader::warn_of_base(const std::string& path, const Recording& recording) const {
  if (const std::string warning = base_warning(recording); !warning.empty()) {
    warn(flags_, "{}: {}", path, warning);
  }
}

NamedEpisodes EpisodeReader::read_all(const std::vector<std::string>& paths) {
  NamedEpisodes all;
  for (const std::string& path : paths) {
    all.add(path, read(path).episodes);
    note_source(path);
  }
  return all;
}

bool EpisodeReader::is_source(const std::string& path) const {
  return path_of_hash_.contains(file_hash(path)) || was_learnt_before(path);
}

bool EpisodeReader::was_learnt_before(const std::string& path) const {
  return !learnt_before_.empty() && learnt_before_.find(file_hash(path)) != std::string::npos;
}

std::string EpisodeReader::all_sources() const {
  std::string all = sources_;
  for (std::size_t begin = 0; begin < learnt_before_.size();) {
    const std::size_t end = std::min(learnt_before_.find(", ", begin), learnt_before_.size());
    const std::string entry = learnt_before_.substr(begin, end - begin);
    if (!path_of_hash_.contains(entry.substr(entry.rfind(' ') + 1))) {
      all += (all.empty() ? "" : ", ") + entry;
    }
    begin = end + 2;
  }
  return all;
}

void EpisodeReader::note_source(const std::string& path) {
  // What is held back of one would be learnt from in the other.
  add_source(sources_, path, add_different(path_of_hash_, path));
}

std::vector<Episode> EpisodeReader::read_part(const std::string& path,
                                              std::span<const int> episodes) {
  Recording recording = read_of_arm(path, episodes);
  if (begun_.insert(path).second) {
    warn_of_base(path, recording);
  }
  return std::move(recording.episodes);
}

void leave_out_twins(const CommonFlags& flags, NamedEpisodes& all) {
  std::map<std::string, std::string> name_of_hash;
  NamedEpisodes different;
  for (std::size_t i = 0; i < all.episodes.size(); ++i) {
    const auto [first, is_new] = name_of_hash.emplace(frames_hash(all.episodes[i]), all.names[i]);
    if (is_new) {
      different.names.push_back(std::move(all.names[i]));
      different.episodes.push_back(std::move(all.episodes[i]));
    } else {
      warn(flags, "left out: {}, which holds the frames of {} again", all.names[i], first->second);
    }
  }
  all = std::move(different);
}

std::vector<std::string> leave_out_broken(const ArmDescription& arm,
                                          std::initializer_list<NamedEpisodes*> parts) {
  // Of one arm each: those of a virtual arm have others to compare with only where these are of the
  // same physics.
  struct Arm {
    std::vector<Episode> episodes;
    EpisodeErrors errors;  // none: too little to fit to
    std::size_t told = 0;  // so many of them
  };
  std::map<std::string, Arm> arms;
  for (const NamedEpisodes* part : parts) {
    for (const Episode& episode : part->episodes) {
      arms[episode.physics].episodes.push_back(episode);
    }
  }
  for (auto& [physics, one] : arms) {
    if (!arm.is_spatial() || is_enough_for_space_fit(one.episodes)) {
      one.errors = episode_errors(arm, one.episodes);
    }
  }
  std::vector<std::string> broken;
  for (NamedEpisodes* part : parts) {
    NamedEpisodes whole;
    for (std::size_t k = 0; k < part->episodes.size(); ++k) {
      Arm& own = arms[part->episodes[k].physics];
      const std::size_t i = own.told++;
      if (i < own.errors.episodes.size() && own.errors.episodes[i].is_outlier) {
        broken.push_back(fmt::format("{} ({}; the middle one has {:.1f} cm)", part->names[k],
                                     own.errors.episodes[i].why, own.errors.median_cm));
      } else {
        whole.names.push_back(std::move(part->names[k]));
        whole.episodes.push_back(std::move(part->episodes[k]));
      }
    }
    *part = std::move(whole);
  }
  return broken;
}

EpisodeChoice choose_episodes(NamedEpisodes all, NamedEpisodes validation, double unseen_share,
                              std::uint64_t seed) {
  EpisodeChoice choice;
  if (validation.episodes.empty()) {
    choice.data = hold_back_validation(std::move(all.episodes), kValidationShare, seed);
    const char* part = choice.data.training.size() == all.names.size() ? "the end of " : "";
    hold_back_unseen(choice.data, unseen_share, seed);
    for (const int number : choice.data.held_back) {
      choice.validation.push_back(part + all.names[number]);
    }
  } else {
    choice.data.training = std::move(all.episodes);
    hold_back_unseen(choice.data, unseen_share, seed);
    choice.data.validation = std::move(validation.episodes);
    choice.validation = std::move(validation.names);
  }
  return choice;
}

}  // namespace limber
