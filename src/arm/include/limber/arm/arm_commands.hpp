#pragma once
// For those who move an arm, real or virtual.

#include <string>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"

namespace limber {

// Inside limber a segment has one signed command c_i. An arm whose file lists `commands` has M of
// its own, u_k, which make them:
//
//     c_i = sum over k of S_ik u_k,    S_ik = commands[k].shares[i],    rank of S = n.
//
// All are in the arm's unit. `limber import` sums logs of u to c. Models, plans and the driver
// protocol know c alone; whoever drives such an arm asks `commands_for`.

/// S, n×M; the identity for an arm without `commands`.
Eigen::MatrixXd command_shares(const ArmDescription& arm);

/// c = S u. @param commands  M, in the order of the arm file. @throws InputError for another size.
Eigen::VectorXd segment_commands(const ArmDescription& arm,
                                 const Eigen::Ref<const Eigen::VectorXd>& commands);

/// The smallest u with S u = c, by its sum of squares: u = S^T (S S^T)^-1 c. An antagonistic pair
/// with the shares 1 and -1 gets c/2 and -c/2, one with 0.5 and -0.5 gets c and -c. What tightens
/// both sides alike moves no segment, and is the driver's to add.
/// @param segment_commands  n. @throws InputError for another size.
Eigen::VectorXd commands_for(const ArmDescription& arm,
                             const Eigen::Ref<const Eigen::VectorXd>& segment_commands);

/// A segment's sum for people: "motor_0 - motor_1", "0.5 motor_0 + 2 motor_3".
std::string command_sum(const ArmDescription& arm, int segment);

}  // namespace limber
