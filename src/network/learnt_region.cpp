#include "limber/network/learnt_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "kernels/vector_sincos.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/backbone_layout.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

struct MiddleAndHalf {
  Eigen::VectorXd middle;
  Eigen::VectorXd half;  ///< > 0
};

inline MiddleAndHalf middle_and_half(const Eigen::VectorXf& low, const Eigen::VectorXf& high) {
  return {0.5 * (low.cast<double>() + high.cast<double>()),
          0.5 * (high.cast<double>() - low.cast<double>())};
}

/// Where raw pressures are as novel as on the border: kPressureSlack beyond what was recorded. A
/// pressure that never moved counts as having moved by a thousandth of the widest range.
inline MiddleAndHalf pressure_border(const LearntRegion& region) {
  constexpr double kNarrowest = 1e-3;
  MiddleAndHalf border = middle_and_half(region.low_kpa, region.high_kpa);
  const double widest = border.half.maxCoeff();
  const double min_half = widest > 0.0 ? kNarrowest * widest : kNarrowest;
  border.half = (1.0 + kPressureSlack) * border.half.cwiseMax(min_half);
  return border;
}

/// Its pressures, then each plate's pose about the plate before it.
Eigen::VectorXd joint_vector(const Eigen::Ref<const Pressures>& pressures_kpa,
                             const Eigen::Ref<const Backbone>& backbone) {
  const Eigen::VectorXd flat = backbone.cast<double>().reshaped<Eigen::RowMajor>();
  Eigen::VectorXd joint(pressures_kpa.size() + flat.size() - kPoseSize);
  joint << pressures_kpa.cast<double>(), gap_poses_of(flat);
  return joint;
}

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

double LearntRegion::novelty(const Eigen::Ref<const Pressures>& pressures_kpa,
                             const Eigen::Ref<const Backbone>& backbone) const {
  const Eigen::VectorXd joint = joint_vector(pressures_kpa, backbone);
  const Eigen::VectorXd standard =
      (joint - joint_offset.cast<double>()).cwiseProduct(joint_scale.cast<double>());
  const Eigen::VectorXd along = axes.cast<double>() * standard;
  const auto [axis_middle, axis_half] = middle_and_half(axis_low, axis_high);
  double worst = 0.0;
  if (along.size() > 0) {
    worst = (along - axis_middle).cwiseQuotient(axis_half).cwiseAbs().maxCoeff();
  }
  const auto [middle, half] = pressure_border(*this);
  return std::max(
      worst, (pressures_kpa.cast<double>() - middle).cwiseQuotient(half).cwiseAbs().maxCoeff());
}

double LearntRegion::novelty(const Eigen::Ref<const Pressures>& pressures_kpa,
                             const Eigen::Ref<const Backbone>& backbone,
                             const Eigen::Ref<const Pressures>& before_kpa,
                             const Eigen::Ref<const Backbone>& backbone_before) const {
  const double standing = novelty(pressures_kpa, backbone);
  if (joint_change.size() == 0) {
    return standing;
  }
  const Eigen::VectorXd change =
      joint_vector(pressures_kpa, backbone) - joint_vector(before_kpa, backbone_before);
  return std::max(standing,
                  change.cwiseQuotient(joint_change.cast<double>()).cwiseAbs().maxCoeff());
}

