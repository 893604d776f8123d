#include "project_folder.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

constexpr std::string_view kOwn = "limber:";
constexpr std::string_view kGiven = "given:";
constexpr std::size_t kHead = 65536;  // a forest's header: four tensors, and its arm's keys
constexpr std::size_t kMaxName = 100;

const char* ending_of(ProjectItem kind) {
  return kind == ProjectItem::model       ? ".safetensors"
         : kind == ProjectItem::recording ? ".h5"
         : kind == ProjectItem::plan      ? ".json"
                                          : ".yaml";
}

std::string head_of(const fs::path& file) {
  std::string head(kHead, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), std::streamsize(head.size()));
  head.resize(std::max<std::streamsize>(0, stream.gcount()));
  return head;
}

/// What the beginning of a file says.
bool is_of(ProjectItem kind, const fs::path& file) {
  if (file.extension() != ending_of(kind)) {
    return false;
  }
  const std::string head = head_of(file);
  const auto says = [&](const char* schema) { return head.find(schema) != std::string::npos; };
  switch (kind) {
    case ProjectItem::arm:
      return says("limber/arm/") && !says("limber/environment/");
    case ProjectItem::environment:
      return says("limber/environment/");
    case ProjectItem::model:
      return !says("limber/forest/");
    case ProjectItem::recording:
      return head.starts_with("\x89HDF\r\n");
    case ProjectItem::plan:
      return says("\"limber/plan/");
  }
  return false;
}

/// Empty for kinds of which limber brings none.
fs::path own_folder(ProjectItem kind) {
  constexpr std::array<const char*, 3> kFolders = {"arms", "families", "environments"};
  return std::size_t(kind) < kFolders.size() ? data_folder() / kFolders.at(std::size_t(kind))
                                             : fs::path();
}

bool is_experiment(const fs::directory_entry& entry) {
  std::error_code error;
  return entry.is_directory(error) && !entry.is_symlink(error) &&
         fs::is_regular_file(entry.path() / "experiment.json", error);
}

bool is_plain_name(const std::string& name) {
  return !name.empty() && name.size() <= kMaxName && name.front() != '.' &&
         std::ranges::all_of(name, [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '_' || c == '-' || c == '.' || c == ' ';
         });
}

bool is_inside(const fs::path& folder, const fs::path& file) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
         folder.end();
}

[[noreturn]] void refuse_name(const std::string& name) {
  throw InputError(fmt::format("'{}': no file of the project folder has that name", name));
}

}  // namespace

ProjectFolder::ProjectFolder(const fs::path& folder) {
  std::error_code error;
  folder_ = fs::canonical(folder, error);
  refuse_if(error || !fs::is_directory(folder_), "--project {}: no such folder", folder.string());
}

std::string ProjectFolder::give(ProjectItem kind, const fs::path& file) {
  const fs::path whole = fs::canonical(file);
  if (is_inside(folder_, whole)) {
    return name_of(whole);
  }
  if (is_inside(data_folder(), whole) && kind != ProjectItem::model) {
    return std::string(kOwn) + whole.stem().string();
  }
  const std::string name = std::string(kGiven) + whole.filename().string();
  given_[std::size_t(kind)][name] = whole;
  return name;
}

std::string ProjectFolder::name_of(const fs::path& file) const {
  return file.lexically_relative(folder_).generic_string();
}

std::vector<std::string> ProjectFolder::names(ProjectItem kind) const {
  std::vector<std::string> result;
  for (const auto& [name, path] : given_[std::size_t(kind)]) {
    result.push_back(name);
  }
  std::set<std::string> found;
  std::error_code error;
  look_through(kind == ProjectItem::plan, [&](const fs::directory_entry& entry) {
    const bool is_file = entry.is_regular_file(error) && is_of(kind, entry.path());
    // A link that leads out of the folder could not be opened.
    if (is_file && (!entry.is_symlink(error) ||
                    is_inside(folder_, fs::weakly_canonical(entry.path(), error)))) {
      found.insert(name_of(entry.path()));
    }
  });
  std::set<std::string> own;
  for (const auto& file : fs::directory_iterator(own_folder(kind), error)) {
    if (is_of(kind, file.path())) {
      own.insert(std::string(kOwn) + file.path().stem().string());
    }
  }
  result.insert(result.end(), found.begin(), found.end());
  result.insert(result.end(), own.begin(), own.end());
  return result;
}

std::vector<std::string> ProjectFolder::families() const {
  std::vector<std::string> result = names(ProjectItem::model);
  std::erase_if(result, [&](const std::string& name) {
    try {
      const std::string head = head_of(find(ProjectItem::model, name));
      return head.find("\"family.arms\"") == std::string::npos ||
             head.find("\"family.e\"") != std::string::npos;
    } catch (const InputError&) {  // removed since it was listed
      return true;
    }
  });
  return result;
}

std::vector<std::string> ProjectFolder::experiments() const {
  std::vector<std::string> result;
  look_through(false, [&](const fs::directory_entry& entry) {
    if (is_experiment(entry)) {
      result.push_back(name_of(entry.path()));
    }
  });
  return result;
}

template <class Use>
void ProjectFolder::look_through(bool into_plans_of_runs, const Use& use) const {
  std::error_code error;
  int looked_at = 0;
  fs::recursive_directory_iterator entry(folder_, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator() && looked_at < kMaxEntries;
       entry.increment(error), ++looked_at) {
    if (entry->path().filename().string().front() == '.' || entry.depth() >= kMaxDepth) {
      entry.disable_recursion_pending();
      continue;
    }
    if (is_experiment(*entry) ||  // thousands of trials
        (!into_plans_of_runs && entry->path().extension() == kPlansOfRun)) {
      entry.disable_recursion_pending();
    }
    use(*entry);
  }
}

fs::path ProjectFolder::find(ProjectItem kind, const std::string& name) const {
  const auto& given = given_[std::size_t(kind)];
  if (const auto found = given.find(name); found != given.end()) {
    return found->second;
  }
  std::error_code error;
  if (name.starts_with(kOwn)) {
    const std::string own = name.substr(kOwn.size());
    const fs::path file = own_folder(kind) / (own + ending_of(kind));
    if (own_folder(kind).empty() || !is_plain_name(own) || !fs::is_regular_file(file, error)) {
      refuse_name(name);
    }
    return file;
  }
  const fs::path whole = inside(name);
  if (whole.extension() != ending_of(kind)) {
    refuse_name(name);
  }
  return whole;
}

fs::path ProjectFolder::inside(const std::string& name) const {
  std::error_code error;
  const bool has_null = name.find('\0') != std::string::npos;
  const fs::path whole = has_null ? fs::path() : fs::canonical(folder_ / name, error);
  if (name.empty() || has_null || error || fs::path(name).is_absolute() ||
      !is_inside(folder_, whole) || !fs::is_regular_file(whole, error)) {
    refuse_name(name);
  }
  return whole;
}

fs::path ProjectFolder::to_save(const std::string& subfolder, const std::string& name,
                                const std::string& ending) const {
  refuse_if(!is_plain_name(name),
            "name: expected 1 to 100 letters, digits, spaces and any of _ - ., the first no point");
  fs::path folder = folder_ / subfolder;
  std::error_code error;
  refuse_if(fs::exists(folder, error) && !is_inside(folder_, fs::canonical(folder, error)),
            "{}: leads out of the project folder", subfolder);
  return folder / (name.ends_with(ending) ? name : name + ending);
}

}  // namespace limber
