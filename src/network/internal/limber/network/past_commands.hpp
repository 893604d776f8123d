#pragma once

#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// So many frames ago a command that a network reads is at most.
inline constexpr int kMaxPastFrames = 1000;

/// How many frames ago the commands were that a network of `arm` reads beside the latest ones, by
/// default: in space, where valves, dead time and friction tell by them, and most recordings hold
/// set points alone. None in a plane, where valves are identified.
std::vector<int> default_past_commands(const ArmDescription& arm);

/// Commands n × T as a model is told them, n(1 + size) × T: under those of each frame stand those
/// of `past` frames before it. Before the first frame they were what they are there.
Eigen::MatrixXf with_past_commands(const Eigen::Ref<const Eigen::MatrixXf>& commands,
                                   const std::vector<int>& past);

}  // namespace limber
