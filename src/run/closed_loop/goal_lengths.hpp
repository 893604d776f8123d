#pragma once

#include <Eigen/Core>

#include "limber/world/pose_goal.hpp"

namespace limber {

/// What a radian of heading counts as, where the heading counts as much as the position if each is
/// at its tolerance; 0 where the goal asks for no heading. [m/rad]
double m_per_rad(const PoseGoal& goal);
/// Both errors of a pose as one length.
double as_length_m(const PoseGoal& goal, const PoseError& error);
/// From a tip to the goal's centre: x, y and the heading as a length. [m]
Eigen::Vector3d missing_m(const PoseGoal& goal, const Pose& tip);

}  // namespace limber
