#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/common/folder_lock.hpp"
#include "limber/data/recording.hpp"

namespace limber {

/// Whether two episodes hold the same numbers.
bool same_values(const Episode& a, const Episode& b);

/// Finished episodes of a collection, one file each, `PATH.parts/NNNNNN.h5`, beside the file they
/// will be joined to. Threads: `write` may be called from several at once, for different episodes.
class CollectionParts {
 public:
  /// @param identity  the recording they will make, without episodes.
  /// @throws InputError if something else has the folder's name.
  CollectionParts(const fs::path& path, Recording identity);

  /// Keeps other collections out of the folder. Folders that it makes are removed at the end, those
  /// that are empty.
  class Use {
   public:
    /// @throws InputError where another one uses it.
    explicit Use(const CollectionParts& parts);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::vector<fs::path> made_;  // the innermost first
    FolderLock lock_;
  };

  const fs::path& folder() const { return folder_; }
  const Recording& identity() const { return identity_; }

  /// Whether there is one at least.
  bool exist() const { return !own_files().empty(); }

  void write(std::size_t index, const Episode& episode) const;

  /// @throws InputError if the part is damaged or of other settings.
  std::optional<Episode> read(std::size_t index) const;

  /// @throws InputError that names what differs.
  void require_same_origin(const Recording& found, const std::string& file) const;

  /// Removes the parts, the remains of killed runs, and the folder if nothing else is in it.
  /// @return how many files stay because collect did not write them
  [[nodiscard]] std::size_t remove() const;

 private:
  fs::path path(std::size_t index) const;
  std::vector<fs::path> own_files() const;

  fs::path folder_;
  Recording identity_;
};

}  // namespace limber
