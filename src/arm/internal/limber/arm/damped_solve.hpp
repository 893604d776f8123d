#pragma once

#include <Eigen/Cholesky>

namespace limber {

/// x of (N + λI) x = r, by LDLᵀ: damped least squares. With N = AᵀA and r = Aᵀb it is the least of
/// |Ax − b|² + λ|x|²; where A is wide, Aᵀx is that with N = AAᵀ and r = b, from a smaller system.
/// @param normal   N, n×n, symmetric, positive semi-definite; the lower triangle is read
/// @param right    r, n×k
/// @param damping  λ ≥ 0; > 0 where N may be singular. Often a share of N's trace, so that scales
///                 do not matter.
template <class Normal, class Right>
typename Right::PlainObject damped_solve(const Eigen::MatrixBase<Normal>& normal,
                                         const Eigen::MatrixBase<Right>& right, double damping) {
  typename Normal::PlainObject damped = normal;
  damped.diagonal().array() += damping;
  return damped.ldlt().solve(right);
}

}  // namespace limber
