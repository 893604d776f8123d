#pragma once

#include <string>
#include <vector>

#include "base_sighting.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"

namespace limber {

/// Where the base is a point that stands still, it lies at its median pose in the rows that hide
/// it: these are no loss, and count as tracked.
void show_still_base(PointTracks& tracks, RunReport& report);

/// Whether the log says where the base is, not the mapping.
bool is_base_sought(const BaseAlignment& alignment);

/// @pre is_base_sought
/// @throws InputError, its message beginning with `log`, where frame B can't be found.
BaseSighting sight_base(const std::string& log, const std::vector<bool>& tracked,
                        const BaseAlignment& alignment, const ArmDescription& arm,
                        const PointTracks& tracks);

/// Turns and moves the tracks into frame B, found by `alignment` from the tracked rows. Adds the
/// base where it was not a point (fixed, none), and puts it exactly at the origin where it stood
/// still. Notes the pose found and the base's scatter.
/// @throws InputError, its message beginning with `log`, where frame B can't be found.
void align_base(const std::string& log, const std::vector<bool>& tracked,
                const BaseAlignment& alignment, const ArmDescription& arm, PointTracks& tracks,
                RunReport& report);

}  // namespace limber
