#pragma once

#include <vector>

#include <Eigen/Core>

namespace limber {

/// The column for each row of `gain` (n×n, finite), none used twice, that sum to the most. The
/// Hungarian method, n³; of equal sums any.
std::vector<Eigen::Index> best_assignment(const Eigen::MatrixXd& gain);

/// Σ_i gain(i, column[i]).
double assigned_sum(const Eigen::MatrixXd& gain, const std::vector<Eigen::Index>& column);

}  // namespace limber
