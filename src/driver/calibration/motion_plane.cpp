#include "motion_plane.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limber/common/units.hpp"
#include "limber/driver/calibration_log.hpp"
#include "seen_poses.hpp"

namespace limber {

namespace {

/// Mean positions and rotations of bodies in 3D, in the tracker's frame and unit, and how many
/// frames they are of.
struct MeanBodies {
  Eigen::MatrixX3d position;
  std::vector<Eigen::Quaterniond> rotation;
  int count = 0;
};

/// Standard deviations of one frame along and about each axis, from what changes between
/// neighbouring frames at rest.
struct BodyNoise {
  double position = 0.0;
  double rotation_rad = 0.0;
};

/// Axis times angle, [rad].
Eigen::Vector3d turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  const Eigen::AngleAxisd turn(to * from.conjugate());
  return turn.angle() * turn.axis();
}

/// Over frames `first` to `end` − 1. A mean rotation is the one nearest to all, in least squares of
/// quaternions, whose signs do not count.
/// @throws CalibrationRefused where fewer than three are seen.
MeanBodies mean_bodies(const CalibrationLog& log, std::size_t first, std::size_t end,
                       const char* when) {
  MeanBodies mean;
  std::vector<Eigen::Matrix4d> squares;
  for (std::size_t frame = first; frame < end; ++frame) {
    const std::optional<BodyPoses>& bodies = log.frames[frame].bodies;
    if (!bodies) {
      continue;
    }
    if (mean.count == 0) {
      mean.position.setZero(bodies->rows(), 3);
      squares.assign(std::size_t(bodies->rows()), Eigen::Matrix4d::Zero());
    }
    mean.position += bodies->leftCols<3>();
    for (Eigen::Index i = 0; i < bodies->rows(); ++i) {
      const Eigen::Vector4d q = bodies->row(i).tail<4>();
      squares[i] += q * q.transpose();
    }
    ++mean.count;
  }
  require_seen(mean.count, end - first, when);
  mean.position /= mean.count;
  for (const Eigen::Matrix4d& square : squares) {
    const Eigen::Vector4d q =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(square).eigenvectors().col(3);
    mean.rotation.emplace_back(q);
  }
  return mean;
}

BodyNoise body_noise(const CalibrationLog& log, std::size_t first, std::size_t end) {
  double positions = 0.0;
  double rotations = 0.0;
  int count = 0;
  for (std::size_t frame = first + 1; frame < end; ++frame) {
    const std::optional<BodyPoses>& before = log.frames[frame - 1].bodies;
    const std::optional<BodyPoses>& now = log.frames[frame].bodies;
    if (!before || !now) {
      continue;
    }
    positions += (*now - *before).leftCols<3>().squaredNorm();
    for (Eigen::Index i = 0; i < now->rows(); ++i) {
      rotations += turn_between(rotation_of(*before, i), rotation_of(*now, i)).squaredNorm();
      ++count;
    }
  }
  // Two neighbours differ by √2 of what one is off by, along and about three axes.
  const double axes = 2.0 * 3.0 * std::max(count, 1);
  return {std::sqrt(positions / axes), std::sqrt(rotations / axes)};
}

constexpr double kMinAxisTurnRad = 0.005;        // of the largest turn, to see an axis at all
constexpr double kNotAtAllDegrees = 90.0;        // what an axis that is not known is known to
constexpr double kMaxAxisIntervalDegrees = 1.0;  // to which the axis has to be known
constexpr double kMaxRestOffDegrees = 30.0;      // of the straight arm, whose bodies may be uneven
constexpr double kAxisNoiseFactor = 4.0;         // standard deviations that are put down to noise
constexpr const char* kIsItAQuaternion =
    "The arm has to bend in one plane. Is each quaternion [qx, qy, qz, qw], from the body's own "
    "axes to the tracker's?";

/// What one body did in one pulse.
struct SeenMotion {
  Eigen::Vector3d turn;   // axis times angle, [rad]
  Eigen::Vector3d moved;  // in the tracker's unit
};

/// Sum of v·vᵀ: its largest eigenvector is the direction which the vectors have in common.
class CommonDirection {
 public:
  void add(const Eigen::Vector3d& vector) { squares_ += vector * vector.transpose(); }
  Eigen::Vector3d direction() const {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(squares_).eigenvectors().col(2);
  }
  /// √Σ|v|².
  double length() const { return std::sqrt(squares_.trace()); }

