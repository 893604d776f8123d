#include "limber/experiment/output_folder.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"

namespace limber {

namespace fs = std::filesystem;

namespace {

void require_replaceable(const fs::path& folder, bool force, const std::string& verb) {
  if (fs::exists(folder) && !fs::is_directory(folder)) {
    throw InputError(fmt::format("{}: is a file; expected a folder, or nothing, for the results",
                                 folder.string()));
  }
  const bool foreign = fs::is_directory(folder) && !fs::is_empty(folder) &&
                       !fs::exists(folder / (".limber-" + verb));
  if (foreign && !force) {
    throw InputError(
        fmt::format("{}: holds files that limber {} did not make; choose another "
                    "folder with --out, or replace it with --force",
                    folder.string(), verb));
  }
  // Even --force must not wipe a home folder or the folder that the user works in.
  const fs::path whole = fs::weakly_canonical(folder);
  for (const fs::path& kept : std::array{fs::weakly_canonical(fs::current_path()), fs::path("/")}) {
    const auto mismatch = std::mismatch(whole.begin(), whole.end(), kept.begin(), kept.end());
    if (foreign && mismatch.first == whole.end()) {
      throw InputError(
          fmt::format("{}: is the current folder or one above it, and not empty; "
                      "choose a folder of its own with --out",
                      folder.string()));
    }
  }
}

}  // namespace

void prepare_output_folder(const fs::path& folder, bool force, const std::string& verb) {
  require_replaceable(folder, force, verb);
  const std::string marker = ".limber-" + verb;
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) {
    // The marker goes first and is never removed: a run that is killed leaves a folder that may be
    // replaced.
    write_file_atomically(folder / marker,
                          fmt::format("Results of limber {}; the next run replaces them.\n", verb));
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().filename() != marker) {
        fs::remove_all(entry.path(), error);
      }
      if (error) {
        break;
      }
    }
  }
  if (error) {
    throw SystemFault(fmt::format("{}: can't be prepared: {}", folder.string(), error.message()));
  }
}

}  // namespace limber
