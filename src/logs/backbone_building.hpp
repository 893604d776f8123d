#pragma once

#include <string>

#include "base_sighting.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_rows.hpp"

namespace limber {

/// Where these points have the base. @param tracks  in order of time
/// @pre is_base_sought(mapping.alignment)
/// @throws InputError as `build_backbone` does
BaseSighting sight_base(const std::string& log, PointTracks tracks, const ImportMapping& mapping,
                        const ArmDescription& arm);

/// The whole backbone in frame B from points tracked in a log's plane (docs/importing.md):
///
/// 1. a point missing for at most `mapping.longest_gap_s` is put on the straight line in time
///    between its neighbours, and the row is marked; rows within longer gaps are lost;
/// 2. frame B is found by `mapping.alignment`, and everything is turned and moved into it;
/// 3. headings are those measured, unwrapped along the arm, or those of the tangent, exact where
///    each segment is an arc;
/// 4. plates between two points are put on the curve that leaves and meets them along their
///    headings, an arc where an arc does.
///
/// @param tracks  in order of time (`put_in_order`); names appear in messages.
/// @throws InputError, its message beginning with `log`, where a point was never tracked, frame B
/// can't be found, or distances between points are not the arm's: another unit, order or arm.
BackboneTrack build_backbone(const std::string& log, PointTracks tracks,
                             const ImportMapping& mapping, const ArmDescription& arm,
                             RunReport& report);

}  // namespace limber