 private:
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

class MotionPlaneFit {
 public:
  MotionPlaneFit(const ArmDescription& arm, const CalibrationLog& log)
      : log_(log),
        rest_(mean_bodies(log, 0, log.rest_end, "at rest")),
        pulses_(each_pulse<MeanBodies>(log, arm.frame_period_s(), [&](const FrameWindow& window) {
          return mean_bodies(log, window.first, window.end, window.when);
        })) {
    const BodyNoise noise = body_noise(log, 0, log.rest_end);
    const MeanBodies& before = pulses_.front().before;
    const MeanBodies& held = pulses_.front().held;
    const double of_means = std::sqrt(1.0 / before.count + 1.0 / held.count);
    turn_noise_rad_ = of_means * noise.rotation_rad;
    moved_noise_ = of_means * noise.position;
    for (const Pulse<MeanBodies>& pulse : pulses_) {
      std::vector<SeenMotion> motions;
      const Eigen::MatrixX3d moved = pulse.held.position - pulse.before.position;
      for (std::size_t i = 0; i < rest_.rotation.size(); ++i) {
        motions.push_back({turn_between(pulse.before.rotation[i], pulse.held.rotation[i]),
                           moved.row(Eigen::Index(i)).transpose()});
      }
      motions_.push_back(std::move(motions));
    }
    const double length = (rest_.position.bottomRows<1>() - rest_.position.topRows<1>()).norm();
    if (!(length > 0.0)) {
      throw CalibrationRefused("the first and the last marker body are seen at the same point");
    }
    metres_per_unit_ = arm.length_m() / length;  // about: enough to judge heights
  }

  TrackerPlane run() const {
    const Eigen::Vector3d normal = common_axis();
    require_one_axis(normal);
    require_motion_across(normal);
    TrackerPlane plane;
    plane.out_of_plane_m = largest_height_m(normal);
    plane.tilt_rad = largest_tilt_rad(normal);
    plane.origin = rest_.position.row(0).transpose();
    plane.x_axis = direction_at_rest(normal);
    plane.y_axis = normal.cross(plane.x_axis);
    const Eigen::Quaterniond axes = plane.axes();
    for (const Eigen::Quaterniond& rotation : rest_.rotation) {
      plane.body_rotations.push_back((axes.conjugate() * rotation).normalized());
    }
    return plane;
  }

 private:
  static double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return kDegPerRad * std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
  }

  std::string pulse_name(std::size_t pulse) const {
    return fmt::format("channel {} at {:.3g} kPa", log_.pulses[pulse].channel,
                       log_.pulses[pulse].setpoint_kpa);
  }

  Eigen::Vector3d common_axis() const {
    CommonDirection axis;
    double largest_rad = 0.0;
    for (const std::vector<SeenMotion>& of_pulse : motions_) {
      for (const SeenMotion& motion : of_pulse) {
        axis.add(motion.turn);
        largest_rad = std::max(largest_rad, motion.turn.norm());
      }
    }
    const double interval =
        axis.length() > 0.0 ? 2.0 * kDegPerRad * turn_noise_rad_ / axis.length() : kNotAtAllDegrees;
    if (largest_rad < kMinAxisTurnRad || interval > kMaxAxisIntervalDegrees) {
      throw CalibrationRefused(fmt::format(
          "marker bodies turned by at most {:.4f} rad, with noise of {:.4f} rad: the axis about "
          "which the arm bends is known to {:.1f}° only; expected {:g} rad or more, and {:g}° or "
          "less. Check supply, hoses and valves",
          largest_rad, turn_noise_rad_, std::min(interval, kNotAtAllDegrees), kMinAxisTurnRad,
          kMaxAxisIntervalDegrees));
    }
    Eigen::Vector3d normal = axis.direction();
    Eigen::Index largest = 0;
    normal.cwiseAbs().maxCoeff(&largest);
    return normal[largest] < 0.0 ? Eigen::Vector3d(-normal) : normal;
  }

  /// By how many degrees `own` is off `normal`, less what noise may do; 0 where noise hides it.
  double degrees_off(const CommonDirection& own, const Eigen::Vector3d& normal) const {
    const double noise = kAxisNoiseFactor * kDegPerRad * turn_noise_rad_ / own.length();
    if (own.length() < kMinAxisTurnRad || noise > kMaxAxisOffDegrees) {
      return 0.0;
    }
    return degrees_between(own.direction(), normal) - noise;
  }

  /// The turns of each body, and those of each pulse, about the axis of all.
  void require_one_axis(const Eigen::Vector3d& normal) const {
    double worst = 0.0;
    std::string who;
    std::vector<CommonDirection> of_bodies(rest_.rotation.size());
    const auto judge = [&](const CommonDirection& own, const std::string& name) {
      const double off = degrees_off(own, normal);
      if (off > worst) {
        worst = off;
        who = name;
      }
    };
    for (std::size_t p = 0; p < motions_.size(); ++p) {
      CommonDirection of_pulse;
      for (std::size_t i = 0; i < of_bodies.size(); ++i) {
        of_pulse.add(motions_[p][i].turn);
        of_bodies[i].add(motions_[p][i].turn);
      }
      judge(of_pulse, pulse_name(p) + " turns bodies");
    }
    for (std::size_t i = 0; i < of_bodies.size(); ++i) {
      judge(of_bodies[i], fmt::format("marker body {} turns", i));
    }
    if (worst > kMaxAxisOffDegrees) {
      throw CalibrationRefused(fmt::format(
          "{} about an axis {:.1f}° off the one of all turns; expected at most {:g}°. {}", who,
          worst, kMaxAxisOffDegrees, kIsItAQuaternion));
    }
  }

