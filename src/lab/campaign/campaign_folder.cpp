#include "limber/lab/campaign_folder.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/utf8.hpp"
#include "limber/common/version.hpp"

namespace limber {

namespace {

constexpr std::size_t kFan = 1000;                        // entries of a folder
constexpr std::size_t kIdentityDigits = 16;               // of a marker's name
constexpr std::streamoff kEnd = std::streamoff{1} << 16;  // bytes of a file's beginning and end
constexpr const char* kArmFlag = "arm";                   // flags
constexpr const char* kEnvironmentsFlag = "environments";
constexpr const char* kCampaignFile = "campaign.json";
constexpr const char* kCheckpoint = "model.safetensors.checkpoint";

/// Of size, beginning and end: thousands of units may read a recording of gigabytes.
std::string fingerprint_of(const fs::path& path) {
  require_plain_file(path);  // what can't be read is like nothing else
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  std::string ends(2 * std::size_t(kEnd), '\0');
  file.read(ends.data(), kEnd);
  file.clear();
  file.seekg(-std::min<std::streamoff>(kEnd, static_cast<std::streamoff>(size)), std::ios::end);
  file.read(ends.data() + kEnd, kEnd);
  return content_hash(fmt::format("{} {}", size, ends));
}

/// What a verb reads for a flag's value: a file, or limber's own of that name; else empty.
fs::path file_of(const std::string& flag, const std::string& value) {
  if (flag == kArmFlag) {
    return own_file(value, "arms", ".yaml");
  }
  if (flag == kEnvironmentsFlag) {
    return own_file(value, "environments", ".yaml");
  }
  if (flag == "model" || flag == "from") {
    return own_file(value, "families", ".safetensors");
  }
  std::error_code error;
  return fs::is_regular_file(value, error) ? fs::path(value) : fs::path();
}

/// Of names and contents, of those files alone that an experiment reads (environments_in).
std::string fingerprint_of_environments(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".yaml") {
      files[with_other_bytes_escaped(entry.path().filename().string())] =
          fingerprint_of(entry.path());
    }
  }
  return content_hash(Json(files).dump());
}

Json description(const Campaign& campaign) {
  Json factors = Json::object();
  for (const CampaignFactor& factor : campaign.factors) {
    if (factor.range) {
      factors[factor.name] = {{"from", factor.range->from},
                              {"to", factor.range->to},
                              {"scale", int(factor.range->scale)}};
    } else {
      factors[factor.name] = factor.choices;
    }
  }
  return {{"schema", "limber/campaign_folder/1"},
          {"verb", campaign.verb},
          {"seed", campaign.seed},
          {"cpu", to_string(campaign.cpu)},
          {"flags", flags_to_json(campaign.flags)},
          {"factors", factors},
          {"repeat", campaign.repeat},
          {"random_count", campaign.random_count}};
}

/// Whether it is no folder, or holds what no campaign left. Other shards may be making it just now:
/// their temporary files begin with a dot.
bool holds_other_files(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    return true;
  }
  bool is_foreign = false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name == kCampaignFile || name == "units") {
      return false;
    }
    is_foreign = is_foreign || name.front() != '.';
  }
  return is_foreign;
}

}  // namespace

CampaignFolder::CampaignFolder(fs::path folder, const Campaign& campaign)
    : folder_(std::move(folder)), campaign_(campaign) {}

void CampaignFolder::prepare(bool force) const {
  const fs::path file = folder_ / kCampaignFile;
  const Json wanted = description(campaign_);
  if (fs::exists(file)) {
    // The order of keys says nothing.
    refuse_if(read_json_object(file) != nlohmann::json(wanted) && !force,
              "{}: of another campaign: choose another --out; or, where the file was changed on "
              "purpose, --force keeps the units that are still the same and makes the others",
              file.string());
  } else if (fs::exists(folder_) && !force && holds_other_files(folder_)) {
    throw InputError(
        fmt::format("{}: holds something else; choose another --out", folder_.string()));
  }
  if (!fs::exists(file) || force) {
    write_file_atomically(file, wanted.dump(1) + "\n");
  }
}

fs::path CampaignFolder::unit_folder(std::size_t index) const {
  return folder_ / "units" / fmt::format("{:03}", index / kFan) /
         fmt::format("{:03}", index % kFan);
}

UnitState CampaignFolder::state(const CampaignUnit& unit) {
  if (fs::exists(marker(unit, "done"))) {
    return UnitState::done;
  }
  if (fs::exists(marker(unit, "failed"))) {
    return UnitState::failed;
  }
  return fs::exists(marker(unit, "started")) ? UnitState::started : UnitState::waiting;
}