void validate(const LearntRegion& region, int segment_count, int point_count,
              const std::string& where) {
  const Eigen::Index n = segment_count;
  const Eigen::Index joint = n + kPoseSize * (point_count - 1);
  require_vector(where, "learnt.pressures.low", region.low_kpa, n);
  require_vector(where, "learnt.pressures.high", region.high_kpa, n);
  require_vector(where, "learnt.rates.fall", region.steepest_fall_kpa_per_s, n);
  require_vector(where, "learnt.rates.rise", region.steepest_rise_kpa_per_s, n);
  require_vector(where, "learnt.joint.offset", region.joint_offset, joint);
  require_vector(where, "learnt.joint.scale", region.joint_scale, joint);
  refuse_if(region.axes.cols() != joint || region.axes.rows() > joint,
            "{}: tensor learnt.axes.directions is {} × {}; expected up to {} rows of {} numbers",
            where, region.axes.rows(), region.axes.cols(), joint, joint);
  refuse_if(!region.axes.allFinite(),
            "{}: tensor learnt.axes.directions holds a number that is not finite", where);
  if (region.joint_change.size() > 0) {
    require_vector(where, "learnt.joint.change", region.joint_change, joint);
  }
  require_vector(where, "learnt.axes.low", region.axis_low, region.axes.rows());
  require_vector(where, "learnt.axes.high", region.axis_high, region.axes.rows());
  for (Eigen::Index i = 0; i < n; ++i) {
    if (region.low_kpa[i] > region.high_kpa[i]) {
      refuse(where, fmt::format("tensor learnt.pressures.low[{}] is {}, above its high of {}", i,
                                region.low_kpa[i], region.high_kpa[i]));
    }
    for (const auto& [name, rate] : {std::pair{"fall", region.steepest_fall_kpa_per_s[i]},
                                     std::pair{"rise", region.steepest_rise_kpa_per_s[i]}}) {
      refuse_if(rate < 0.0F, "{}: tensor learnt.rates.{}[{}] is {}; expected ≥ 0", where, name, i,
                rate);
    }
  }
  for (Eigen::Index i = 0; i < joint; ++i) {
    refuse_if(region.joint_scale[i] == 0.0F,
              "{}: tensor learnt.joint.scale[{}] is 0; expected another", where, i);
    if (region.joint_change.size() > 0 && !(region.joint_change[i] > 0.0F)) {
      refuse(where, fmt::format("tensor learnt.joint.change[{}] is {}; expected more than 0", i,
                                region.joint_change[i]));
    }
  }
  for (Eigen::Index i = 0; i < region.axes.rows(); ++i) {
    if (region.axis_low[i] >= region.axis_high[i]) {
      refuse(where, fmt::format("tensor learnt.axes.low[{}] is {}; expected less than its high, {}",
                                i, region.axis_low[i], region.axis_high[i]));
    }
  }
}

Json to_json(const LearntRegion& region, const Command& command) {
  const auto segments = mapped<Json>(region.segment_count(), [&](int i) {
    return Json{
        {quantity_key(command, "low"), region.low_kpa[i]},
        {quantity_key(command, "high"), region.high_kpa[i]},
        {quantity_key(command, "steepest_fall") + "_per_s", region.steepest_fall_kpa_per_s[i]},
        {quantity_key(command, "steepest_rise") + "_per_s", region.steepest_rise_kpa_per_s[i]}};
  });
  return {{"segments", segments}, {"axes", region.axes.rows()}};
}

std::vector<std::string> learnt_region_lines(const LearntRegion& region, const Command& command) {
  const std::string& unit = command.unit;
  return mapped<std::string>(region.segment_count(), [&](int i) {
    return fmt::format("{}: {} {:.3g} … {:.3g} {}, rates {:.3g} … {:.3g} {}/s", segment_name(i),
                       command.name + "s", region.low_kpa[i], region.high_kpa[i], unit,
                       -region.steepest_fall_kpa_per_s[i], region.steepest_rise_kpa_per_s[i], unit);
  });
}

// |W z + b| in half ranges: row i of W is a pressure's 1 / half, or an axis about its middle.
NoveltyMeasure::NoveltyMeasure(const LearntRegion& region, CpuLevel level)
    : kernels_(&gemm_kernels(level)),
      segment_count_(region.segment_count()),
      point_count_(region.point_count()),
      joint_size_(int(region.joint_offset.size())),
      padded_rows_(padded(segment_count_ + int(region.axes.rows()), kernels_->lanes)),
      padded_gaps_(padded(point_count_ - 1, kLanes)),
      joint_change_(region.joint_change) {
  const int n = segment_count_;
  const int axis_count = int(region.axes.rows());
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
  weight_.resize(weight.size());
  bias_.resize(bias.size());
  Eigen::Map<Eigen::MatrixXf>(weight_.data(), padded_rows_, joint_size_) = weight.cast<float>();
  Eigen::Map<Eigen::VectorXf>(bias_.data(), padded_rows_) = bias.cast<float>();
}

NoveltyMeasure::Workspace NoveltyMeasure::make_workspace() const {
  const int size = padded_rows_ + 2 * padded(joint_size_, kLanes) + kPoseSize * padded_gaps_;
  return {AlignedFloats(std::size_t(size), 0.0F)};
}

float NoveltyMeasure::novelty(const float* pressures_kpa, const float* backbone,
                              Workspace& workspace) const {
  float* distances = workspace.numbers.data();
  float* joint = distances + padded_rows_;
  float* headings = joint + 2 * padded(joint_size_, kLanes);
  std::copy_n(pressures_kpa, segment_count_, joint);
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
  std::copy_n(before_kpa, segment_count_, before);
  write_gap_poses(backbone_before, point_count_ - 1, padded_gaps_, headings,
                  before + segment_count_);
  float worst = standing;
  for (int i = 0; i < joint_size_; ++i) {
    worst = std::max(worst, std::abs(joint[i] - before[i]) / joint_change_[i]);
  }
  return worst;
}

}  // namespace limber
