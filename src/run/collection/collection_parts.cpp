#include "collection_parts.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/arm_identity.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr std::size_t kDigits = 6;  // at least; a millionth episode has one more

bool is_part_name(const std::string& name) {
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return digits >= kDigits && name.substr(digits) == ".h5";
}

bool same_matrix(const FrameMatrix& a, const FrameMatrix& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

/// Of a folder and those that it lies in.
std::vector<fs::path> missing_folders(fs::path folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  while (!folder.empty() && !fs::exists(folder, error)) {
    missing.push_back(folder);
    folder = folder.parent_path();
  }
  return missing;
}

/// No marks at all say that every frame was tracked.
bool same_marks(const Episode& a, const Episode& b) {
  return a.tracked == b.tracked || (a.tracked.empty() && b.untracked_count() == 0) ||
         (b.tracked.empty() && a.untracked_count() == 0);
}

/// Parts of one recording are of one arm to the last digit.
void require_same_arm(const Recording& found, const Recording& wanted, const std::string& file) {
  if (found.arm_name == wanted.arm_name && found.arm_hash == wanted.arm_hash) {
    return;
  }
  std::vector<std::string> keys;
  if (!found.arm_description.empty() && !wanted.arm_description.empty()) {
    constexpr auto kPolynomials = PolynomialsOf::characterisation;
    keys = arm_differences(read_arm_keys(found.arm_description, file, kPolynomials),
                           read_arm_keys(wanted.arm_description, "the arm", kPolynomials));
  }
  throw InputError(
      fmt::format("{}: --resume: recorded with arm '{} {}'; this run has '{} "
                  "{}'{}{}. Use the same settings, or --force to start over",
                  file, found.arm_name, found.arm_hash, wanted.arm_name, wanted.arm_hash,
                  keys.empty() ? "" : ": ", fmt::join(keys, "; ")));
}

}  // namespace

bool same_values(const Episode& a, const Episode& b) {
  return a.time_s.size() == b.time_s.size() && a.time_s == b.time_s &&
         same_matrix(a.pressure_kpa, b.pressure_kpa) &&
         same_matrix(a.setpoint_kpa, b.setpoint_kpa) && same_matrix(a.backbone, b.backbone) &&
         a.motion_index == b.motion_index && same_marks(a, b) && a.physics == b.physics;
}

CollectionParts::CollectionParts(const fs::path& path, Recording identity)
    : folder_(path.string() + ".parts"), identity_(std::move(identity)) {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  refuse_if(fs::exists(status) && !fs::is_directory(status),
            "{}: is a file; finished episodes are kept in a folder of that name. Move it away",
            folder_.string());
}

CollectionParts::Use::Use(const CollectionParts& parts)
    : made_(missing_folders(parts.folder())), lock_(parts.folder(), "limber collect") {}

CollectionParts::Use::~Use() {
  std::error_code error;
  for (const fs::path& folder : made_) {
    fs::remove(folder, error);  // none but an empty one
  }
}

void CollectionParts::write(std::size_t index, const Episode& episode) const {
  Recording part = identity_;
  part.episodes = {episode};
  write_recording(path(index), part);
}

std::optional<Episode> CollectionParts::read(std::size_t index) const {
  std::error_code error;
  if (!fs::exists(path(index), error)) {
    return std::nullopt;
  }
  Recording part = read_recording(path(index));
  require_same_origin(part, path(index).string());
  return std::move(part.episodes.front());
}

void CollectionParts::require_same_origin(const Recording& found, const std::string& file) const {
  const auto compare = [&](const char* what, const std::string& was, const std::string& is) {
    refuse_if(was != is,
              "{}: --resume: recorded with {} '{}'; this run has "
              "'{}'. Use the same settings, or --force to start over",
              file, what, was, is);
  };
  // Whoever goes on with it: a container's host has another name each time.
  const auto without_starter = [](const std::string& source) {
    return source.substr(0, source.find(kStartedBy));
  };
  compare("source", without_starter(found.source), without_starter(identity_.source));
  require_same_arm(found, identity_, file);
  compare("seed", std::to_string(found.seed), std::to_string(identity_.seed));
  compare("settings", found.settings, identity_.settings);
}

std::size_t CollectionParts::remove() const {
  std::error_code error;
  if (!fs::exists(folder_, error)) {
    return 0;
  }
  remove_abandoned_files(folder_);
  for (const fs::path& part : own_files()) {
    fs::remove(part, error);
    if (error) {
      throw_fault(part, "can't be removed", error.value());
    }
  }
  const fs::directory_iterator rest(folder_, error);
  const auto foreign = error ? 0 : std::distance(rest, fs::directory_iterator());
  if (foreign == 0) {
    fs::remove(folder_, error);  // an empty folder that stays is no reason to fail
  }
  return std::size_t(foreign);
}

fs::path CollectionParts::path(std::size_t index) const {
  return folder_ / fmt::format("{:0{}}.h5", index, kDigits);
}

std::vector<fs::path> CollectionParts::own_files() const {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder_, error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_part_name(entry->path().filename().string()) &&
        fs::is_regular_file(entry->symlink_status(error))) {
      files.push_back(entry->path());
    }
  }
  return files;
}

}  // namespace limber
