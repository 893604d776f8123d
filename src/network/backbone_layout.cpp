#include "limber/network/backbone_layout.hpp"

#include <cassert>
#include <cmath>

namespace limber {

NetworkLayout::NetworkLayout(BackboneLayout layout, OutputForm form, const ArmDescription& arm,
                             bool reads_velocity)
    : layout_(layout),
      form_(form),
      reads_velocity_(reads_velocity),
      point_count_(arm.point_count()) {
  int gap = 0;
  for (const Segment& segment : arm.segments) {
    first_gap_.push_back(gap);
    gap += segment.gaps;
  }
}

int NetworkLayout::backbone_size() const {
  return layout_ == BackboneLayout::base_poses ? 3 * point_count_ : 3 * (point_count_ - 1);
}

int NetworkLayout::no_load_size() const {
  return layout_ == BackboneLayout::base_poses ? 3 * point_count_ : 3 * segment_count();
}

Eigen::MatrixXf NetworkLayout::encode(const Eigen::Ref<const Eigen::MatrixXf>& base_poses) const {
  assert(base_poses.rows() == 3 * point_count_);
  if (layout_ == BackboneLayout::base_poses) {
    return base_poses;
  }
  return gap_poses_of(base_poses.cast<double>()).cast<float>();
}

Eigen::MatrixXf NetworkLayout::decode(const Eigen::Ref<const Eigen::MatrixXf>& encoded) const {
  assert(encoded.rows() == backbone_size());
  if (layout_ == BackboneLayout::base_poses) {
    return encoded;
  }
  return base_poses_of(encoded.cast<double>()).cast<float>();
}

Eigen::MatrixXf NetworkLayout::no_load_input(
    const Eigen::Ref<const Eigen::MatrixXf>& encoded) const {
  assert(encoded.rows() == backbone_size());
  if (layout_ == BackboneLayout::base_poses) {
    return encoded;
  }
  Eigen::MatrixXf rows(no_load_size(), encoded.cols());
  for (int i = 0; i < segment_count(); ++i) {
    rows.middleRows(3 * i, 3) = encoded.middleRows(3 * first_gap(i), 3);
  }
  return rows;
}

Eigen::MatrixXd gap_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& base_poses) {
  Eigen::MatrixXd gaps(base_poses.rows() - 3, base_poses.cols());
  for (Eigen::Index j = 0; j < base_poses.cols(); ++j) {
    for (Eigen::Index i = 0; i < gaps.rows(); i += 3) {
      const Eigen::Vector3d from = base_poses.col(j).segment<3>(i);
      const Eigen::Vector3d step = base_poses.col(j).segment<3>(i + 3) - from;
      const double c = std::cos(from[2]);
      const double s = std::sin(from[2]);
      gaps.col(j).segment<3>(i) << c * step[0] + s * step[1], c * step[1] - s * step[0], step[2];
    }
  }
  return gaps;
}

Eigen::MatrixXd base_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& gap_poses) {
  Eigen::MatrixXd base = Eigen::MatrixXd::Zero(gap_poses.rows() + 3, gap_poses.cols());
  for (Eigen::Index j = 0; j < gap_poses.cols(); ++j) {
    for (Eigen::Index i = 0; i < gap_poses.rows(); i += 3) {
      const Eigen::Vector3d from = base.col(j).segment<3>(i);
      const Eigen::Vector3d step = gap_poses.col(j).segment<3>(i);
      const double c = std::cos(from[2]);
      const double s = std::sin(from[2]);
      base.col(j).segment<3>(i + 3) =
          from + Eigen::Vector3d(c * step[0] - s * step[1], s * step[0] + c * step[1], step[2]);
    }
  }
  return base;
}

}  // namespace limber
