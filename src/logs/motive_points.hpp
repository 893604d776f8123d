#pragma once

#include <string>

#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_tracks.hpp"
#include "motive_csv.hpp"

namespace limber {

/// The plates of an arm among what Motive tracked, in the plane that `mapping.up` leaves: by the
/// mapping's points, or, without any, all rigid bodies (markers, if there are none) in the order
/// of their names, if there are as many as plates.
/// @throws InputError, its message beginning with `log`, where an object is missing (with what is
/// there), or where the motion leaves that plane.
PointTracks motive_points(const std::string& log, const MotiveTake& take,
                          const ImportMapping& mapping, const ArmDescription& arm,
                          RunReport& report);

}  // namespace limber
