#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "seen_poses.hpp"

namespace limber {

/// Where frame B lies in the tracker's, and where each body sits on its plate: from the straight
/// arm at rest, and from how the bodies turn about their segments in each pulse
/// (docs/hardware.md). At rest body i is at X_TB · (x_i, 0, 0) · offset_i. Once gaps turn by what
/// headings say, a hinge in the middle of each, the same offsets have to explain where it goes.
/// Across the arm that tells where the base is along it. Along the arm, pressure and friction make
/// gaps shorter: a segment's two sides alike up to a share, which tells where the arm's middle is.
///
/// `poses`: in metres, not mirrored.
/// @param base_marker  (x, y) of body 0 in frame B, where it is known as built
/// Fills `base` with its intervals, half of what is 95 % sure, and `marker_offsets`.
/// @throws CalibrationRefused where the base moves.
void fit_base_frame(const ArmDescription& arm, const CalibrationLog& log, const SeenPoses& poses,
                    const std::vector<WireChannel>& valves,
                    const std::optional<Eigen::Vector2d>& base_marker, TrackerCalibration& tracker);

}  // namespace limber
