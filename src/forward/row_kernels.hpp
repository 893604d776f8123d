#pragma once

#include "kernels/gap_bound.hpp"
#include "limber/common/cpu_level.hpp"

namespace limber {

/// Strain over pressure: a polynomial, and its end slope above the limit.
struct StrainCurve {
  float coefficient[4];  ///< c1 … c4, 1/kPa …
  float limit_kpa;
  float at_limit;
  float slope_per_kpa;  ///< above the limit, ≥ 0
};

/// What (3) and (4) need of one segment, in single precision.
struct NoLoadSegment {
  StrainCurve strain;
  float length_m;
  float width_m;
  int gaps;
  bool has_strain;           ///< (3) and (4); otherwise (17), or (18) with a factor of 0
  float curvature_per_unit;  ///< κ over the command, of (17)
};

/// What (25) needs of one chamber of an arm in space.
struct NoLoadChamber {
  StrainCurve strain;
  float sense;      ///< 1 or −1
  bool has_strain;  ///< else its strain is the command
};

/// What (26) and (24) need of an arm in space.
struct NoLoadInSpace {
  int segments;
  int channels;
  const NoLoadChamber* chambers;  ///< a channel each
  const float* shape;             ///< 3·segments rows of `channels` numbers
  const float* gap_length_m;      ///< of each segment, at rest
  const float* gap_share;         ///< one over the segment's number of gaps
};

/// Gaps of one kind of arm: their poses about the base and about the plate before.
struct GapKernels {
  int pose_size;  ///< numbers of a plate about the base
  int gap_size;   ///< numbers of a plate about the plate before it

  /// Base poses of gaps + 1 plates to the poses of the gaps about the plate before; and back.
  void (*encode)(int gaps, const float* base, float* gap, int stride);
  void (*decode)(int gaps, const float* gap, float* base, int stride);
  /// The same of one query whose numbers lie side by side.
  void (*encode_one)(int gaps, const float* base, float* gap);
  void (*decode_one)(int gaps, const float* gap, float* base);
  /// (20): gaps kept within their bounds; and those of one query.
  void (*bound)(int gaps, const GapBound<float>* bounds, float* gap, int stride);
  void (*bound_one)(int gaps, const GapBound<float>* bounds, float* gap);
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
  /// The same in space: commands' rows (channels) to rows (d, ω) of each segment's gaps.
  void (*no_load_space_gaps)(const NoLoadInSpace& arm, const float* command, float* gap,
                             int stride);
  GapKernels in_plane;
  GapKernels in_space;
  /// sum = a + b, `count` numbers.
  void (*add)(int count, const float* a, const float* b, float* sum);
  /// (16): next = previous + logistic(gate)·(no_load − previous) + change, `count` numbers. `next`
  /// may be any of the others.
  void (*gated_change)(int count, const float* previous, const float* no_load, const float* change,
                       const float* gate, float* next);

  /// (20) for base poses of gaps + 1 plates: the base plate goes to the origin.
  void (*bound_base)(int gaps, const GapBound<float>* bounds, float* base, int stride);
  void (*bound_base_of_one)(int gaps, const GapBound<float>* bounds, float* base);
};

/// The kernels of `level`. @pre this CPU runs it.
const RowKernels& row_kernels(CpuLevel level);

}  // namespace limber
