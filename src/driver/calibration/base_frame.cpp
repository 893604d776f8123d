#include "base_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "limber/arm/plate_distance.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"

namespace limber {

namespace {

constexpr int kBaseUnknowns = kPoseSize;
constexpr int kMaxIterations = 30;
constexpr double kModelErrorM = 2e-5;       // of hinges in the middle of gaps, beside the noise
constexpr double kGapErrorM = 4e-5;         // by which gaps of a segment contract unlike
constexpr double kAlikeShare = 0.1;         // by which a segment's contraction differs
constexpr double kMinUnlikeM = 2e-5;        // where nothing contracts
constexpr double kOffsetDeviationM = 0.01;  // of a body from its plate, where it is not known
constexpr double kKnownDeviationM = 3e-4;   // of what was measured as built
constexpr double kMaxBaseMotionM = 0.003;
constexpr double kTwoDeviations = 2.0;

/// A shape to explain: mean poses, and which segment was or had been under pressure.
struct HeldShape {
  const MeanPose* mean = nullptr;
  int segment = 0;
  bool vented = false;
};

class BaseFrameFit {
 public:
  BaseFrameFit(const ArmDescription& arm, const MeanPose& rest, const PoseNoise& noise,
               std::vector<HeldShape> shapes, const std::optional<Eigen::Vector2d>& base_marker)
      : arm_(arm),
        along_m_(rest_positions_m(arm)),
        rest_(rest.pose),
        shapes_(std::move(shapes)),
        base_marker_(base_marker) {
    const double noise_m = noise.position_m / std::sqrt(shapes_.front().mean->count);
    across_m_ = std::hypot(kModelErrorM, std::sqrt(2.0) * noise_m);
    along_gap_m_ = std::hypot(kGapErrorM, std::sqrt(2.0) * noise_m);
  }

  void run(TrackerCalibration& tracker) {
    Eigen::VectorXd unknowns = first_guess();
    weigh(unknowns);
    Eigen::MatrixXd normal;
    Eigen::VectorXd residual = residuals(unknowns);
    for (int k = 0; k < kMaxIterations; ++k) {
      const Eigen::MatrixXd jacobian = derivatives(unknowns, residual.size());
      normal = jacobian.transpose() * jacobian;
      const Eigen::VectorXd step = normal.ldlt().solve(-jacobian.transpose() * residual);
      unknowns += step;
      residual = residuals(unknowns);
      if (step.head<kBaseUnknowns>().norm() < 1e-9) {
        break;
      }
    }
    finish(unknowns, normal, residual, tracker);
  }

 private:
  Eigen::Index bodies() const { return rest_.rows(); }
  Eigen::Index unknown_count() const { return kBaseUnknowns + 2 * arm_.segment_count(); }

  /// The line through the bodies at rest.
  Eigen::VectorXd first_guess() const {
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(unknown_count());
    const Eigen::RowVector2d centre = rest_.leftCols<2>().colwise().mean();
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();
    const double middle_m = mean(along_m_);
    for (Eigen::Index i = 0; i < bodies(); ++i) {
      direction += (along_m_[i] - middle_m) * (rest_.row(i).head<2>() - centre).transpose();
    }
    direction.normalize();
    unknowns.head<2>() = centre.transpose() - middle_m * direction;
    unknowns[2] = std::atan2(direction.y(), direction.x());
    return unknowns;
  }

  /// Where a body is in frame B, were that where `unknowns` have it.
  static Eigen::Vector2d in_B(const Eigen::VectorXd& unknowns, const Eigen::MatrixX3d& poses,
                              Eigen::Index body) {
    const Pose pose = between(pose_of(unknowns.head<kPoseSize>()), pose_of(poses.row(body)));
    return {pose.x_m, pose.y_m};
  }

  Eigen::Vector2d offset(const Eigen::VectorXd& unknowns, Eigen::Index body) const {
    return in_B(unknowns, rest_, body) - Eigen::Vector2d(along_m_[body], 0.0);
  }

