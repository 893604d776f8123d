#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/common/filesystem.hpp"
#include "limber/common/folder_lock.hpp"

namespace limber {

/// Whether `path`, or what it leads to, is `folder` or lies in it. Links and detours don't hide it;
/// neither has to exist.
bool lies_in(const fs::path& path, const fs::path& folder);

/// @param what  may go on: ends the message
/// @throws InputError naming the first key of `file` that is not as in `wanted`.
void require_same_run(const fs::path& file, const nlohmann::json& wanted, const std::string& what);

/// The folder of one verb's results, with a manifest of the files that it wrote there
/// (`.limber-VERB`, docs/formats.md). Files that the manifest does not list, or that have changed
/// since, are somebody else's: they are never removed or overwritten.
///
/// Threads: files may be written from several at once.
class OutputFolder {
 public:
  /// What to do with a folder that holds something already.
  enum class Start {
    fresh,   ///< remove what the manifest lists; refuse a folder that holds files and no manifest
    forced,  ///< the same, but files without a manifest may lie in it: they stay
    resumed  ///< keep everything, and go on with the manifest
  };
  static Start start(bool resumes, bool force) {
    return resumes ? Start::resumed : force ? Start::forced : Start::fresh;
  }

  /// Makes the folder, or removes the last run's files.
  /// @param inputs  files and folders that the run reads: none may lie in it
  /// @throws InputError naming the folder and what is wrong with it; SystemFault if it can't be
  /// made or cleared.
  OutputFolder(fs::path folder, std::string verb, Start start,
               const std::vector<fs::path>& inputs = {});

  const fs::path& path() const { return folder_; }

  /// Files that stayed in a cleared folder because they are somebody else's: names relative to the
  /// folder, sorted.
  const std::vector<std::string>& left() const { return left_; }
  /// A sentence about it; empty if nothing stayed.
  std::string about_left() const;

  /// Call this before the work begins. @throws InputError if somebody else's file has one of these
  /// names.
  void require_free(const std::vector<std::string>& names) const;

  /// @throws InputError if one of these names is listed and its file has changed since.
  void require_unchanged(const std::vector<std::string>& names) const;

  /// Writes a file, atomically. @param name  relative to the folder: "plots/a.svg"
  /// @throws InputError if somebody else's file has that name; SystemFault.
  void write(const std::string& name, std::string_view content);
  /// The same for files that `write_them` writes to path() / name by itself.
  void write_with(const std::vector<std::string>& names, const std::function<void()>& write_them);
  /// Removes a file that was written.
  void remove(const std::string& name);

 private:
  fs::path manifest_path() const { return folder_ / (".limber-" + verb_); }
  bool read_manifest();
  void write_manifest() const;
  void require_usable(Start start, bool has_manifest) const;
  void clear();
  void list_left();
  bool is_own(const std::string& name) const;
  bool holds_foreign(const std::string& name) const;
  /// Lists what will be written, then, by its hash, what was.
  void begin(const std::vector<std::string>& names);
  void end(const std::map<std::string, std::string>& hashes);

  fs::path folder_;
  std::string verb_;
  /// Name → content hash; empty while the file is being written.
  std::map<std::string, std::string> files_;
  std::vector<std::string> left_;
  std::mutex mutex_;
  std::optional<FolderLock> lock_;  ///< of two runs in a folder each would take the other's files
};

}  // namespace limber
