#pragma once

#include <string>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Finds frame B by `alignment`, fills in the report's axes, and moves all tracks into it.
/// A base that scatters by less than 5 mm is put at its median pose in every row: what it hides is
/// no loss.
/// @throws InputError, its message beginning with `log`, where the tip was never seen at rest, or
/// axes lie along each other.
void align_in_space(const std::string& log, const SpaceAlignment& alignment, SpaceTracks& tracks,
                    RunReport& report);

}  // namespace limber
