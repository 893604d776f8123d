#include <algorithm>
#include <cmath>

#include "kernels/vector_sincos.hpp"
#include "limber/network/learnt_region.hpp"
#include "pressure_border.hpp"

namespace limber {

namespace {

int padded(int count, int lanes) {
  return (count + lanes - 1) / lanes * lanes;
}

// Each plate's pose about the plate before it, three numbers per gap. Four headings at a time:
// `headings`, `sines` and `cosines` hold whole vectors.
void write_gap_poses(const float* backbone, int gaps, int padded_gaps, float* headings,
                     float* poses) {
  float* sines = headings + padded_gaps;
  float* cosines = sines + padded_gaps;
  for (int j = 0; j < gaps; ++j) {
    headings[j] = backbone[kPoseSize * j + 2];
  }
  for (int j = 0; j < padded_gaps; j += kLanes) {
    Vector sine;
    Vector cosine;
    sincos(load(headings + j), sine, cosine);
    store(sines + j, sine);
    store(cosines + j, cosine);
  }
  for (int j = 0; j < gaps; ++j) {
    const float* at = backbone + kPoseSize * j;
    const float dx = at[kPoseSize] - at[0];
    const float dy = at[kPoseSize + 1] - at[1];
    poses[kPoseSize * j] = cosines[j] * dx + sines[j] * dy;
    poses[kPoseSize * j + 1] = cosines[j] * dy - sines[j] * dx;
    poses[kPoseSize * j + 2] = at[kPoseSize + 2] - at[2];
  }
}

}  // namespace

// |W z + b| in half ranges: row i of W is a pressure's 1 / half, or an axis about its middle.
NoveltyMeasure::NoveltyMeasure(const LearntRegion& region, CpuLevel level)
    : kernels_(&gemm_kernels(level)),
      segment_count_(region.segment_count()),
      point_count_(region.point_count()),
      joint_size_(static_cast<int>(region.joint_offset.size())),
      padded_rows_(padded(segment_count_ + static_cast<int>(region.axes.rows()), kernels_->lanes)),
      padded_gaps_(padded(point_count_ - 1, kLanes)),
      joint_change_(region.joint_change) {
  const int n = segment_count_;
  const int axis_count = static_cast<int>(region.axes.rows());
  Eigen::MatrixXd weight = Eigen::MatrixXd::Zero(padded_rows_, joint_size_);
  Eigen::VectorXd bias = Eigen::VectorXd::Zero(padded_rows_);
  const auto [middle, half] = pressure_border(region);
  for (int i = 0; i < n; ++i) {
    weight(i, i) = 1.0 / half[i];
    bias[i] = -middle[i] / half[i];
  }
  const auto [axis_middle, axis_half] = middle_and_half(region.axis_low, region.axis_high);
  weight.middleRows(n, axis_count) = axis_half.cwiseInverse().asDiagonal() *
                                     region.axes.cast<double>() *
                                     region.joint_scale.cast<double>().asDiagonal();
  bias.segment(n, axis_count) =
      -weight.middleRows(n, axis_count) * region.joint_offset.cast<double>() -
      axis_middle.cwiseQuotient(axis_half);
  weight_.resize(static_cast<std::size_t>(weight.size()));
  bias_.resize(static_cast<std::size_t>(bias.size()));
  Eigen::Map<Eigen::MatrixXf>(weight_.data(), padded_rows_, joint_size_) = weight.cast<float>();
  Eigen::Map<Eigen::VectorXf>(bias_.data(), padded_rows_) = bias.cast<float>();
}

NoveltyMeasure::Workspace NoveltyMeasure::make_workspace() const {
  const int size = padded_rows_ + 2 * padded(joint_size_, kLanes) + kPoseSize * padded_gaps_;
  return {AlignedFloats(static_cast<std::size_t>(size), 0.0F)};
}

float NoveltyMeasure::novelty(const float* pressures_kpa, const float* backbone,
                              Workspace& workspace) const {
  float* distances = workspace.numbers.data();
  float* joint = distances + padded_rows_;
  float* headings = joint + 2 * padded(joint_size_, kLanes);
  for (int i = 0; i < segment_count_; ++i) {
    joint[i] = pressures_kpa[i];
  }
  write_gap_poses(backbone, point_count_ - 1, padded_gaps_, headings, joint + segment_count_);
  kernels_->query_layer(padded_rows_, joint_size_, weight_.data(), joint, bias_.data(), false,
                        distances);
  return Eigen::Map<const Eigen::VectorXf>(distances, padded_rows_).cwiseAbs().maxCoeff();
}

float NoveltyMeasure::novelty(const float* pressures_kpa, const float* backbone,
                              const float* before_kpa, const float* backbone_before,
                              Workspace& workspace) const {
  const float standing = novelty(pressures_kpa, backbone, workspace);
  if (joint_change_.size() == 0) {
    return standing;
  }
  const float* joint = workspace.numbers.data() + padded_rows_;  // as `standing` left it
  float* before = workspace.numbers.data() + padded_rows_ + padded(joint_size_, kLanes);
  float* headings = before + padded(joint_size_, kLanes);
  for (int i = 0; i < segment_count_; ++i) {
    before[i] = before_kpa[i];
  }
  write_gap_poses(backbone_before, point_count_ - 1, padded_gaps_, headings,
                  before + segment_count_);
  float worst = standing;
  for (int i = 0; i < joint_size_; ++i) {
    worst = std::max(worst, std::abs(joint[i] - before[i]) / joint_change_[i]);
  }
  return worst;
}

}  // namespace limber