void CampaignFolder::require_none_finished_otherwise(
    const std::vector<std::size_t>& missing) const {
  for (const std::size_t index : missing) {
    std::error_code error;  // there is none yet
    for (const fs::directory_entry& entry : fs::directory_iterator(unit_folder(index), error)) {
      if (entry.path().filename().string().starts_with("done_")) {
        throw InputError(fmt::format(
            "{}: was finished with other input files, or by another version of limber; give those, "
            "or --force to make it again",
            unit_folder(index).string()));
      }
    }
  }
}

void CampaignFolder::begin(const CampaignUnit& unit) {
  const fs::path folder = unit_folder(unit.index);
  const bool goes_on = campaign_.verb == "train" && fs::exists(folder / kCheckpoint) &&
                       fs::exists(marker(unit, "started"));
  if (!goes_on && fs::exists(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      fs::remove_all(entry.path());  // not the folder itself, which may be locked
    }
  }
  fs::remove(marker(unit, "failed"));
  const Json json = {{"host", host_name()}, {"process", ::getpid()}};
  write_file_atomically(marker(unit, "started"), json.dump() + "\n");
}

void CampaignFolder::finish(const CampaignUnit& unit, const Json& result, double wall_time_s) {
  const Json json = {{"schema", "limber/campaign_unit/1"},
                     {"unit", unit.index},
                     {"varied", flags_to_json(unit.varied)},
                     {"result", result},
                     {"run", {{"host", host_name()}, {"wall_time_s", wall_time_s}}}};
  write_file_atomically(marker(unit, "done"), json.dump(1) + "\n");
  fs::remove(marker(unit, "started"));
}

void CampaignFolder::fail(const CampaignUnit& unit, int code) {
  write_file_atomically(marker(unit, "failed"), Json{{"code", code}}.dump() + "\n");
}

nlohmann::json CampaignFolder::result(const CampaignUnit& unit) {
  const fs::path path = marker(unit, "done");
  nlohmann::json found = read_json_object(path);
  const JsonReader reader(found, path.string());
  (void)reader.at("result");
  (void)reader.at("run").at("wall_time_s").number(0.0);
  return found;
}

fs::path CampaignFolder::marker(const CampaignUnit& unit, const char* state) {
  return unit_folder(unit.index) / fmt::format("{}_{}.json", state, identity(unit));
}

std::string CampaignFolder::identity(const CampaignUnit& unit) {
  Json inputs = Json::object();
  const auto add = [&](const std::string& flag, const std::string& value) {
    if (const std::string& found = fingerprint(flag, value); !found.empty()) {
      inputs[value] = found;
    }
  };
  for (const auto& [name, values] : unit.flags) {
    for (const std::string& value : values) {
      add(name, value);
    }
  }
  add(kArmFlag, arm_of(unit));
  if (campaign_.verb == "experiment" && values_in(unit.flags, kEnvironmentsFlag) == nullptr) {
    add(kEnvironmentsFlag, (data_folder() / "environments").string());
  }
  const Json json = {{"verb", campaign_.verb},
                     {"cpu", to_string(campaign_.cpu)},
                     {"version", version()},
                     {"flags", unit.flags},
                     {"inputs", inputs}};
  return content_hash(json.dump()).substr(0, kIdentityDigits);
}

const std::string& CampaignFolder::fingerprint(const std::string& flag, const std::string& path) {
  const auto [found, is_new] = fingerprints_.try_emplace({flag, path});
  std::error_code error;
  if (const fs::path file = is_new ? file_of(flag, path) : fs::path(); !file.empty()) {
    found->second = fingerprint_of(file);
  }
  // Values of other flags may be called like a folder by chance, such as the campaign's own.
  if (is_new && flag == kEnvironmentsFlag && fs::is_directory(path, error)) {
    found->second = fingerprint_of_environments(path);
  }
  return found->second;
}

std::vector<std::size_t> missing_units(const Campaign& campaign, CampaignFolder& folder) {
  std::vector<std::pair<double, std::size_t>> missing;
  for (std::size_t i = 0; i < unit_count(campaign); ++i) {
    const CampaignUnit unit = campaign_unit(campaign, i);
    if (folder.state(unit) != UnitState::done) {
      missing.emplace_back(-unit.cost, i);
    }
  }
  std::ranges::sort(missing);
  std::vector<std::size_t> order;
  for (const auto& [cost, unit] : missing) {
    order.push_back(unit);
  }
  return order;
}

}  // namespace limber
