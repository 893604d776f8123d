#include "limber/lab/output_folder.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr const char* kOutputSchema = "limber/output/1";
constexpr std::size_t kMaxNamed = 3;  // of the files that stay

/// Without links, dots and a slash at the end, as far as it exists.
fs::path whole(const fs::path& path) {
  std::error_code error;
  fs::path result = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error || result.empty()) {
    result = fs::absolute(path, error).lexically_normal();
  }
  return result.has_filename() ? result : result.parent_path();
}

bool begins_with(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// A name that stays within the folder, in its one spelling.
bool is_plain(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && name.find('\0') == std::string::npos && path.is_relative() &&
         path.has_filename() && path.lexically_normal() == path && *path.begin() != "..";
}

/// Whether no part of the path from the folder to the file is a link.
bool is_reached_plainly(const fs::path& folder, const std::string& name) {
  return whole(folder / name) == whole(folder) / name;
}

/// Whether it is a file that is being written, or was when its process was killed: `.NAME.….tmp`.
/// The next process that writes there removes it (common/atomic_file.hpp).
bool is_temporary(const fs::path& file) {
  return file.filename().string().starts_with('.') && file.extension() == ".tmp";
}

/// Finished episodes of a collection that was killed: numbered files in FILE.parts.
void remove_parts(const fs::path& file) {
  const fs::path folder = file.string() + ".parts";
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".h5" &&
        std::ranges::all_of(stem, [](unsigned char c) { return std::isdigit(c) != 0; })) {
      found.push_back(entry.path());
    }
  }
  for (const fs::path& path : found) {
    fs::remove(path, error);
  }
  fs::remove(folder, error);  // where nothing else is in it
}

}  // namespace

bool lies_in(const fs::path& path, const fs::path& folder) {
  const fs::path end = whole(folder);
  const fs::path named = path.has_filename() ? path : path.parent_path();
  return begins_with(whole(path), end) ||
         begins_with(whole(fs::absolute(named).parent_path()) / named.filename(), end);
}

void require_same_run(const fs::path& file, const nlohmann::json& wanted, const std::string& what) {
  const nlohmann::json there = read_json_object(file);
  for (const auto& [key, value] : wanted.items()) {
    const nlohmann::json found = there.value(key, nlohmann::json(nullptr));
    if (found != value) {
      throw InputError(fmt::format("{}: {} = {}; this run has {}: --resume continues the same {}",
                                   file.string(), key, in_few_words(found), in_few_words(value),
                                   what));
    }
  }
}

OutputFolder::OutputFolder(fs::path folder, std::string verb, Start start,
                           const std::vector<fs::path>& inputs)
    : folder_(std::move(folder)), verb_(std::move(verb)) {
  for (const fs::path& input : inputs) {
    refuse_if(lies_in(input, folder_),
              "{}: lies in {}, the folder for the results of limber {}; choose another --out",
              input.string(), folder_.string(), verb_);
  }
  require_usable(start, read_manifest());  // before the folder is made
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw SystemFault(fmt::format("{}: can't be made: {}", folder_.string(), error.message()));
  }
  lock_.emplace(folder_, "limber " + verb_);
  require_usable(start, read_manifest());  // as another run has left it, which ended meanwhile
  if (start != Start::resumed) {
    clear();
    list_left();
  }
  write_manifest();
}

void OutputFolder::require_usable(Start start, bool has_manifest) const {
  refuse_if(fs::exists(folder_) && !fs::is_directory(folder_),
            "{}: is a file; expected a folder, or nothing, for the results", folder_.string());
  const bool foreign = !has_manifest && fs::is_directory(folder_) && !fs::is_empty(folder_);
  refuse_if(foreign && start != Start::forced,
            "{}: holds files, but no list of those that limber {} wrote "
            "(older versions kept none); choose another folder with --out, "
            "or write into this one with --force, which removes nothing",
            folder_.string(), verb_);
  // Even --force must not fill a home folder or the folder that the user works in.
  for (const fs::path& kept : {fs::current_path(), fs::path("/")}) {
    refuse_if(foreign && begins_with(whole(kept), whole(folder_)),
              "{}: is the current folder or one above it, and not empty; "
              "choose a folder of its own with --out",
              folder_.string());
  }
}

bool OutputFolder::read_manifest() {
  files_.clear();
  if (!fs::is_regular_file(manifest_path())) {
    return false;
  }
  try {
    const nlohmann::json root = read_json_object(manifest_path());
    const JsonReader reader(root, manifest_path().string());
    reader.require_schema(kOutputSchema);
    const JsonReader files = reader.at("files");
    if (!files.value().is_object()) {
      files.refuse_found("expected names with their hashes");
    }
    for (const auto& [name, hash] : files.value().items()) {
      files.refuse_if(!is_plain(name), "'{}' found; expected names of files in the folder", name);
      files_[name] = files.at(name.c_str()).text();
    }
  } catch (const InputError&) {
    files_.clear();  // a list that can't be trusted counts as none
    return false;
  }
  return true;
}

