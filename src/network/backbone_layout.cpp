#include "limber/network/backbone_layout.hpp"

#include <cassert>

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
  return layout_ == BackboneLayout::base_poses ? kPoseSize * point_count_
                                               : kPoseSize * (point_count_ - 1);
}

int NetworkLayout::no_load_size() const {
  return layout_ == BackboneLayout::base_poses ? kPoseSize * point_count_
                                               : kPoseSize * segment_count();
}

Eigen::MatrixXf NetworkLayout::encode(const Eigen::Ref<const Eigen::MatrixXf>& base_poses) const {
  assert(base_poses.rows() == kPoseSize * point_count_);
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
    rows.middleRows<kPoseSize>(kPoseSize * i) =
        encoded.middleRows<kPoseSize>(kPoseSize * first_gap(i));
  }
  return rows;
}

Eigen::MatrixXd gap_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& base_poses) {
  Eigen::MatrixXd gaps(base_poses.rows() - kPoseSize, base_poses.cols());
  for (Eigen::Index j = 0; j < base_poses.cols(); ++j) {
    for (Eigen::Index i = 0; i < gaps.rows(); i += kPoseSize) {
      const Pose from = pose_of(base_poses.col(j).segment<kPoseSize>(i));
      const Pose to = pose_of(base_poses.col(j).segment<kPoseSize>(i + kPoseSize));
      gaps.col(j).segment<kPoseSize>(i) = numbers_of(between(from, to));
    }
  }
  return gaps;
}

Eigen::MatrixXd base_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& gap_poses) {
  Eigen::MatrixXd base(gap_poses.rows() + kPoseSize, gap_poses.cols());
  for (Eigen::Index j = 0; j < gap_poses.cols(); ++j) {
    Pose pose;
    base.col(j).head<kPoseSize>() = numbers_of(pose);
    for (Eigen::Index i = 0; i < gap_poses.rows(); i += kPoseSize) {
      pose = compose(pose, pose_of(gap_poses.col(j).segment<kPoseSize>(i)));
      base.col(j).segment<kPoseSize>(i + kPoseSize) = numbers_of(pose);
    }
  }
  return base;
}

}  // namespace limber
