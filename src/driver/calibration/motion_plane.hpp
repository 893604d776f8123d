#pragma once

#include "limber/arm/arm_description.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "seen_poses.hpp"

namespace limber {

/// What a motion in a plane may be off it, beside noise.
inline constexpr double kMaxAxisOffDegrees = 3.0;  ///< of the axes of turns, and of positions' way
inline constexpr double kMaxOutOfPlaneM = 0.005;   ///< of a body's height, since rest

/// Whether states carry bodies in 3D. @throws CalibrationRefused where some carry backbones.
bool has_bodies(const CalibrationLog& log);

/// The plane in which bodies move. Its normal is the axis about which they turn in all pulses: the
/// one with the least squares of what turns have beside it, so that a turn weighs by its angle.
/// Positions then have to move across that axis. x_axis goes along the arm at rest, and the origin
/// is where body 0 rests. At rest every body's heading is 0.
///
/// Which of its two directions the normal has is a convention, since which one points up is a
/// question of handedness: its largest component is positive.
/// @throws CalibrationRefused where the motion leaves the plane by more than the figures above, or
/// nothing turned enough to see the axis.
TrackerPlane motion_plane(const ArmDescription& arm, const CalibrationLog& log);

/// `log` with the bodies' poses in the plane as backbones, in the tracker's unit and rad.
CalibrationLog in_plane(CalibrationLog log, const TrackerPlane& plane);

}  // namespace limber
