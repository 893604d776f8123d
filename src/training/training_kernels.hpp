#pragma once

#include "kernels/gap_bound.hpp"
#include "limber/common/cpu_level.hpp"

namespace limber {

/// StateBounds (window_gradient.hpp) as kernels see them.
template <class Scalar>
struct StateBoundsView {
  int gap_count;
  int gap_size;  ///< numbers of a gap (gap_size)
  bool of_base_poses;
  bool lead_back;
  const GapBound<Scalar>* gaps;
  const Scalar* scale;
  const Scalar* offset;
};

/// Kernels of back-propagation through windows: in float for one level of CPU features; in double
/// plain loops, which check gradients and are the reference for the others.
///
/// Windows lie along rows: number r of window j stands at [r·stride + j], so that each vector
/// instruction serves as many windows as it has lanes, whatever the network's sizes. A block is one
/// frame of `stride` windows; `stride` is a multiple of `lanes`, all of its places are computed.
/// Letters: m outputs, k inputs of a layer; its weight m×k, column-major without gaps. Every result
/// depends on the sizes given alone. Threads: pure functions, no allocation.
template <class Scalar>
struct WindowKernels {
  int lanes;  ///< floats in a vector register: 4, 8 or 16; double: 1

  /// y = W·x + bias for each window, then max(·, 0) where `relu`: x k×stride, y m×stride.
  void (*layer)(int stride, int m, int k, const Scalar* x, const Scalar* weight, const Scalar* bias,
                bool relu, Scalar* y);
  /// dx = Wᵀ·dy: dy m×stride, dx k×stride.
  void (*layer_back)(int stride, int m, int k, const Scalar* dy, const Scalar* weight, Scalar* dx);
  /// gradient += Σ_blocks dy·xᵀ, m×k: blocks follow each other, m·stride and `x_block` numbers
  /// apart.
  void (*weight_gradient)(int blocks, int stride, int m, int k, const Scalar* dy, const Scalar* x,
                          int x_block, Scalar* gradient);
  /// gradient += Σ_blocks Σ_windows dy, m numbers.
  void (*bias_gradient)(int blocks, int stride, int m, const Scalar* dy, Scalar* gradient);
  /// gradient = 0 if activation ≤ 0.
  void (*relu_gradient)(int count, const Scalar* activation, Scalar* gradient);
  /// y = gain ∘ max(y + shift, 0).
  void (*modulate)(int count, const Scalar* gain, const Scalar* shift, Scalar* y);
  /// Backward: dlog_gain += dy ∘ y; dy becomes that of y before; dshift += dy.
  void (*modulate_back)(int count, const Scalar* gain, const Scalar* y, Scalar* dy,
                        Scalar* dlog_gain, Scalar* dshift);

  /// rows[r·stride + j] = columns[index[j]·ld + r], r < row_count, j < stride.
  void (*gather)(int row_count, int stride, const Scalar* columns, int ld, const int* index,
                 Scalar* rows);
  /// state = uncompensated + scale ∘ output: `size` rows, one scale per row.
  void (*add_scaled)(int size, int stride, const Scalar* scale, const Scalar* output,
                     const Scalar* uncompensated, Scalar* state);
  /// carried += error; delta = scale ∘ carried.
  void (*carry)(int size, int stride, const Scalar* scale, const Scalar* error, Scalar* carried,
                Scalar* delta);

  /// gate = logistic(output's rows size … 2·size); state = previous + gate ∘ (uncompensated −
  /// previous) + scale ∘ output's first `size` rows.
  void (*gated_change)(int size, int stride, const Scalar* scale, const Scalar* output,
                       const Scalar* uncompensated, const Scalar* previous, Scalar* gate,
                       Scalar* state);
  /// Backward: with s = carried + direct + error, delta = (scale ∘ s, then s ∘ (uncompensated −
  /// previous) ∘ gate ∘ (1 − gate)), 2·size rows, and direct = (1 − gate) ∘ s.
  void (*gated_carry)(int size, int stride, const Scalar* scale, const Scalar* error,
                      const Scalar* uncompensated, const Scalar* previous, const Scalar* gate,
                      const Scalar* carried, Scalar* direct, Scalar* delta);

  /// (20): state = unbounded, kept within the bounds.
  void (*bound)(const StateBoundsView<Scalar>& bounds, int stride, const Scalar* unbounded,
                Scalar* state);
  /// Backward: the gradient by the state, carried + direct + error, becomes that by `unbounded`. It
  /// is left in the same three arrays, as their sum.
  void (*bound_back)(const StateBoundsView<Scalar>& bounds, int stride, const Scalar* unbounded,
                     Scalar* carried, Scalar* direct, Scalar* error);

  /// FrameError's sums and gradients (training/frame_error.hpp) of one block, both multiplied by
  /// `window_weight` (stride numbers).
  Scalar (*entry_error)(int size, int stride, const Scalar* weight, const Scalar* state,
                        const Scalar* target, const Scalar* window_weight, Scalar* gradient);
  /// `scratch`: 2·gaps·lanes numbers; in space kSpaceScratch·gaps·lanes.
  Scalar (*chained_error)(int gaps, int stride, const Scalar* weight, const Scalar* scale,
                          const Scalar* offset, const Scalar* state, const Scalar* target,
                          const Scalar* window_weight, Scalar* gradient, Scalar* scratch);
  Scalar (*space_chained_error)(int gaps, int stride, const Scalar* weight, const Scalar* scale,
                                const Scalar* offset, const Scalar* state, const Scalar* target,
                                const Scalar* window_weight, Scalar* gradient, Scalar* scratch);
};

/// The optimiser's operations on vectors of parameters, for one level of CPU features.
struct OptimiserKernels {
  /// sum += term; both `count` numbers.
  void (*add)(int count, const float* term, float* sum);
  /// Σ x², its partial sums in double.
  double (*square_sum)(int count, const float* x);
  /// One step of Adam (optimiser.hpp): `rate` is the learning rate over the first moment's bias,
  /// `root_bias2` one over the root of the second's.
  void (*adam)(int count, const float* gradient, float rate, float root_bias2, float* first_moment,
               float* second_moment, float* parameters);
};

/// The kernels of `level`, which this CPU must run; the level means nothing to double.
template <class Scalar>
const WindowKernels<Scalar>& window_kernels(CpuLevel level = cpu_level());
template <>
const WindowKernels<float>& window_kernels(CpuLevel level);
template <>
const WindowKernels<double>& window_kernels(CpuLevel level);
const OptimiserKernels& optimiser_kernels(CpuLevel level = cpu_level());

}  // namespace limber
