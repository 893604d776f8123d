#pragma once

#include <string>

#include "limber/arm/space_pose.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Frame B in the log's. @throws InputError as `align_in_space` does
SpacePose frame_in_log(const std::string& log, const SpaceAlignment& alignment,
                       const SpaceTracks& tracks);

/// Finds frame B by `alignment`, fills in the report's axes, and moves all tracks into it.
/// A base that scatters by less than 5 mm is put at its median pose in every row: what it hides is
/// no loss.
/// @throws InputError, its message beginning with `log`, where the tip was never seen at rest, or
/// axes lie along each other.
void align_in_space(const std::string& log, const SpaceAlignment& alignment, SpaceTracks& tracks,
                    RunReport& report);

}  // namespace limber
