#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan_runs.hpp"

namespace limber {

/// Runs of a batch, all or those of a part: NAME.h5 (if anything was recorded), then NAME.json,
/// which says that they are whole.
void write_plan_runs(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                     const std::string& name, const PlanRuns& runs, std::uint64_t seed);

/// A part: the runs of a chain, or its unsolved environments.
/// @param first  of its environments
/// @return none if it is not there. @throws InputError if it is damaged.
std::optional<PlanRuns> read_part(const OutputFolder& output, const std::string& batch, int first);
/// "round_1/plans.parts/0003".
std::string part_name(const std::string& batch, int first);
void remove_parts(OutputFolder& output, const std::string& batch, const PlanRuns& runs);

/// Lists joined files that are there already as the folder's own: a kill may have come between a
/// file and its entry.
void list_joined(OutputFolder& output, const std::string& name);

/// A recording of executed plans. @pre `episodes` is not empty
void write_episodes(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                    const std::string& name, const std::vector<Episode>& episodes,
                    std::uint64_t seed);

}  // namespace limber
