#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/backbone.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// Marker bodies seen in 3D, one row (x, y, z, qx, qy, qz, qw) each, base first, in the tracker's
/// own frame and unit. The unit quaternion turns the body's own axes into the tracker's.
using BodyPoses = Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor>;

/// The last four numbers of a row.
Eigen::Quaterniond rotation_of(const BodyPoses& bodies, Eigen::Index body);

/// The plane in which an arm moves, in the frame of a tracker that sees bodies in 3D. A body at
/// (x, y, θ) in the plane and at height h above it is at origin + x·x_axis + y·y_axis + h·normal,
/// and turned by F · Rot(z, θ) · M, with the axes (x_axis, y_axis, normal) as F's columns and M the
/// body's own rotation. Each body keeps its height.
struct TrackerPlane {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();   ///< in the tracker's unit
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();  ///< of length 1
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();  ///< of length 1, perpendicular to x_axis
  std::vector<Eigen::Quaterniond> body_rotations;     ///< M of each body
  double out_of_plane_m = 0.0;  ///< how far a body's height changed at most, while calibrating
  double tilt_rad = 0.0;        ///< how far one turned out of the plane at most

  Eigen::Vector3d normal() const { return x_axis.cross(y_axis); }
  /// F as a rotation.
  Eigen::Quaterniond axes() const;
};

/// (x, y, θ) of each body in the plane, lengths in the tracker's unit, θ in rad and within half a
/// turn. Heights and tilts are left out. @pre as many bodies as `body_rotations`
Backbone poses_in_plane(const TrackerPlane& plane, const BodyPoses& bodies);

/// How far each body is turned out of the plane, [rad] from 0 to π. @pre as above
Eigen::VectorXd tilts_rad(const TrackerPlane& plane, const BodyPoses& bodies);

/// The inverse of `poses_in_plane`. @param heights  of each body, in the tracker's unit
BodyPoses bodies_in_space(const TrackerPlane& plane, const Backbone& poses,
                          const Eigen::VectorXd& heights);

/// One of the wire's n pressures, and its direction: `sign` −1 where it counts the left side up.
struct WireChannel {
  int channel = 0;
  double sign = 1.0;
  bool operator==(const WireChannel&) const = default;
};

/// The segment whose channel that one is. @pre it is one of them
int segment_on(const std::vector<WireChannel>& channels, int channel);

/// A time and the interval that it lies in, [s].
struct TimeInterval {
  double value_s = 0.0;
  double low_s = 0.0;
  double high_s = 0.0;
};

/// How a tracker's poses become the backbone. A pose (x, y, θ) on the wire is that of a marker body
/// in the tracker's frame T. In metres and radians, and with y and θ turned over where T is
/// mirrored, body i's pose is X_TB · X_BPi · offset_i, with P_i plate i. Where the tracker sees in
/// 3D, T is the frame of the plane's axes.
struct TrackerCalibration {
  double metres_per_unit = 1.0;      ///< of x and y
  double radians_per_unit = 1.0;     ///< of θ; < 0 where it counts clockwise in T
  bool mirrored = false;             ///< T's y points to the right of its x, seen from above
  Pose base;                         ///< X_TB: frame B in T, once that is not mirrored
  std::vector<Pose> marker_offsets;  ///< of each body from its plate, in the plate's frame
  double position_interval_m = 0.0;  ///< of `base`, ±
  double heading_interval_rad = 0.0;
  std::optional<TrackerPlane> plane;  ///< where the wire has bodies in 3D
};

/// The clocks of limber, the driver and the tracker. For whoever reads recordings: limber applies
/// none of them.
struct ClockCalibration {
  std::optional<TimeInterval> driver;   ///< limber's clock = the driver's + this; none: simulated
  double driver_drift = 0.0;            ///< s of it per s
  std::optional<TimeInterval> tracker;  ///< the driver's clock = the tracker's + this
  /// A shape is so much older than the pressures beside it, the arm's own lag included.
  std::optional<TimeInterval> shape_delay;
};

/// What lies between the wire and the arm (docs/hardware.md): which of the wire's
/// numbers is which side of which segment, the sensors' zero, and the tracker's frame. Found by
/// `limber driver calibrate`, applied by limber wherever it talks to the driver.
///
/// Laws: from_wire(to_wire(state)) is `state` up to rounding, θ unwrapped along the arm; the
/// identity changes nothing.
struct WireCalibration {
  std::string arm;                            ///< its name
  double length_m = 0.0;                      ///< of the arm, to know it again
  std::vector<WireChannel> valves;            ///< of each segment: where its set point goes
  std::vector<WireChannel> sensors;           ///< of each segment: which reading is its pressure
  std::vector<double> zero_kpa;               ///< of each reading on the wire, with the arm vented
  std::vector<double> noise_kpa;              ///< standard deviation of each reading
  std::optional<TrackerCalibration> tracker;  ///< none: shapes pass as they are
  ClockCalibration clocks;

  /// Set points of the arm's segments as the wire's numbers, and back.
  Pressures to_wire(const Eigen::Ref<const Pressures>& setpoint_kpa) const;
  Pressures from_wire(const Eigen::Ref<const Pressures>& setpoint_kpa) const;
  /// What the driver says as what the arm does, and back.
  /// `bodies` stand in place of the state's backbone; they count as not seen where one is turned
  /// more than 0.5 rad out of the plane. @pre the tracker has a plane where there are some.
  ArmState from_wire(ArmState state, const std::optional<BodyPoses>& bodies = std::nullopt) const;
  ArmState to_wire(ArmState state) const;  ///< of a tracker in 3D: poses in its plane
  /// Limits of the wire's numbers as those of the segments, and back.
  std::vector<PressureLimits> from_wire(const std::vector<PressureLimits>& limits_kpa) const;
  std::vector<PressureLimits> to_wire(const std::vector<PressureLimits>& limits_kpa) const;
};

/// Nothing is crossed, turned or off zero.
WireCalibration identity_calibration(const ArmDescription& arm);

/// @throws InputError where `calibration` is another arm's: sizes or length differ.
void require_calibration_of(const WireCalibration& calibration, const ArmDescription& arm,
                            const std::string& file);

/// YAML, schema limber/driver_calibration/1. @throws InputError naming file, line and field.
WireCalibration read_wire_calibration(const fs::path& file);
WireCalibration parse_wire_calibration(const std::string& text, const std::string& name);
std::string to_yaml(const WireCalibration& calibration);

/// "segment 0: valve channel 2, left and right swapped; …": for people.
std::string in_words(const WireCalibration& calibration);

}  // namespace limber