  /// The way that bodies move is across the axis about which they turn.
  void require_motion_across(const Eigen::Vector3d& normal) const {
    CommonDirection way;
    for (const std::vector<SeenMotion>& of_pulse : motions_) {
      for (const SeenMotion& motion : of_pulse) {
        way.add(motion.moved);
      }
    }
    const double noise = kAxisNoiseFactor * kDegPerRad * moved_noise_ / way.length();
    if (!(noise <= kMaxAxisOffDegrees)) {
      return;  // what moves too little is refused by name later
    }
    const double off = 90.0 - degrees_between(way.direction(), normal) - noise;
    if (off > kMaxAxisOffDegrees) {
      throw CalibrationRefused(fmt::format(
          "marker bodies move {:.1f}° out of the plane that they turn in; expected at most {:g}°. "
          "{}",
          off, kMaxAxisOffDegrees, kIsItAQuaternion));
    }
  }

  double largest_height_m(const Eigen::Vector3d& normal) const {
    double largest_m = 0.0;
    for (std::size_t p = 0; p < pulses_.size(); ++p) {
      for (const MeanBodies* seen : {&pulses_[p].held, &pulses_[p].after}) {
        const Eigen::VectorXd heights_m =
            metres_per_unit_ * ((seen->position - rest_.position) * normal).cwiseAbs();
        Eigen::Index body = 0;
        const double height_m = heights_m.maxCoeff(&body);
        const double noise_m = kAxisNoiseFactor * metres_per_unit_ * moved_noise_;
        if (height_m > kMaxOutOfPlaneM + noise_m) {
          throw CalibrationRefused(fmt::format(
              "marker body {} left the plane of the others by {:.1f} mm with {}; expected at most "
              "{:g} mm. Does the arm lift off its table, or is the body loose?",
              body, 1e3 * height_m, pulse_name(p), 1e3 * kMaxOutOfPlaneM));
        }
        largest_m = std::max(largest_m, height_m);
      }
    }
    return largest_m;
  }

  double largest_tilt_rad(const Eigen::Vector3d& normal) const {
    double largest_rad = 0.0;
    for (const std::vector<SeenMotion>& of_pulse : motions_) {
      for (const SeenMotion& motion : of_pulse) {
        largest_rad = std::max(largest_rad, motion.turn.cross(normal).norm());
      }
    }
    return largest_rad;
  }

  Eigen::Vector3d direction_at_rest(const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d along =
        (rest_.position.bottomRows<1>() - rest_.position.topRows<1>()).transpose();
    const double off = 90.0 - degrees_between(along, normal);
    if (off > kMaxRestOffDegrees) {
      throw CalibrationRefused(fmt::format(
          "the straight arm lies {:.1f}° out of the plane in which its bodies turn; expected at "
          "most {:g}°. {}",
          off, kMaxRestOffDegrees, kIsItAQuaternion));
    }
    return (along - along.dot(normal) * normal).normalized();
  }

  const CalibrationLog& log_;
  MeanBodies rest_;
  std::vector<Pulse<MeanBodies>> pulses_;
  std::vector<std::vector<SeenMotion>> motions_;  // of each pulse and body
  double turn_noise_rad_ = 0.0;                   // standard deviation of a turn, about each axis
  double moved_noise_ = 0.0;                      // of a motion, along each axis
  double metres_per_unit_ = 1.0;
};

}  // namespace

bool has_bodies(const CalibrationLog& log) {
  const auto bodies =
      std::ranges::count_if(log.frames, [](const auto& f) { return f.bodies.has_value(); });
  const auto backbones =
      std::ranges::count_if(log.frames, [](const auto& f) { return f.state.backbone.has_value(); });
  if (bodies > 0 && backbones > 0) {
    throw CalibrationRefused(
        fmt::format("{} states carry `bodies` and {} `backbone`: a driver sends one of the two",
                    bodies, backbones));
  }
  return bodies > 0;
}

TrackerPlane motion_plane(const ArmDescription& arm, const CalibrationLog& log) {
  return MotionPlaneFit(arm, log).run();
}

CalibrationLog in_plane(CalibrationLog log, const TrackerPlane& plane) {
  for (CalibrationFrame& frame : log.frames) {
    if (frame.bodies) {
      frame.state.backbone = poses_in_plane(plane, *frame.bodies);
      frame.bodies.reset();
    }
  }
  return log;
}

}  // namespace limber
