#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"

namespace limber {

enum class ProjectItem { arm, model, environment, recording, plan };

/// Files that the studio offers: those of a project folder by their path in it
/// ("environments/mine.yaml"), limber's own by their name ("limber:01_pillar"), and files that the
/// command line named ("given:NAME"). Names come from requests: none leads out of the folder.
/// Threads: constant after `give`.
class ProjectFolder {
 public:
  /// @throws InputError if it is no folder.
  explicit ProjectFolder(const fs::path& folder);

  /// Offers a file from anywhere. @return its name
  std::string give(ProjectItem kind, const fs::path& file);

  /// Names of all files of a kind: given ones, the project's, limber's own. Looks kMaxDepth folders
  /// deep, at kMaxEntries files and folders, never into an experiment, and into a run's plans for
  /// plans alone.
  std::vector<std::string> names(ProjectItem kind) const;

  /// Those of the models that are of no arm alone.
  std::vector<std::string> families() const;

  /// Folders that `limber experiment` has written.
  std::vector<std::string> experiments() const;

  /// @throws InputError if the name is none that could be offered, or there is no such file.
  fs::path find(ProjectItem kind, const std::string& name) const;

  /// A file of any kind by its path in the project. @throws InputError if it is none, or outside.
  fs::path inside(const std::string& name) const;

  /// Where a file of that name is saved: "mine" becomes FOLDER/subfolder/mine.yaml.
  /// @throws InputError unless the name is made of letters, digits, "_", "-", "." and spaces.
  fs::path to_save(const std::string& subfolder, const std::string& name,
                   const std::string& ending) const;
  /// What a file in the project is called in requests.
  std::string name_of(const fs::path& file) const;

  const fs::path& folder() const { return folder_; }

  static constexpr int kMaxDepth = 3;
  static constexpr int kMaxEntries = 5000;
  static constexpr const char* kPlansOfRun = ".plans";  ///< a folder beside the run's recording

 private:
  /// use(entry) for what is looked at.
  template <class Use>
  void look_through(bool into_plans_of_runs, const Use& use) const;

  fs::path folder_;  // canonical
  std::map<std::string, fs::path> given_[5];
};

}  // namespace limber
