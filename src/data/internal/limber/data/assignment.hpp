#pragma once

#include <vector>

#include <Eigen/Core>

namespace limber {

/// The column for each row of `gain` (n×n, finite), none used twice, that sum to the most. The
/// Hungarian method, n³; of equal sums any.
std::vector<Eigen::Index> best_assignment(const Eigen::MatrixXd& gain);

/// By how much the sum falls at least where two rows change columns; infinite for one row.
double assignment_margin(const Eigen::MatrixXd& gain, const std::vector<Eigen::Index>& column);

/// Σ_i gain(i, column[i]).
double assigned_sum(const Eigen::MatrixXd& gain, const std::vector<Eigen::Index>& column);

}  // namespace limber