  /// Turn of a body since rest.
  double turn_rad(const HeldShape& shape, Eigen::Index body) const {
    return body == 0 ? 0.0 : shape.mean->pose(body, 2) - rest_(body, 2);
  }

  /// Where the plate of a body is in T, turned back into B's axes.
  Eigen::Vector2d plate(const Eigen::VectorXd& unknowns, const HeldShape& shape,
                        Eigen::Index body) const {
    return in_B(unknowns, shape.mean->pose, body) -
           Eigen::Rotation2Dd(turn_rad(shape, body)) * offset(unknowns, body);
  }

  /// Each gap of `shape`: by how much it is longer than at rest, and how far off its hinge's
  /// direction its end is.
  Eigen::MatrixX2d gaps(const Eigen::VectorXd& unknowns, const HeldShape& shape) const {
    Eigen::MatrixX2d result(bodies() - 1, 2);
    Eigen::Vector2d before = plate(unknowns, shape, 0);
    for (Eigen::Index g = 0; g + 1 < bodies(); ++g) {
      const auto at = std::size_t(g);
      const Eigen::Vector2d after = plate(unknowns, shape, g + 1);
      const double half_rad = 0.5 * (turn_rad(shape, g + 1) - turn_rad(shape, g));
      const double middle_rad = turn_rad(shape, g) + half_rad;
      const Eigen::Vector2d seen = Eigen::Rotation2Dd(-middle_rad) * (after - before);
      // Two straight halves that meet at the hinge.
      const double chord_m = (along_m_[at + 1] - along_m_[at]) * std::cos(half_rad);
      result.row(g) << seen.x() - chord_m, seen.y();
      before = after;
    }
    return result;
  }

  /// Unknown that `shape` makes `segment` shorter by, per gap; −1: none.
  Eigen::Index shortening(const HeldShape& shape, int segment) const {
    return shape.segment != segment ? -1 : kBaseUnknowns + 2 * segment + (shape.vented ? 1 : 0);
  }

  /// How unlike the contractions of a segment may be: a share of what pressure makes of it.
  void weigh(const Eigen::VectorXd& unknowns) {
    unlike_m_.assign(arm_.segments.size(), 0.0);
    for (const HeldShape& shape : shapes_) {
      if (!shape.vented) {
        const Eigen::MatrixX2d seen = gaps(unknowns, shape);
        const auto first =
            sum_of<Eigen::Index>(shape.segment, [&](int s) { return arm_.segments[s].gaps; });
        const auto s = std::size_t(shape.segment);
        const double mean_m = seen.col(0).segment(first, arm_.segments[s].gaps).mean();
        unlike_m_[s] = std::max({unlike_m_[s], kAlikeShare * std::abs(mean_m), kMinUnlikeM});
      }
    }
  }

  /// Over what they may be: gaps of each shape, then what is known of offsets beforehand.
  Eigen::VectorXd residuals(const Eigen::VectorXd& unknowns) const {
    Eigen::VectorXd result(Eigen::Index(shapes_.size()) * 2 * (bodies() - 1) + 2 * bodies());
    Eigen::Index row = 0;
    for (const HeldShape& shape : shapes_) {
      const Eigen::MatrixX2d seen = gaps(unknowns, shape);
      Eigen::Index first = 0;
      for (int s = 0; s < arm_.segment_count(); ++s) {
        const Eigen::Index count = arm_.segments[s].gaps;
        const Eigen::Index unknown = shortening(shape, s);
        Eigen::VectorXd along = seen.col(0).segment(first, count);
        along.array() += unknown < 0 ? 0.0 : unknowns[unknown];
        // Gaps go together by `unlike_m_`: their mean weighs less than their differences.
        const double ratio = unlike_m_[s] / along_gap_m_;
        const double mean_weight = 1.0 / std::sqrt(1.0 + double(count) * ratio * ratio);
        const double mean_m = along.mean();
        along.array() += (mean_weight - 1.0) * mean_m;
        result.segment(row, count) = along / along_gap_m_;
        result.segment(row + count, count) = seen.col(1).segment(first, count) / across_m_;
        row += 2 * count;
        first += count;
      }
    }
    for (Eigen::Index i = 0; i < bodies(); ++i, row += 2) {
      const bool known = i == 0 && base_marker_;
      result.segment<2>(row) =
          (offset(unknowns, i) - (known ? *base_marker_ : Eigen::Vector2d::Zero())) /
          (known ? kKnownDeviationM : kOffsetDeviationM);
    }
    return result;
  }

