#include "shape_filter.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "limber/network/backbone_layout.hpp"

namespace limber {

namespace {

// What a frame's prediction misses, of an arm that the model knows: a fifth of how gaps usually
// change within a frame.
constexpr double kTurnRad = 0.0176;  // of the whole arm, if all gaps turn alike
constexpr double kStretch = 6e-4;    // of a gap's length
constexpr double kOffArc = 2e-4;
constexpr double kFramesAtStart = 25.0;  // the start is known as well as after so many

Eigen::MatrixXd growth_of(const Eigen::VectorXd& gap_length_m) {
  const Eigen::Index gaps = gap_length_m.size();
  const double arm_m = gap_length_m.sum();
  Eigen::MatrixXd growth = Eigen::MatrixXd::Zero(kPoseSize * gaps, kPoseSize * gaps);
  for (Eigen::Index g = 0; g < gaps; ++g) {
    const double length_m = gap_length_m[g];
    const double turn = std::pow(kTurnRad * length_m / arm_m, 2);
    const double aside_m = length_m / 2.0;  // per radian
    auto block = growth.block<kPoseSize, kPoseSize>(kPoseSize * g, kPoseSize * g);
    block(0, 0) = std::pow(kStretch * length_m, 2);
    block(1, 1) = std::pow(kOffArc * length_m, 2) + aside_m * aside_m * turn;
    block(1, 2) = block(2, 1) = aside_m * turn;
    block(2, 2) = turn;
  }
  return growth;
}

Eigen::VectorXd flat(const Backbone& backbone) {
  return backbone.cast<double>().reshaped<Eigen::RowMajor>();
}

/// How poses of the plates behind the base depend on gap poses, 3g×3g.
Eigen::MatrixXd jacobian_at(const Backbone& backbone) {
  const Eigen::Index gaps = backbone.rows() - 1;
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(kPoseSize * gaps, kPoseSize * gaps);
  for (Eigen::Index g = 0; g < gaps; ++g) {
    const double theta = double(backbone(g, 2));
    for (Eigen::Index i = g; i < gaps; ++i) {
      auto block = jacobian.block<kPoseSize, kPoseSize>(kPoseSize * i, kPoseSize * g);
      block(0, 0) = std::cos(theta);
      block(1, 0) = std::sin(theta);
      block(0, 1) = -std::sin(theta);
      block(1, 1) = std::cos(theta);
      block(0, 2) = -double(backbone(i + 1, 1) - backbone(g + 1, 1));
      block(1, 2) = double(backbone(i + 1, 0) - backbone(g + 1, 0));
      block(2, 2) = 1.0;
    }
  }
  return jacobian;
}

}  // namespace

ShapeFilter::ShapeFilter(Eigen::VectorXd gap_length_m, double noise_m)
    : gap_length_m_(std::move(gap_length_m)),
      noise_m_(noise_m),
      growth_(growth_of(gap_length_m_)),
      covariance_(kFramesAtStart * growth_) {}

Backbone ShapeFilter::corrected(const Backbone& predicted, const Backbone& measured) {
  const Eigen::Index gaps = predicted.rows() - 1;
  // In units of the noise, which is then the identity.
  Eigen::VectorXd weight(kPoseSize * gaps);
  for (Eigen::Index g = 0; g < gaps; ++g) {
    weight.segment<kPoseSize>(kPoseSize * g) << 1.0 / noise_m_, 1.0 / noise_m_,
        gap_length_m_[g] / noise_m_;
  }
  const Eigen::VectorXd expected = flat(predicted);
  const Eigen::VectorXd innovation =
      weight.cwiseProduct((flat(measured) - expected).tail(kPoseSize * gaps));
  const Eigen::MatrixXd jacobian = weight.asDiagonal() * jacobian_at(predicted);
  // If what is measured is farther off than covariance and noise have it, so that it no longer is.
  const double explained = (jacobian * covariance_).cwiseProduct(jacobian).sum();
  const double found = innovation.squaredNorm() - double(innovation.size());
  covariance_ *= std::max(1.0, found / explained);
  const Eigen::MatrixXd cross = covariance_ * jacobian.transpose();
  Eigen::MatrixXd spread = jacobian * cross;
  spread.diagonal().array() += 1.0;
  const Eigen::LLT<Eigen::MatrixXd> solver(spread);
  const Eigen::VectorXd change = cross * solver.solve(innovation);
  covariance_ -= cross * solver.solve(cross.transpose());
  covariance_ = 0.5 * (covariance_ + covariance_.transpose().eval());

  const Eigen::VectorXd gap_poses = gap_poses_of(expected) + change;
  const Eigen::VectorXd poses = base_poses_of(gap_poses);
  return poses.reshaped<Eigen::RowMajor>(predicted.rows(), kPoseSize).cast<float>();
}

}  // namespace limber
