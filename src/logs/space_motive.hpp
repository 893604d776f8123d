#pragma once

#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "motive_csv.hpp"
#include "space_tracks.hpp"

namespace limber {

/// Bodies and markers of a take in the file's own axes, nothing projected.
/// @throws InputError naming what is missing, and what is there
SpaceTracks space_motive_tracks(const std::string& log, const MotiveTake& take,
                                const ImportMapping& mapping, const ArmDescription& arm,
                                RunReport& report);

}  // namespace limber
