#pragma once

#include <Eigen/Core>

namespace limber {

/// Matrix kernels of back-propagation, column-major with leading dimensions; queries are columns.
/// The float ones run on the network module's kernels (chosen for the CPU at run time), the double
/// ones on Eigen: those serve gradient checks.
template <class Scalar>
struct LayerKernels {
  /// C = A·B + bias, then max(·, 0) where `relu`. A m×k, B k×n, C m×n.
  static void layer(int m, int n, int k, const Scalar* a, int lda, const Scalar* b, int ldb,
                    const Scalar* bias, bool relu, Scalar* c, int ldc);
  /// C = Aᵀ·B with A stored k×m.
  static void tn(int m, int n, int k, const Scalar* a, int lda, const Scalar* b, int ldb, Scalar* c,
                 int ldc);
  /// C = A·Bᵀ with B stored n×k.
  static void nt(int m, int n, int k, const Scalar* a, int lda, const Scalar* b, int ldb, Scalar* c,
                 int ldc);
  /// gradient = 0 where activation ≤ 0. Both m×n.
  static void relu_gradient(int m, int n, const Scalar* activation, int ld_activation,
                            Scalar* gradient, int ld_gradient);
  /// sums(i) = Σ_j a(i, j), A m×n.
  static void row_sums(int m, int n, const Scalar* a, int lda, Scalar* sums);
  static void sincos(int count, const Scalar* angle_rad, Scalar* sine, Scalar* cosine);
};

}  // namespace limber
