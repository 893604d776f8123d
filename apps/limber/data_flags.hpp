#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "episode_choice.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/training/cross_validation.hpp"
#include "verb.hpp"

namespace limber {

/// What `limber train` learns from: --data, --validation, --unseen, --keep-broken, --setpoints and
/// --old-data.
class DataFlags {
 public:
  void add_to(CLI::App& app);
  /// @param from  --from, without which nothing was learnt before
  void add_old_data_to(CLI::App& app, CLI::Option* from);

  const std::vector<std::string>& data() const { return data_; }
  const std::vector<std::string>& old_data() const { return old_data_; }
  bool names_unseen() const { return !unseen_.empty(); }
  bool setpoints() const { return setpoints_; }

  /// Reads all of it but --old-data, leaves out what is broken, and holds back what validates.
  /// @param may_be_little  whether nothing is held back of little (is_little), where no flag here
  /// says otherwise
  /// @param valves  found in --data
  EpisodeChoice load(const CommonFlags& flags, const ArmDescription& arm, EpisodeReader& reader,
                     bool may_be_little, IdentifiedValves& valves) const;
  /// --family: arms are held back.
  /// @param reader  must outlive what is returned: of more frames than `slice_frames`, slices of
  /// about as many are read when they are needed.
  EpisodeChoice load_arms(const CommonFlags& flags, const ArmDescription& arm,
                          EpisodeReader& reader, int slice_frames, IdentifiedValves& valves) const;
  /// --old-data: what is replayed, and what the old errors are measured on.
  EpisodeChoice load_old(const CommonFlags& flags, const ArmDescription& arm,
                         EpisodeReader& reader) const;

 private:
  IdentifiedValves valves_of(const std::vector<Episode>& episodes, const ArmDescription& arm) const;
  NamedEpisodes load_validation(const CommonFlags& flags, EpisodeReader& reader) const;
  NamedEpisodes load_unseen(EpisodeReader& reader) const;
  std::vector<std::string> leave_out(const ArmDescription& arm, NamedEpisodes& all,
                                     NamedEpisodes& validation, NamedEpisodes& unseen) const;

  std::vector<std::string> data_;
  std::string validation_;
  std::string unseen_;
  std::vector<std::string> old_data_;
  bool keep_broken_ = false;
  bool setpoints_ = false;
};

/// The file beside a run's checkpoint that keeps what its folds found.
fs::path folds_path_of(const fs::path& checkpoint);

/// `cross_validate`, or what it found before the run was stopped; says what that is.
CrossValidation choose_by_folds(const CommonFlags& flags, const ArmDescription& arm,
                                const std::vector<Episode>& episodes,
                                const TrainingSettings& settings, const IdentifiedValves& valves);

/// `train_on_everything`; where a way diverges, by the next, which is said and kept for --resume.
TrainingResult train_as_found(const CommonFlags& flags, const ArmDescription& arm,
                              const std::vector<Episode>& episodes, TrainingSettings settings,
                              const IdentifiedValves& valves, CrossValidation& found);

}  // namespace limber
