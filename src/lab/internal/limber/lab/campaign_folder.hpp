#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/lab/campaign.hpp"

namespace limber {

enum class UnitState { waiting, started, failed, done };

/// What a campaign leaves behind, made for file systems that many machines share: it needs no
/// locks, and no folder has more than 1000 entries.
///
///   campaign.json                     what the campaign is
///   units/KKK/NNN/                    of unit KKKNNN:
///     log.txt                         what it said
///     started_IDENTITY.json           host and process that began it
///     done_IDENTITY.json, or failed_  what came out, or its exit code
///
/// A unit's identity is in the names of its markers, so that a look tells whether it is done: no
/// marker of another command, input or version counts. Threads: one at a time.
class CampaignFolder {
 public:
  CampaignFolder(fs::path folder, const Campaign& campaign);

  /// Writes campaign.json. @throws InputError where the folder holds another campaign, or something
  /// else; with `force` another one's finished units stay where they are also this one's.
  void prepare(bool force) const;

  const fs::path& path() const { return folder_; }
  fs::path unit_folder(std::size_t index) const;
  UnitState state(const CampaignUnit& unit);

  /// @throws InputError where one of these units was finished with other inputs or by another
  /// version: `begin` would erase what it left.
  void require_none_finished_otherwise(const std::vector<std::size_t>& missing) const;

  /// An empty folder, but that a training goes on from its checkpoint. The folder stays the same,
  /// which the caller may have locked.
  void begin(const CampaignUnit& unit);
  /// Its last file.
  void finish(const CampaignUnit& unit, const Json& result, double wall_time_s);
  void fail(const CampaignUnit& unit, int code);

  /// What `finish` wrote: {"varied", "result", "run"}. @pre it is done
  nlohmann::json result(const CampaignUnit& unit);

 private:
  fs::path marker(const CampaignUnit& unit, const char* state);
  /// Of everything that decides what comes out: command, version, input files.
  std::string identity(const CampaignUnit& unit);
  /// Of the file that a flag names, of limber's own of that name, or of the environments in the
  /// folder.
  const std::string& fingerprint(const std::string& flag, const std::string& path);

  fs::path folder_;
  const Campaign& campaign_;
  /// Of flags' values; empty where one is no input.
  std::map<std::pair<std::string, std::string>, std::string> fingerprints_;
};

/// Units that are not done, dearest first: the last ones to end are then short.
std::vector<std::size_t> missing_units(const Campaign& campaign, CampaignFolder& folder);

}  // namespace limber
