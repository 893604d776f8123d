#include "limber/driver/wire_calibration.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

/// Rot(z, θ), and what tilts it: the body's rotation in the plane's axes, its own taken off.
Eigen::Quaterniond turn_in_plane(const TrackerPlane& plane, const BodyPoses& bodies,
                                 Eigen::Index body) {
  return plane.axes().conjugate() * rotation_of(bodies, body) *
         plane.body_rotations[body].conjugate();
}

Pressures gathered(const std::vector<WireChannel>& channels,
                   const Eigen::Ref<const Pressures>& on_wire) {
  Pressures result(Eigen::Index(channels.size()));
  for (std::size_t s = 0; s < channels.size(); ++s) {
    result[Eigen::Index(s)] = float(channels[s].sign) * on_wire[channels[s].channel];
  }
  return result;
}

Pressures scattered(const std::vector<WireChannel>& channels,
                    const Eigen::Ref<const Pressures>& of_segments) {
  Pressures result(Eigen::Index(channels.size()));
  for (std::size_t s = 0; s < channels.size(); ++s) {
    result[channels[s].channel] = float(channels[s].sign) * of_segments[Eigen::Index(s)];
  }
  return result;
}

PressureLimits turned(const PressureLimits& limits, double sign) {
  return sign > 0.0 ? limits : PressureLimits(-limits.upper_kpa, -limits.lower_kpa);
}

double y_sign(const TrackerCalibration& tracker) {
  return tracker.mirrored ? -1.0 : 1.0;
}

Backbone plates_of(const TrackerCalibration& tracker, const Backbone& bodies) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  Backbone plates(bodies.rows(), kPoseSize);
  double before_rad = 0.0;
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Pose& offset = tracker.marker_offsets[i];
    const Pose in_T{tracker.metres_per_unit * bodies(i, 0),
                    y_sign(tracker) * tracker.metres_per_unit * bodies(i, 1),
                    y_sign(tracker) * tracker.radians_per_unit * bodies(i, 2)};
    Pose plate = compose(between(tracker.base, in_T), between(offset, Pose{}));
    plate.theta_rad -= kTurn * std::round((plate.theta_rad - before_rad) / kTurn);
    before_rad = plate.theta_rad;
    plates.row(i) = numbers_of(plate).cast<float>();
  }
  return plates;
}

Backbone bodies_of(const TrackerCalibration& tracker, const Backbone& plates) {
  Backbone bodies(plates.rows(), kPoseSize);
  for (Eigen::Index i = 0; i < plates.rows(); ++i) {
    const Pose& offset = tracker.marker_offsets[i];
    const Pose plate = pose_of(plates.row(i).cast<double>());
    const Pose in_T = compose(tracker.base, compose(plate, offset));
    bodies.row(i) << float(in_T.x_m / tracker.metres_per_unit),
        float(y_sign(tracker) * in_T.y_m / tracker.metres_per_unit),
        float(y_sign(tracker) * in_T.theta_rad / tracker.radians_per_unit);
  }
  return bodies;
}

}  // namespace

int segment_on(const std::vector<WireChannel>& channels, int channel) {
  const auto found = std::ranges::find(channels, channel, &WireChannel::channel);
  return int(found - channels.begin());
}

Eigen::Quaterniond rotation_of(const BodyPoses& bodies, Eigen::Index body) {
  return {bodies(body, 6), bodies(body, 3), bodies(body, 4), bodies(body, 5)};
}

Eigen::Quaterniond TrackerPlane::axes() const {
  Eigen::Matrix3d columns;
  columns << x_axis, y_axis, normal();
  return Eigen::Quaterniond(columns);
}

Backbone poses_in_plane(const TrackerPlane& plane, const BodyPoses& bodies) {
  assert(bodies.rows() == Eigen::Index(plane.body_rotations.size()));
  Backbone poses(bodies.rows(), kPoseSize);
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Eigen::Vector3d from_origin = bodies.row(i).head<3>().transpose() - plane.origin;
    // The turn about z that is nearest to a rotation (w, x, y, z): 2 atan2(z, w).
    const Eigen::Quaterniond turn = turn_in_plane(plane, bodies, i);
    const double theta_rad =
        std::remainder(2.0 * std::atan2(turn.z(), turn.w()), 2.0 * std::numbers::pi);
    poses.row(i) << float(from_origin.dot(plane.x_axis)), float(from_origin.dot(plane.y_axis)),
        float(theta_rad);
  }
  return poses;
}

Eigen::VectorXd tilts_rad(const TrackerPlane& plane, const BodyPoses& bodies) {
  Eigen::VectorXd tilts(bodies.rows());
  for (Eigen::Index i = 0; i < bodies.rows(); ++i) {
    const Eigen::Quaterniond turn = turn_in_plane(plane, bodies, i);
    tilts[i] = 2.0 * std::atan2(std::hypot(turn.x(), turn.y()), std::hypot(turn.z(), turn.w()));
  }
  return tilts;
}

