#include "limber/network/backbone_layout.hpp"

#include <cassert>

#include "limber/arm/space_pose.hpp"

namespace limber {

NetworkLayout::NetworkLayout(BackboneLayout layout, OutputForm form, const ArmDescription& arm,
                             bool reads_velocity, std::size_t past_commands)
    : layout_(layout),
      form_(form),
      reads_velocity_(reads_velocity),
      dimension_(arm.dimension),
      command_size_(arm.channel_count() * (1 + int(past_commands))),
      point_count_(arm.point_count()) {
  int gap = 0;
  for (const Segment& segment : arm.segments) {
    first_gap_.push_back(gap);
    gap += segment.gaps;
  }
}

int NetworkLayout::backbone_size() const {
  return layout_ == BackboneLayout::base_poses ? pose_size(dimension_) * point_count_
                                               : gap_size(dimension_) * (point_count_ - 1);
}

int NetworkLayout::no_load_size() const {
  return layout_ == BackboneLayout::base_poses ? pose_size(dimension_) * point_count_
                                               : gap_size(dimension_) * segment_count();
}

Eigen::MatrixXf NetworkLayout::encode(const Eigen::Ref<const Eigen::MatrixXf>& base_poses) const {
  assert(base_poses.rows() == pose_size(dimension_) * point_count_);
  if (layout_ == BackboneLayout::base_poses) {
    return base_poses;
  }
  return gap_poses_of(base_poses.cast<double>(), dimension_).cast<float>();
}

Eigen::MatrixXf NetworkLayout::decode(const Eigen::Ref<const Eigen::MatrixXf>& encoded) const {
  assert(encoded.rows() == backbone_size());
  if (layout_ == BackboneLayout::base_poses) {
    return encoded;
  }
  return base_poses_of(encoded.cast<double>(), dimension_).cast<float>();
}

Eigen::MatrixXf NetworkLayout::no_load_input(
    const Eigen::Ref<const Eigen::MatrixXf>& encoded) const {
  assert(encoded.rows() == backbone_size());
  if (layout_ == BackboneLayout::base_poses) {
    return encoded;
  }
  Eigen::MatrixXf rows(no_load_size(), encoded.cols());
  for (int i = 0; i < segment_count(); ++i) {
    const int size = gap_size(dimension_);
    rows.middleRows(size * i, size) = encoded.middleRows(size * first_gap(i), size);
  }
  return rows;
}

namespace {

/// What the two kinds of arms differ in.
struct PlaneNumbers {
  static constexpr int kPose = kPoseSize;
  static constexpr int kGap = kPoseSize;
  static Pose pose(const auto& numbers) { return pose_of(numbers); }
  static Pose step(const auto& gap) { return pose_of(gap); }
  static auto gap(const Pose& step) { return numbers_of(step); }
};
struct SpaceNumbers {
  static constexpr int kPose = kSpacePoseSize;
  static constexpr int kGap = kSpaceGapSize;
  static SpacePose pose(const auto& numbers) { return space_pose_of(numbers); }
  static SpacePose step(const auto& gap) { return step_of_gap(gap); }
  static auto gap(const SpacePose& step) { return gap_numbers_of(step); }
};

template <class Numbers>
Eigen::MatrixXd gaps_in(const Eigen::Ref<const Eigen::MatrixXd>& base_poses) {
  const Eigen::Index count = base_poses.rows() / Numbers::kPose - 1;
  Eigen::MatrixXd gaps(Numbers::kGap * count, base_poses.cols());
  for (Eigen::Index j = 0; j < base_poses.cols(); ++j) {
    const auto pose = [&](Eigen::Index plate) {
      return Numbers::pose(base_poses.col(j).segment<Numbers::kPose>(Numbers::kPose * plate));
    };
    for (Eigen::Index g = 0; g < count; ++g) {
      gaps.col(j).segment<Numbers::kGap>(Numbers::kGap * g) =
          Numbers::gap(between(pose(g), pose(g + 1)));
    }
  }
  return gaps;
}

template <class Numbers>
Eigen::MatrixXd poses_in(const Eigen::Ref<const Eigen::MatrixXd>& gap_poses) {
  const Eigen::Index count = gap_poses.rows() / Numbers::kGap;
  Eigen::MatrixXd base(Numbers::kPose * (count + 1), gap_poses.cols());
  for (Eigen::Index j = 0; j < gap_poses.cols(); ++j) {
    decltype(Numbers::step(gap_poses.col(j))) pose;
    base.col(j).head<Numbers::kPose>() = numbers_of(pose);
    for (Eigen::Index g = 0; g < count; ++g) {
      pose =
          compose(pose, Numbers::step(gap_poses.col(j).segment<Numbers::kGap>(Numbers::kGap * g)));
      base.col(j).segment<Numbers::kPose>(Numbers::kPose * (g + 1)) = numbers_of(pose);
    }
  }
  return base;
}

}  // namespace

Eigen::MatrixXd gap_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& base_poses,
                             Dimension dimension) {
  return dimension == Dimension::space ? gaps_in<SpaceNumbers>(base_poses)
                                       : gaps_in<PlaneNumbers>(base_poses);
}

Eigen::MatrixXd base_poses_of(const Eigen::Ref<const Eigen::MatrixXd>& gap_poses,
                              Dimension dimension) {
  return dimension == Dimension::space ? poses_in<SpaceNumbers>(gap_poses)
                                       : poses_in<PlaneNumbers>(gap_poses);
}

}  // namespace limber