  /// Of so many residuals.
  Eigen::MatrixXd derivatives(const Eigen::VectorXd& unknowns, Eigen::Index count) const {
    constexpr double kStep = 1e-6;
    Eigen::MatrixXd jacobian(count, unknowns.size());
    for (Eigen::Index k = 0; k < unknowns.size(); ++k) {
      const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(unknowns.size(), k);
      jacobian.col(k) = (residuals(unknowns + step) - residuals(unknowns - step)) / (2.0 * kStep);
    }
    return jacobian;
  }

  void finish(const Eigen::VectorXd& unknowns, const Eigen::MatrixXd& normal,
              const Eigen::VectorXd& residual, TrackerCalibration& tracker) const {
    const double scatter =
        std::max(1.0, residual.squaredNorm() / double(residual.size() - unknowns.size()));
    const Eigen::MatrixXd covariance =
        scatter * normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
    const Eigen::Matrix2d of_position = covariance.topLeftCorner<2, 2>();
    tracker.base = {unknowns[0], unknowns[1], std::remainder(unknowns[2], 2.0 * std::numbers::pi)};
    tracker.position_interval_m =
        kTwoDeviations *
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(of_position).eigenvalues()[1]);
    tracker.heading_interval_rad = kTwoDeviations * std::sqrt(covariance(2, 2));
    for (Eigen::Index i = 0; i < bodies(); ++i) {
      const Eigen::Vector2d at = offset(unknowns, i);
      tracker.marker_offsets.push_back(
          {at.x(), at.y(), std::remainder(rest_(i, 2) - unknowns[2], 2.0 * std::numbers::pi)});
    }
  }

  const ArmDescription& arm_;
  std::vector<double> along_m_;
  Eigen::MatrixX3d rest_;
  std::vector<HeldShape> shapes_;
  std::optional<Eigen::Vector2d> base_marker_;
  double across_m_ = 0.0;
  double along_gap_m_ = 0.0;
  std::vector<double> unlike_m_;  // of each segment, per gap
};

}  // namespace

void fit_base_frame(const ArmDescription& arm, const CalibrationLog& log, const SeenPoses& poses,
                    const std::vector<WireChannel>& valves,
                    const std::optional<Eigen::Vector2d>& base_marker,
                    TrackerCalibration& tracker) {
  const MeanPose rest = mean_pose(poses, 0, log.rest_end, "at rest");
  const std::vector<PulsePoses> pulses = pulse_poses(poses, log, arm.frame_period_s());
  std::vector<HeldShape> shapes;
  for (std::size_t k = 0; k < pulses.size(); ++k) {
    const double moved_m = plate_distances_m(pulses[k].held.pose, rest.pose)[0];
    if (moved_m > kMaxBaseMotionM) {
      throw CalibrationRefused(
          fmt::format("marker body 0 moved by {:.1f} mm while channel {} was at {:.3g} kPa; it has "
                      "to sit on the base, which stands still",
                      1e3 * moved_m, log.pulses[k].channel, log.pulses[k].setpoint_kpa));
    }
    const int segment = segment_on(valves, log.pulses[k].channel);
    shapes.push_back({&pulses[k].held, segment, false});
    shapes.push_back({&pulses[k].after, segment, true});
  }
  BaseFrameFit(arm, rest, pose_noise(poses, 0, log.rest_end), std::move(shapes), base_marker)
      .run(tracker);
}

}  // namespace limber
