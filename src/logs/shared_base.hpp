#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_runs.hpp"
#include "space_tracks.hpp"

namespace limber {

/// A run, and how it is made poses.
template <class Tracks>
struct ReadRun {
  std::string name;  ///< in messages
  std::string command_log;
  RunOf<Tracks> run;
  ImportMapping mapping;
};

/// An arm stays bolted down from log to log: what each log alone gets wrong of where it points
/// would turn the same arm another way in every log. Logs whose bases agree get one, the median of
/// theirs, in their mappings; the others, which are noted, and all where most do not agree, keep
/// their own.
/// @return none where the mapping says where the base is, or nothing is shared
/// @throws InputError as `build_backbone` does
std::optional<LogsBase> share_base(const ImportMapping& mapping, const ArmDescription& arm,
                                   std::vector<ReadRun<PointTracks>>& runs);
std::optional<LogsBase> share_base(const ImportMapping& mapping, const ArmDescription& arm,
                                   std::vector<ReadRun<SpaceTracks>>& runs);

Json to_json(const LogsBase& shared);
/// A line. @param runs  all logs
std::string to_text(const LogsBase& shared, std::ptrdiff_t runs);

}  // namespace limber