void OutputFolder::write_manifest() const {
  const Json root = {
      {"schema", kOutputSchema},
      {"about", fmt::format("Files that limber {} wrote here, with their hashes; the next run "
                            "removes them, and nothing else.",
                            verb_)},
      {"files", files_}};
  write_file_atomically(manifest_path(), root.dump(1) + "\n");
}

bool OutputFolder::is_own(const std::string& name) const {
  const auto listed = files_.find(name);
  const fs::path file = folder_ / name;
  std::error_code error;  // such as a name too long for a file
  if (listed == files_.end() || !is_reached_plainly(folder_, name) ||
      !fs::is_regular_file(fs::symlink_status(file, error))) {
    return false;
  }
  return listed->second.empty() || listed->second == file_hash(file);
}

bool OutputFolder::holds_foreign(const std::string& name) const {
  std::error_code error;
  return fs::exists(fs::symlink_status(folder_ / name, error)) && !is_own(name);
}

void OutputFolder::clear() {
  std::error_code error;
  for (const auto& [name, hash] : files_) {
    const fs::path file = folder_ / name;
    if (is_own(name) && !fs::remove(file, error)) {
      throw SystemFault(fmt::format("{}: can't be removed: {}", file.string(), error.message()));
    }
    if (hash.empty() && is_reached_plainly(folder_, name)) {
      remove_parts(file);
    }
    // Folders that are empty now; `remove` keeps the others.
    for (fs::path parent = fs::path(name).parent_path(); !parent.empty();
         parent = parent.parent_path()) {
      if (fs::is_directory(fs::symlink_status(folder_ / parent, error))) {
        fs::remove(folder_ / parent, error);
      }
    }
  }
  files_.clear();
}

void OutputFolder::list_left() {
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_)) {
    if (!entry.is_directory() && entry.path() != manifest_path() && !is_temporary(entry.path())) {
      left_.push_back(entry.path().lexically_relative(folder_).string());
    }
  }
  std::sort(left_.begin(), left_.end());
}

std::string OutputFolder::about_left() const {
  if (left_.empty()) {
    return "";
  }
  std::string names;
  for (std::size_t i = 0; i < std::min(left_.size(), kMaxNamed); ++i) {
    names += (i == 0 ? "" : ", ") + left_[i];
  }
  return fmt::format(
      "{}: left as they are, because limber {} did not write them or they have changed since: {}{}",
      folder_.string(), verb_, names,
      left_.size() > kMaxNamed ? fmt::format(" and {} more", left_.size() - kMaxNamed) : "");
}

void OutputFolder::require_free(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    refuse_if(
        holds_foreign(name),
        "{}: limber {} did not write this file, or it has changed since, and a result needs its "
        "name: move it away, or choose another --out",
        (folder_ / name).string(), verb_);
  }
}

void OutputFolder::require_unchanged(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    const auto listed = files_.find(name);
    if (listed != files_.end() && !listed->second.empty() && holds_foreign(name)) {
      throw InputError(fmt::format(
          "{}: has changed since limber {} wrote it (its hash is not the one in {}): remove it to "
          "have it made again, or choose another --out",
          (folder_ / name).string(), verb_, manifest_path().string()));
    }
  }
}

void OutputFolder::begin(const std::vector<std::string>& names) {
  const std::lock_guard lock(mutex_);
  require_free(names);
  for (const std::string& name : names) {
    files_[name] = "";
  }
  write_manifest();
}

void OutputFolder::end(const std::map<std::string, std::string>& hashes) {
  const std::lock_guard lock(mutex_);
  for (const auto& [name, hash] : hashes) {
    files_[name] = hash;
  }
  write_manifest();
}

void OutputFolder::write(const std::string& name, std::string_view content) {
  begin({name});
  write_file_atomically(folder_ / name, content);
  end({{name, content_hash(content)}});
}

void OutputFolder::write_with(const std::vector<std::string>& names,
                              const std::function<void()>& write_them) {
  begin(names);
  write_them();
  std::map<std::string, std::string> hashes;
  for (const std::string& name : names) {
    hashes[name] = file_hash(folder_ / name);
  }
  end(hashes);
}

void OutputFolder::remove(const std::string& name) {
  const std::lock_guard lock(mutex_);
  if (is_own(name)) {
    fs::remove(folder_ / name);
  }
  files_.erase(name);
  write_manifest();
}

}  // namespace limber
