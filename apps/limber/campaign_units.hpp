#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/lab/campaign_folder.hpp"

namespace limber {

/// The campaign's CPU level, for this process and all that it runs: its kernels, and the C
/// library's functions, which would give other last digits on another CPU. Starts the program again
/// where that has to be decided before it begins.
/// @throws InputError where this machine lacks the level.
void use_cpu_level(const Campaign& campaign);

/// The unit's command, as one would type it: verb, flags, and files in `folder`.
/// @param jobs  threads; as --jobs
std::vector<std::string> unit_command(const Campaign& campaign, const CampaignUnit& unit,
                                      const fs::path& folder, int jobs);

/// @throws InputError what the verb says of flags that it does not have, or that lack values.
void require_known_flags(const Campaign& campaign, const CampaignUnit& unit);

/// A forest that a unit grew would be another input to it when asked again.
/// @throws InputError where the file of a --forest is not there.
void require_forests(const Campaign& campaign);

/// @throws InputError where the arm has none of the unit's arm.PARAMETERs, or not of such a value.
void require_known_parameters(const CampaignUnit& unit);

/// Runs a unit in this process and leaves its marker; none where Ctrl-C cut it short. Standard
/// output and error go to its folder meanwhile. @return whether it was not a failure
bool run_unit(const Campaign& campaign, const CampaignUnit& unit, CampaignFolder& folder, int jobs);

/// Whether units that ran `experiment` differ in their environment alone, one file each.
bool can_join_experiments(const Campaign& campaign);

/// The table that one process would have made, of units that ran `experiment`.
/// @pre can_join_experiments
/// @return the exit code of that verb
int join_experiments(const Campaign& campaign, CampaignFolder& folder);

}  // namespace limber
