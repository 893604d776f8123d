#include "base_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace limber {

namespace {

constexpr int kBaseUnknowns = 3;  // x, y, heading
constexpr int kMaxIterations = 20;
constexpr double kModelErrorM = 5e-5;       // of hinges in the middle of gaps, beside the noise
constexpr double kOffsetDeviationM = 0.02;  // of a body from its plate, to begin with
constexpr double kAsymmetryShare =
    0.15;  // by which the two sides of a segment contract differently
constexpr double kMaxBaseMotionM = 0.003;
constexpr double kTwoDeviations = 2.0;

/// A shape to explain: mean poses, and which segment was under pressure, on which side.
struct HeldShape {
  const MeanPose* mean = nullptr;
  int segment = -1;  ///< −1: vented
  int side = 0;      ///< 0: the first pulse of a channel, 1: the second
};

class BaseFrameFit {
 public:
  BaseFrameFit(const ArmDescription& arm, const MeanPose& rest, const PoseNoise& noise,
               std::vector<HeldShape> shapes)
      : arm_(arm),
        along_m_(rest_positions_m(arm)),
        rest_(rest.pose),
        shapes_(std::move(shapes)),
        deviation_m_(
            std::hypot(kModelErrorM, noise.position_m / std::sqrt(shapes_[0].mean->count))) {}

  BaseFrame run() {
    Eigen::VectorXd unknowns = first_guess();
    Eigen::MatrixXd normal;
    Eigen::VectorXd residual = residuals(unknowns);
    for (int k = 0; k < kMaxIterations; ++k) {
      const Eigen::MatrixXd jacobian = derivatives(unknowns);
      normal = jacobian.transpose() * jacobian;
      const Eigen::VectorXd step = normal.ldlt().solve(-jacobian.transpose() * residual);
      unknowns += step;
      residual = residuals(unknowns);
      if (step.head<kBaseUnknowns>().norm() < 1e-10) {
        break;
      }
    }
    return finish(unknowns, normal, residual);
  }

 private:
  Eigen::Index bodies() const { return rest_.rows(); }
  Eigen::Index unknown_count() const { return kBaseUnknowns + 2 * arm_.segment_count(); }

  /// The line through the bodies at rest.
  Eigen::VectorXd first_guess() const {
    Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(unknown_count());
    const Eigen::RowVector2d centre = rest_.leftCols<2>().colwise().mean();
    Eigen::Vector2d direction = Eigen::Vector2d::Zero();
    double middle_m = 0.0;
    for (const double m : along_m_) {
      middle_m += m / static_cast<double>(along_m_.size());
    }
    for (Eigen::Index i = 0; i < bodies(); ++i) {
      direction += (along_m_[static_cast<std::size_t>(i)] - middle_m) *
                   (rest_.row(i).head<2>() - centre).transpose();
    }
    direction.normalize();
    unknowns.head<2>() = centre.transpose() - middle_m * direction;
    unknowns[2] = std::atan2(direction.y(), direction.x());
    return unknowns;
  }

  Eigen::Vector2d offset(const Eigen::VectorXd& unknowns, Eigen::Index body) const {
    const Eigen::Vector2d in_B = Eigen::Rotation2Dd(-unknowns[2]) *
                                 (rest_.row(body).head<2>().transpose() - unknowns.head<2>());
    return in_B - Eigen::Vector2d(along_m_[static_cast<std::size_t>(body)], 0.0);
  }

  /// By how much a gap of `segment` is shorter in `shape`.
  double contraction_m(const Eigen::VectorXd& unknowns, const HeldShape& shape, int segment) const {
    if (shape.segment != segment) {
      return 0.0;
    }
    const Eigen::Index at = kBaseUnknowns + 2 * segment;
    const double whole_m = unknowns[at] + (shape.side == 0 ? 1.0 : -1.0) * unknowns[at + 1];
    return whole_m / arm_.segments[static_cast<std::size_t>(segment)].gaps;
  }

