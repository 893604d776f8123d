#pragma once

#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/data/recording.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/training/trainer.hpp"
#include "verb.hpp"

namespace limber {

/// @throws InputError as read_recording and require_recording_of
Recording read_recording_of(const ArmDescription& arm, const std::string& file);

/// A recording as a network has to be asked with it: one that learnt from set points is given set
/// points, whatever was measured beside them.
/// @throws InputError where it learnt from what was measured, and nothing was.
Recording as_learnt_from(const CompensationModel& network, const std::string& model_file,
                         Recording recording, const std::string& file);

/// Episodes of several files, and what messages call each: "train.h5, episode 3".
struct NamedEpisodes {
  std::vector<Episode> episodes;
  std::vector<std::string> names;

  void add(const std::string& path, std::vector<Episode> more);
};

/// Reads what a network is to learn from, and keeps the files' names and hashes. All of it measured
/// pressures (or the arm's other command), or all of it holds set points only.
class EpisodeReader {
 public:
  /// @param setpoints  whether set points alone are taken
  EpisodeReader(const CommonFlags& flags, const ArmDescription& arm, bool setpoints)
      : flags_(flags), arm_(arm), setpoints_(setpoints) {}

  /// @throws InputError as require_recording_of and note_kind; says where the base is not where it
  /// should be.
  Recording read(const std::string& path);
  /// Those of its episodes that have these numbers; says once per file where its base is.
  std::vector<Episode> read_part(const std::string& path, std::span<const int> episodes);
  /// All of them, which are noted as `sources`.
  NamedEpisodes read_all(const std::vector<std::string>& paths);
  /// @throws InputError that names this file and the first one, if they are of different kinds.
  void note_kind(const std::string& file, bool setpoints_only);
  /// @throws InputError where a source, of any call, has the same content.
  void note_source(const std::string& path);
  /// @param sources  of the model that is gone on from, in its record
  void note_learnt_before(std::string sources) { learnt_before_ = std::move(sources); }
  /// Whether a source, or what was learnt before, has the content of that file.
  bool is_source(const std::string& path) const;
  bool was_learnt_before(const std::string& path) const;

  /// "a.h5 HASH, b.h5 HASH".
  const std::string& sources() const { return sources_; }
  /// The same, followed by what else was learnt before.
  std::string all_sources() const;

 private:
  /// @param episodes  reads these alone (read_recording_part); none: all
  Recording read_of_arm(const std::string& path, std::span<const int> episodes);
  void warn_of_base(const std::string& path, const Recording& recording) const;

  const CommonFlags& flags_;
  const ArmDescription& arm_;
  bool setpoints_;
  std::string first_;  ///< of the files whose kind was noted
  bool setpoints_only_ = false;
  std::string sources_;
  std::string learnt_before_;
  std::map<std::string, std::string> path_of_hash_;  ///< of sources
  std::set<std::string> begun_;                      ///< files of which a part was read
};

/// What is trained on, and which episodes choose the epoch.
struct EpisodeChoice {
  TrainingData data;
  std::vector<std::string> validation;  ///< names of those that validate
  std::vector<std::string> broken;      ///< of all episodes, with their errors
  bool is_little = false;               ///< nothing is held back (cross_validate)
};

/// Takes out episodes whose frames are those of one before them, and warns of them: what is held
/// back of one would be learnt from in the other.
void leave_out_twins(const CommonFlags& flags, NamedEpisodes& all);

/// Takes out of all parts those in which the arm does not do what it does in the others
/// (`episode_errors` of all of them together). @return their names, and what is wrong with them
std::vector<std::string> leave_out_broken(const ArmDescription& arm,
                                          std::initializer_list<NamedEpisodes*> parts);

/// Of the frames: what is held back to choose the epoch.
inline constexpr double kValidationShare = 0.1;

/// Holds back for validation and for the model's error.
/// @param validation  what validates; where there is none, episodes are held back.
/// @param unseen_share  of the frames, that the finished model is measured on; 0: none
/// @throws InputError as `hold_back_validation`.
EpisodeChoice choose_episodes(NamedEpisodes all, NamedEpisodes validation, double unseen_share,
                              std::uint64_t seed);

}  // namespace limber
