#include "limber/network/learnt_region.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/network/backbone_layout.hpp"
#include "pressure_border.hpp"
#include "refusal.hpp"

namespace limber {

namespace {

void require_vector(const std::string& where, const char* name, const Eigen::VectorXf& values,
                    Eigen::Index size) {
  if (values.size() != size) {
    refuse(where,
           fmt::format("tensor learnt.{} has {} numbers; expected {}", name, values.size(), size));
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    if (!std::isfinite(values[i])) {
      refuse(where, fmt::format("tensor learnt.{}[{}] is {}; expected a finite number", name, i,
                                values[i]));
    }
  }
}

/// Its pressures, then each plate's pose about the plate before it.
Eigen::VectorXd joint_vector(const Eigen::Ref<const Pressures>& pressures_kpa,
                             const Eigen::Ref<const Backbone>& backbone) {
  const Eigen::VectorXd flat = backbone.cast<double>().reshaped<Eigen::RowMajor>();
  Eigen::VectorXd joint(pressures_kpa.size() + flat.size() - kPoseSize);
  joint << pressures_kpa.cast<double>(), gap_poses_of(flat);
  return joint;
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
  require_vector(where, "pressures.low", region.low_kpa, n);
  require_vector(where, "pressures.high", region.high_kpa, n);
  require_vector(where, "rates.fall", region.steepest_fall_kpa_per_s, n);
  require_vector(where, "rates.rise", region.steepest_rise_kpa_per_s, n);
  require_vector(where, "joint.offset", region.joint_offset, joint);
  require_vector(where, "joint.scale", region.joint_scale, joint);
  if (region.axes.cols() != joint || region.axes.rows() > joint) {
    refuse(where, fmt::format("tensor learnt.axes.directions is {} × "
                              "{}; expected up to {} rows of {} numbers",
                              region.axes.rows(), region.axes.cols(), joint, joint));
  }
  if (!region.axes.allFinite()) {
    refuse(where, "tensor learnt.axes.directions holds a number that is not finite");
  }
  if (region.joint_change.size() > 0) {
    require_vector(where, "joint.change", region.joint_change, joint);
  }
  require_vector(where, "axes.low", region.axis_low, region.axes.rows());
  require_vector(where, "axes.high", region.axis_high, region.axes.rows());
  for (Eigen::Index i = 0; i < n; ++i) {
    if (region.low_kpa[i] > region.high_kpa[i]) {
      refuse(where, fmt::format("tensor learnt.pressures.low[{}] is {}, above its high of {}", i,
                                region.low_kpa[i], region.high_kpa[i]));
    }
    for (const auto& [name, rate] : {std::pair{"fall", region.steepest_fall_kpa_per_s[i]},
                                     std::pair{"rise", region.steepest_rise_kpa_per_s[i]}}) {
      if (rate < 0.0F) {
        refuse(where, fmt::format("tensor learnt.rates.{}[{}] is {}; expected ≥ 0", name, i, rate));
      }
    }
  }
  for (Eigen::Index i = 0; i < joint; ++i) {
    if (region.joint_scale[i] == 0.0F) {
      refuse(where, fmt::format("tensor learnt.joint.scale[{}] is 0; expected another", i));
    }
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

nlohmann::ordered_json to_json(const LearntRegion& region, const Command& command) {
  nlohmann::ordered_json segments = nlohmann::ordered_json::array();
  for (int i = 0; i < region.segment_count(); ++i) {
    segments.push_back(
        {{quantity_key(command, "low"), region.low_kpa[i]},
         {quantity_key(command, "high"), region.high_kpa[i]},
         {quantity_key(command, "steepest_fall") + "_per_s", region.steepest_fall_kpa_per_s[i]},
         {quantity_key(command, "steepest_rise") + "_per_s", region.steepest_rise_kpa_per_s[i]}});
  }
  return {{"segments", segments}, {"axes", region.axes.rows()}};
}

std::vector<std::string> learnt_region_lines(const LearntRegion& region, const Command& command) {
  const std::string& unit = command.unit;
  std::vector<std::string> lines;
  for (int i = 0; i < region.segment_count(); ++i) {
    lines.push_back(fmt::format("{}: {} {:.3g} … {:.3g} {}, rates {:.3g} … {:.3g} {}/s",
                                segment_name(i), command.name + "s", region.low_kpa[i],
                                region.high_kpa[i], unit, -region.steepest_fall_kpa_per_s[i],
                                region.steepest_rise_kpa_per_s[i], unit));
  }
  return lines;
}

}  // namespace limber
