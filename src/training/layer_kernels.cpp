#include "layer_kernels.hpp"

#include <cmath>

#include "limber/network/gemm_kernels.hpp"

namespace limber {

namespace {

template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
template <class Scalar>
using View = Eigen::Map<Matrix<Scalar>, 0, Eigen::OuterStride<>>;
template <class Scalar>
using ConstView = Eigen::Map<const Matrix<Scalar>, 0, Eigen::OuterStride<>>;

template <class Scalar>
ConstView<Scalar> view(const Scalar* data, int rows, int columns, int stride) {
  return {data, rows, columns, Eigen::OuterStride<>(stride)};
}

template <class Scalar>
View<Scalar> view(Scalar* data, int rows, int columns, int stride) {
  return {data, rows, columns, Eigen::OuterStride<>(stride)};
}

}  // namespace

template <class Scalar>
void LayerKernels<Scalar>::layer(int m, int n, int k, const Scalar* a, int lda, const Scalar* b,
                                 int ldb, const Scalar* bias, bool relu, Scalar* c, int ldc) {
  auto result = view(c, m, n, ldc);
  result.noalias() = view(a, m, k, lda) * view(b, k, n, ldb);
  result.colwise() += Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>(bias, m);
  if (relu) {
    result = result.cwiseMax(Scalar(0));
  }
}

template <class Scalar>
void LayerKernels<Scalar>::tn(int m, int n, int k, const Scalar* a, int lda, const Scalar* b,
                              int ldb, Scalar* c, int ldc) {
  view(c, m, n, ldc).noalias() = view(a, k, m, lda).transpose() * view(b, k, n, ldb);
}

template <class Scalar>
void LayerKernels<Scalar>::nt(int m, int n, int k, const Scalar* a, int lda, const Scalar* b,
                              int ldb, Scalar* c, int ldc) {
  view(c, m, n, ldc).noalias() = view(a, m, k, lda) * view(b, n, k, ldb).transpose();
}

template <class Scalar>
void LayerKernels<Scalar>::relu_gradient(int m, int n, const Scalar* activation, int ld_activation,
                                         Scalar* gradient, int ld_gradient) {
  auto result = view(gradient, m, n, ld_gradient);
  result = (view(activation, m, n, ld_activation).array() > Scalar(0)).select(result, Scalar(0));
}

template <class Scalar>
void LayerKernels<Scalar>::row_sums(int m, int n, const Scalar* a, int lda, Scalar* sums) {
  Eigen::Map<Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>(sums, m) =
      view(a, m, n, lda).rowwise().sum();
}

template <class Scalar>
void LayerKernels<Scalar>::sincos(int count, const Scalar* angle_rad, Scalar* sine,
                                  Scalar* cosine) {
  for (int i = 0; i < count; ++i) {
    sine[i] = std::sin(angle_rad[i]);
    cosine[i] = std::cos(angle_rad[i]);
  }
}

template <>
void LayerKernels<float>::layer(int m, int n, int k, const float* a, int lda, const float* b,
                                int ldb, const float* bias, bool relu, float* c, int ldc) {
  gemm_kernels().layer(m, n, k, a, lda, b, ldb, bias, relu, c, ldc);
}

template <>
void LayerKernels<float>::tn(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                             float* c, int ldc) {
  gemm_kernels().tn(m, n, k, a, lda, b, ldb, c, ldc, false);
}

template <>
void LayerKernels<float>::nt(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                             float* c, int ldc) {
  gemm_kernels().nt(m, n, k, a, lda, b, ldb, c, ldc, false);
}

template <>
void LayerKernels<float>::relu_gradient(int m, int n, const float* activation, int ld_activation,
                                        float* gradient, int ld_gradient) {
  gemm_kernels().relu_gradient(m, n, activation, ld_activation, gradient, ld_gradient);
}

template <>
void LayerKernels<float>::row_sums(int m, int n, const float* a, int lda, float* sums) {
  gemm_kernels().row_sums(m, n, a, lda, sums, false);
}

template <>
void LayerKernels<float>::sincos(int count, const float* angle_rad, float* sine, float* cosine) {
  gemm_kernels().sincos(count, angle_rad, sine, cosine);
}

template struct LayerKernels<double>;

}  // namespace limber
