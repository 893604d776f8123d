#pragma once
// For those who ask a model where the arm goes.

#include "limber/common/cpu_level.hpp"

namespace limber {

/// Single-precision matrix kernels for one level of CPU features, chosen once at run time; the
/// program itself is compiled for any CPU of its architecture.
///
/// Matrices are column-major with a leading dimension; no pointer needs alignment. C must not
/// overlap A or B. Every sum runs over k in ascending order in one accumulator, so an element of C
/// depends on its row of A and column of B alone: not on the other sizes or on its position.
/// Threads: pure functions, single-threaded, no allocation.
struct GemmKernels {
  int lanes;  ///< floats in a vector register: 4, 8 or 16

  /// A layer over n columns, C = A·B + bias, then max(·, 0) where `relu`: bias (m) is added per
  /// row. A is the weight, a column of B one query.
  void (*layer)(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                const float* bias, bool relu, float* c, int ldc);
  /// The same with queries along the rows: C = A·B + bias per column (n), A m×k one query a row, B
  /// k×n the transposed weight. Bit for bit the transpose of `layer`.
  void (*layer_of_rows)(int m, int n, int k, const float* a, int lda, const float* b, int ldb,
                        const float* bias, bool relu, float* c, int ldc);

  /// A layer for one query, y = A·x + bias, max(·, 0) where `relu`: m a multiple of `lanes`, A m×k
  /// without gaps between its columns. Skips the columns where x is 0, which after a ReLU is about
  /// every other one: half the weights never leave the second cache. A finite. Bit for bit `layer`.
  void (*query_layer)(int m, int k, const float* a, const float* x, const float* bias, bool relu,
                      float* y);

  /// `multiply_adds_per_round`·`rounds` independent multiply-adds that never leave the registers;
  /// time it to know the machine's peak. Returns a value that depends on all of them.
  float (*multiply_add)(long rounds);
  int multiply_adds_per_round;
};

/// The kernels of `level`. @pre this CPU runs it.
const GemmKernels& gemm_kernels(CpuLevel level = cpu_level());

}  // namespace limber
