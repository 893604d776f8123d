#pragma once

#include <string>

#include "limber/arm/space_pose.hpp"
#include "space_tracks.hpp"

namespace limber {

/// The end of the arc that leaves the origin along x and ends at `point`: docs/model.md. It does
/// not twist. @pre point is not 0
SpacePose arc_to(const Eigen::Vector3d& point);

/// That part of the way to `step` along the curve of constant strain between both: an arc, where
/// `step` is the end of one. @param part  0 to 1
SpacePose along(const SpacePose& step, double part);

/// The whole backbone in frame B from points tracked in space (docs/importing.md): rotations that
/// jump are settled (rotation_flips.hpp), frame B is found (space_alignment.hpp), points missing
/// for at most `mapping.longest_gap_s` are put between their neighbours in time, poses are lifted
/// from positions where no rotations were logged, and plates between points are put on the curve of
/// constant strain.
/// @param tracks  in order of time
/// @return poses T×7m, quaternions without jumps of sign
/// @throws InputError, its message beginning with `log`, where a point was never tracked, frame B
/// can't be found, or distances and directions between points are not the arm's.
BackboneTrack build_backbone(const std::string& log, SpaceTracks tracks,
                             const ImportMapping& mapping, const ArmDescription& arm,
                             RunReport& report);

}  // namespace limber
