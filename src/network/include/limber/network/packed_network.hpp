#pragma once
// For those who ask a model where the arm goes.

#include <vector>

#include "limber/common/aligned_floats.hpp"
#include "limber/common/cpu_level.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/gemm_kernels.hpp"

namespace limber {

/// The model's layers with its normalisations folded into the first and the last one (in double
/// precision): from numbers in the layout's units to numbers in the layout's units. @pre valid
std::vector<Layer> folded_layers(const CompensationModel& model);

/// A network ready for queries: normalisation is folded into the first and last layers (in double
/// precision), and weights are padded and stored once for single queries and once for batches.
///
/// Input and output are in the units of the backbone's layout, not normalised. A query's result is
/// the same to the bit alone or in a batch. Threads: constant after construction.
class PackedNetwork {
 public:
  /// @pre the model is valid and this CPU runs `level`.
  PackedNetwork(const CompensationModel& model, CpuLevel level);

  int input_size() const { return layers_.front().inputs; }
  int output_size() const { return layers_.back().outputs; }
  /// Numbers that the widest layer writes for one query, padded to whole vectors.
  int padded_width() const { return padded_width_; }
  /// Multiply-adds of one query, padding not counted.
  long multiply_adds() const { return multiply_adds(layer_count()); }
  /// Of the first `count` layers.
  long multiply_adds(int count) const;
  int layer_count() const { return int(layers_.size()); }

  /// One query. `input` holds input_size numbers; `scratch` 2·padded_width. Returns the output_size
  /// results, somewhere in `scratch`.
  const float* evaluate(const float* input, float* scratch) const;

  /// A few queries: `input` input_size×queries with `ld` ≥ input_size; `scratch`
  /// 2·padded_width·queries. Returns output_size×queries, columns padded_width apart, somewhere in
  /// `scratch`.
  const float* evaluate_columns(int queries, const float* input, int ld, float* scratch) const;

  /// Many queries along the rows: `input` input_size rows of `queries` numbers, row after row;
  /// `scratch` 2·padded_width·queries. Returns output_size such rows, somewhere in `scratch`.
  /// Fastest if `queries` is a multiple of the vector's lanes.
  const float* evaluate_rows(int queries, const float* input, float* scratch) const;

  /// The first `count` layers of `evaluate_rows` alone, for timing.
  const float* evaluate_layers_of_rows(int count, int queries, const float* input,
                                       float* scratch) const;

 private:
  struct PackedLayer {
    int inputs;
    int outputs;
    int padded_outputs;
    AlignedFloats weight;             // padded_outputs × inputs, column-major: for few queries
    AlignedFloats transposed_weight;  // inputs × outputs, column-major: for queries along rows
    AlignedFloats bias;               // padded_outputs
    bool relu;
  };

  const GemmKernels& kernels_;
  std::vector<PackedLayer> layers_;
  int padded_width_ = 0;
};

}  // namespace limber
