#pragma once

#include "kernels/gap_bound.hpp"
#include "limber/common/cpu_level.hpp"

namespace limber {

/// What (3) and (4) need of one segment, in single precision.
struct NoLoadSegment {
  float strain_coefficient[4];  ///< c1 … c4, 1/kPa …
  float pressure_limit_kpa;
  float strain_at_limit;
  float slope_at_limit_per_kpa;  ///< ≥ 0
  float length_m;
  float width_m;
  int gaps;
  bool has_strain;           ///< (3) and (4); otherwise (17), or (18) with a factor of 0
  float curvature_per_unit;  ///< κ over the command, of (17)
};

/// The parts of a query that are not the network, for many queries at once: query q's number r is
/// at [r·stride + q], so that each vector instruction serves as many queries as it has lanes.
/// `stride` is a multiple of `lanes`; all of its columns are computed, used or not. One table per
/// CPU level; pure functions.
struct RowKernels {
  int lanes;

  /// `count` columns of `rows` numbers become rows; the columns from `count` to `stride` are filled
  /// with zeros.
  void (*gather)(int rows, int count, const float* columns, int ld, float* row, int stride);
  /// The inverse.
  void (*scatter)(int rows, int count, const float* row, int stride, float* columns, int ld);

  /// (3), (4): pressure rows (n) to the gap pose of each segment, rows (x, y, θ) × n.
  void (*no_load_gaps)(const NoLoadSegment* segments, int n, const float* pressure_kpa, float* gap,
                       int stride);
  /// Those chained: gap poses of the segments to base poses of all plates (3m rows).
  void (*chain_segments)(const NoLoadSegment* segments, int n, const float* gap, float* base,
                         int stride);
  /// Base poses of gaps + 1 plates to the poses of the gaps about the plate before; and back.
  void (*encode_gaps)(int gaps, const float* base, float* gap, int stride);
  void (*decode_gaps)(int gaps, const float* gap, float* base, int stride);
  /// The same of one query whose numbers lie side by side: 3(gaps + 1) and 3 gaps of them.
  void (*encode_gaps_of_one)(int gaps, const float* base, float* gap);
  void (*decode_gaps_of_one)(int gaps, const float* gap, float* base);
  /// sum = a + b, `count` numbers.
  void (*add)(int count, const float* a, const float* b, float* sum);
  /// (16): next = previous + logistic(gate)·(no_load − previous) + change, `count` numbers. `next`
  /// may be any of the others.
  void (*gated_change)(int count, const float* previous, const float* no_load, const float* change,
                       const float* gate, float* next);

  /// (20): gap poses (3 rows a gap) kept within their bounds; and those of one query.
  void (*bound_gaps)(int gaps, const GapBound<float>* bounds, float* gap, int stride);
  void (*bound_gaps_of_one)(int gaps, const GapBound<float>* bounds, float* gap);
  /// (20) for base poses of gaps + 1 plates: the base plate goes to the origin.
  void (*bound_base)(int gaps, const GapBound<float>* bounds, float* base, int stride);
  void (*bound_base_of_one)(int gaps, const GapBound<float>* bounds, float* base);
};

/// The kernels of `level`. @pre this CPU runs it.
const RowKernels& row_kernels(CpuLevel level);

}  // namespace limber
