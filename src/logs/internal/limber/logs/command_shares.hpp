#pragma once
// For those who read or write recordings.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/arm_description.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"

namespace limber {

/// What an arm's own commands make of its segments, found by regression (docs/importing.md).
struct CommandShares {
  /// For an arm file: those that move a segment. A segment's shares sum to 1 in magnitude, so that
  /// its command has the range of what makes it; its sign is that of the arm file.
  std::vector<ArmCommand> commands;
  std::vector<std::string> idle;  ///< columns that move nothing, as far as the logs tell
  /// Columns that always moved together, or against each other: what they do is split evenly.
  std::vector<std::pair<std::string, std::string>> alike;
  std::vector<double> explained;  ///< n: of the variance of each segment's turn, at most 1
  double lag_s = 0.0;             ///< of the arm behind its commands
};

/// Fits each segment's turn to all command columns of generic CSV logs, at 10 Hz, behind one lag.
/// Shares under a twentieth of their segment's largest, or within their 95 % interval, are left
/// out.
/// @param mapping  its command columns are the arm's own, as many as there are; each log holds them
/// @param arm      its `commands` do not count
/// @throws InputError as import_csv, where a segment follows none of the commands, and where some
/// segment would not be moved apart from those before it.
CommandShares find_command_shares(const std::vector<fs::path>& logs, const fs::path& mapping,
                                  const ArmDescription& arm);

/// @param arm  that they were found for
Json to_json(const CommandShares& shares, const ArmDescription& arm);
/// What was found, and the block for the arm file.
std::string to_text(const CommandShares& shares, const ArmDescription& arm);

}  // namespace limber
