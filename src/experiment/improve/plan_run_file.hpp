#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plan_runs.hpp"

namespace limber {

/// One run, as its part has it.
struct PlanRunPart {
  PlanRun run;
  std::optional<Episode> episode;
  bool is_on_disk = false;
};

/// Writes NAME.h5 (if something was recorded), then NAME.json, which says that the part is whole.
void write_part(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                const std::string& name, const PlanRunPart& part, std::uint64_t seed);
/// None if it is not there. @throws InputError if it is damaged.
std::optional<PlanRunPart> read_part(const std::filesystem::path& folder, const std::string& name,
                                     int environment);
/// "round_1/plans.parts/0003".
std::string part_name(const std::string& batch, int environment);
void remove_parts(OutputFolder& output, const std::string& batch, const PlanRuns& runs);

/// All runs of a batch: NAME.h5 (if anything was recorded), then NAME.json.
void write_joined(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                  const std::string& name, const PlanRuns& runs, std::uint64_t seed);

/// Lists joined files that are there already as the folder's own: a kill may have come between a
/// file and its entry.
void list_joined(OutputFolder& output, const std::string& name);

/// A recording of executed plans. @pre `episodes` is not empty
void write_episodes(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                    const std::string& name, const std::vector<Episode>& episodes,
                    std::uint64_t seed);

}  // namespace limber