BodyPoses bodies_in_space(const TrackerPlane& plane, const Backbone& poses,
                          const Eigen::VectorXd& heights) {
  assert(poses.rows() == Eigen::Index(plane.body_rotations.size()));
  BodyPoses bodies(poses.rows(), 7);
  for (Eigen::Index i = 0; i < poses.rows(); ++i) {
    const Eigen::Vector3d position = plane.origin + double(poses(i, 0)) * plane.x_axis +
                                     double(poses(i, 1)) * plane.y_axis +
                                     heights[i] * plane.normal();
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(double(poses(i, 2)), Eigen::Vector3d::UnitZ()));
    const Eigen::Quaterniond rotation = plane.axes() * turn * plane.body_rotations[i];
    bodies.row(i) << position.transpose(), rotation.coeffs().transpose();  // x, y, z, w
  }
  return bodies;
}

Pressures WireCalibration::to_wire(const Eigen::Ref<const Pressures>& setpoint_kpa) const {
  return scattered(valves, setpoint_kpa);
}

Pressures WireCalibration::from_wire(const Eigen::Ref<const Pressures>& setpoint_kpa) const {
  return gathered(valves, setpoint_kpa);
}

ArmState WireCalibration::from_wire(ArmState state, const std::optional<BodyPoses>& bodies) const {
  constexpr double kMaxTiltRad = 0.5;  // more is no body of this arm
  if (bodies && tilts_rad(*tracker->plane, *bodies).maxCoeff() <= kMaxTiltRad) {
    state.backbone = poses_in_plane(*tracker->plane, *bodies);
  }
  const Eigen::Map<const Eigen::VectorXd> zero(zero_kpa.data(), state.pressure_kpa.size());
  state.pressure_kpa = gathered(sensors, state.pressure_kpa - zero.cast<float>());
  if (state.setpoint_kpa) {
    state.setpoint_kpa = gathered(valves, *state.setpoint_kpa);
  }
  if (state.backbone && tracker) {
    state.backbone = plates_of(*tracker, *state.backbone);
  }
  return state;
}

ArmState WireCalibration::to_wire(ArmState state) const {
  const Eigen::Map<const Eigen::VectorXd> zero(zero_kpa.data(), state.pressure_kpa.size());
  state.pressure_kpa = scattered(sensors, state.pressure_kpa) + zero.cast<float>();
  if (state.setpoint_kpa) {
    state.setpoint_kpa = scattered(valves, *state.setpoint_kpa);
  }
  if (state.backbone && tracker) {
    state.backbone = bodies_of(*tracker, *state.backbone);
  }
  return state;
}

std::vector<PressureLimits> WireCalibration::from_wire(
    const std::vector<PressureLimits>& limits_kpa) const {
  return mapped<PressureLimits>(valves, [&](const WireChannel& valve) {
    return turned(limits_kpa[valve.channel], valve.sign);
  });
}

std::vector<PressureLimits> WireCalibration::to_wire(
    const std::vector<PressureLimits>& limits_kpa) const {
  std::vector<PressureLimits> result(limits_kpa.size());
  for (std::size_t s = 0; s < valves.size(); ++s) {
    result[valves[s].channel] = turned(limits_kpa[s], valves[s].sign);
  }
  return result;
}

WireCalibration identity_calibration(const ArmDescription& arm) {
  WireCalibration calibration;
  calibration.arm = arm.name;
  calibration.length_m = arm.length_m();
  for (int s = 0; s < arm.segment_count(); ++s) {
    calibration.valves.push_back({s, 1.0});
  }
  calibration.sensors = calibration.valves;
  calibration.zero_kpa.assign(arm.segments.size(), 0.0);
  calibration.noise_kpa = calibration.zero_kpa;
  return calibration;
}

void require_calibration_of(const WireCalibration& calibration, const ArmDescription& arm,
                            const std::string& file) {
  constexpr double kSameLength = 0.01;  // of it: `characterize` fits lengths, too
  const auto refuse = [&](const std::string& what) {
    throw InputError(
        fmt::format("{}: calibration of arm '{}', {}; calibrate again: limber driver calibrate",
                    file, calibration.arm, what));
  };
  refuse_if(
      arm.is_spatial(),
      "{}: a calibration is of an arm in the plane; '{}' is in space, and its driver speaks of "
      "the arm's own channels and frame",
      file, arm.name);
  if (calibration.valves.size() != arm.segments.size()) {
    refuse(fmt::format("with {} segments; arm '{}' has {}", calibration.valves.size(), arm.name,
                       arm.segment_count()));
  }
  if (std::abs(calibration.length_m - arm.length_m()) > kSameLength * arm.length_m()) {
    refuse(fmt::format("{:.4g} m long; arm '{}' is {:.4g} m long", calibration.length_m, arm.name,
                       arm.length_m()));
  }
  const auto points = std::size_t(arm.point_count());
  if (calibration.tracker && calibration.tracker->marker_offsets.size() != points) {
    refuse(fmt::format("with {} marker bodies; arm '{}' has {} plates",
                       calibration.tracker->marker_offsets.size(), arm.name, points));
  }
}

}  // namespace limber