  /// Where bodies are off what the unknowns say, over the noise; then what is known beforehand.
  Eigen::VectorXd residuals(const Eigen::VectorXd& unknowns) const {
    const Eigen::Index seen = static_cast<Eigen::Index>(shapes_.size()) * 2 * bodies();
    Eigen::VectorXd result(seen + 2 * bodies() + arm_.segment_count());
    Eigen::Index row = 0;
    const Eigen::Rotation2Dd turn(unknowns[2]);
    for (const HeldShape& shape : shapes_) {
      Eigen::Vector2d plate = Eigen::Vector2d::Zero();
      double theta_rad = 0.0;
      for (Eigen::Index i = 0; i < bodies(); ++i) {
        if (i > 0) {
          const auto to = static_cast<std::size_t>(i);
          const int segment = arm_.segment_of_gap(static_cast<int>(i) - 1);
          const double half_m =
              0.5 * (along_m_[to] - along_m_[to - 1] - contraction_m(unknowns, shape, segment));
          plate += half_m * Eigen::Vector2d(std::cos(theta_rad), std::sin(theta_rad));
          theta_rad = shape.mean->pose(i, 2) - rest_(i, 2);
          plate += half_m * Eigen::Vector2d(std::cos(theta_rad), std::sin(theta_rad));
        }
        const Eigen::Vector2d predicted =
            unknowns.head<2>() +
            turn * (plate + Eigen::Rotation2Dd(theta_rad) * offset(unknowns, i));
        result.segment<2>(row) =
            (shape.mean->pose.row(i).head<2>().transpose() - predicted) / deviation_m_;
        row += 2;
      }
    }
    for (Eigen::Index i = 0; i < bodies(); ++i, row += 2) {
      result.segment<2>(row) = offset(unknowns, i) / kOffsetDeviationM;
    }
    for (int s = 0; s < arm_.segment_count(); ++s, ++row) {
      const Eigen::Index at = kBaseUnknowns + 2 * s;
      // Half a millimetre where nothing contracts: what sides differ by is then no share of it.
      const double allowed_m = kAsymmetryShare * std::max(std::abs(unknowns[at]), 1e-4);
      result[row] = unknowns[at + 1] / allowed_m;
    }
    return result;
  }

  Eigen::MatrixXd derivatives(const Eigen::VectorXd& unknowns) const {
    constexpr double kStep = 1e-6;
    Eigen::MatrixXd jacobian;
    for (Eigen::Index k = 0; k < unknowns.size(); ++k) {
      Eigen::VectorXd up = unknowns;
      Eigen::VectorXd down = unknowns;
      up[k] += kStep;
      down[k] -= kStep;
      const Eigen::VectorXd column = (residuals(up) - residuals(down)) / (2.0 * kStep);
      if (k == 0) {
        jacobian.resize(column.size(), unknowns.size());
      }
      jacobian.col(k) = column;
    }
    return jacobian;
  }

  BaseFrame finish(const Eigen::VectorXd& unknowns, const Eigen::MatrixXd& normal,
                   const Eigen::VectorXd& residual) const {
    // Errors of the bodies of one shape go together, as headings' errors move all that follow.
    constexpr double kTogether = 2.0;
    const double scatter =
        kTogether * residual.squaredNorm() / static_cast<double>(residual.size() - unknowns.size());
    const Eigen::MatrixXd covariance =
        scatter * normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
    const Eigen::Matrix2d of_position = covariance.topLeftCorner<2, 2>();
    BaseFrame frame;
    frame.base = {unknowns[0], unknowns[1], std::remainder(unknowns[2], 2.0 * std::numbers::pi)};
    frame.position_interval_m =
        kTwoDeviations *
        std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(of_position).eigenvalues()[1]);
    frame.heading_interval_rad = kTwoDeviations * std::sqrt(covariance(2, 2));
    for (Eigen::Index i = 0; i < bodies(); ++i) {
      const Eigen::Vector2d at = offset(unknowns, i);
      frame.marker_offsets.push_back(
          {at.x(), at.y(), std::remainder(rest_(i, 2) - unknowns[2], 2.0 * std::numbers::pi)});
    }
    return frame;
  }

  const ArmDescription& arm_;
  std::vector<double> along_m_;
  Eigen::MatrixX3d rest_;
  std::vector<HeldShape> shapes_;
  double deviation_m_;
};

int segment_on(const std::vector<WireChannel>& valves, int channel) {
  const auto valve = std::find_if(valves.begin(), valves.end(),
                                  [&](const WireChannel& one) { return one.channel == channel; });
  return static_cast<int>(valve - valves.begin());
}

}  // namespace

BaseFrame base_frame(const ArmDescription& arm, const CalibrationLog& log, const SeenPoses& poses,
                     const std::vector<WireChannel>& valves) {
  const MeanPose rest = mean_pose(poses, 0, log.rest_end, "at rest");
  const std::vector<PulsePoses> pulses = pulse_poses(poses, log, arm.frame_period_s());
  std::vector<HeldShape> shapes;
  for (std::size_t k = 0; k < pulses.size(); ++k) {
    const double moved_m = (pulses[k].held.pose - rest.pose).row(0).head<2>().norm();
    if (moved_m > kMaxBaseMotionM) {
      throw CalibrationRefused(
          fmt::format("marker body 0 moved by {:.1f} mm while channel {} was at {:.3g} kPa; it has "
                      "to sit on the base, which stands still",
                      1e3 * moved_m, log.pulses[k].channel, log.pulses[k].setpoint_kpa));
    }
    shapes.push_back({&pulses[k].held, segment_on(valves, log.pulses[k].channel),
                      log.pulses[k].setpoint_kpa > 0.0 ? 0 : 1});
    shapes.push_back({&pulses[k].after, -1, 0});
  }
  return BaseFrameFit(arm, rest, pose_noise(poses, 0, log.rest_end), std::move(shapes)).run();
}

}  // namespace limber
