#pragma once

#include <Eigen/Core>

#include "limber/network/backbone_layout.hpp"
#include "limber/training/training_settings.hpp"

namespace limber {

/// A column whose numbers spread by less than this (kPa, m or rad) is constant: float32's rounding.
inline constexpr float kConstantSpread = 1e-6F;

/// Whether a row of poses or gaps is an angle.
using IsAngle = bool (*)(Eigen::Index row);
bool is_quaternion(Eigen::Index row);
IsAngle angles_of_states(const NetworkLayout& layout);
IsAngle angles_of_poses(const NetworkLayout& layout);

/// Least spread of the numbers of poses: a number that only noise moves would otherwise count as
/// much as the arm's end. Of their changes from frame to frame a tenth: below that they are
/// rounding. Of other numbers, which have no angles, any spread counts.
struct LeastSpread {
  IsAngle is_angle = nullptr;
  float share = 1.0F;
  float of(Eigen::Index row) const;
};
inline constexpr float kOfChanges = 0.1F;

/// Offset and scale of each row of `columns`.
Normalisation measure(const Eigen::MatrixXf& columns, Scaling scaling, LeastSpread least = {});

/// One range for all positions and one for all angles. The columns of the base plate, which never
/// moves, have no range of their own.
Normalisation joined_by_unit(const Eigen::MatrixXf& poses, IsAngle is_angle);

}  // namespace limber
