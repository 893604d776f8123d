#pragma once

// RowKernels for the instruction set that the including file is compiled for (see
// kernels/vector_float.hpp). Every multiply-add is spelt out, so a query's result is the same to
// the bit in whichever lane it is computed.

#include <cstddef>

#include "kernels/gap_bound.hpp"
#include "kernels/vector_float.hpp"
#include "kernels/vector_logistic.hpp"
#include "kernels/vector_sincos.hpp"
#include "limber/arm/pose_size.hpp"
#include "row_kernels.hpp"
#include "space_row_kernels.hpp"
#include "strain_kernel.hpp"

namespace limber {
namespace {

struct Rotation {
  Vector cosine;
  Vector sine;
};

inline Rotation rotation_of(Vector angle) {
  Rotation r;
  sincos(angle, r.sine, r.cosine);
  return r;
}

// The rotation by the sum of both angles.
inline Rotation then(Rotation a, Rotation b) {
  return {multiply_add(a.cosine, b.cosine, -(a.sine * b.sine)),
          multiply_add(a.sine, b.cosine, a.cosine * b.sine)};
}

void gather(int rows, int count, const float* columns, int ld, float* row, int stride) {
  for (int q = 0; q < count; ++q) {
    const float* column = columns + std::ptrdiff_t(q) * ld;
    for (int r = 0; r < rows; ++r) {
      row[r * stride + q] = column[r];
    }
  }
  for (int r = 0; r < rows && count < stride; ++r) {
    for (int q = count; q < stride; ++q) {
      row[r * stride + q] = 0.0F;
    }
  }
}

void scatter(int rows, int count, const float* row, int stride, float* columns, int ld) {
  for (int q = 0; q < count; ++q) {
    float* column = columns + std::ptrdiff_t(q) * ld;
    for (int r = 0; r < rows; ++r) {
      column[r] = row[r * stride + q];
    }
  }
}

void no_load_gaps(const NoLoadSegment* segments, int n, const float* pressure_kpa, float* gap,
                  int stride) {
  for (int i = 0; i < n; ++i) {
    const NoLoadSegment& s = segments[i];
    const float gap_length = s.length_m / float(s.gaps);
    for (int q = 0; q < stride; q += kLanes) {
      const Vector pressure = load(pressure_kpa + i * stride + q);
      Vector e{};
      Vector turn;  // half of what a gap turns by, without its sign
      Vector half;
      if (s.has_strain) {
        e = strain_of(s.strain, pressure);
        // κ l = e l0/t, negative where the right side is inflated; half of a gap's share of it.
        turn = e * broadcast(0.5F * gap_length / s.width_m);
        half = select(pressure > Vector{}, -turn, turn);
      } else {
        half = pressure * broadcast(0.5F * gap_length * s.curvature_per_unit);
        turn = absolute(half);
      }
      const Rotation chord = rotation_of(half);
      // The chord of an arc: its length times sin(h)/h, along its middle.
      const Vector series = multiply_add(half * half, broadcast(-1.0F / 6.0F), broadcast(1.0F));
      const Vector sinc = select(turn < broadcast(1e-3F), series, chord.sine / half);
      const Vector length =
          multiply_add(e, broadcast(-0.5F), broadcast(1.0F)) * broadcast(gap_length) * sinc;
      float* out = gap + kPoseSize * i * stride + q;
      store_vector3(out, stride, {length * chord.cosine, length * chord.sine, half + half});
    }
  }
}

void chain_segments(const NoLoadSegment* segments, int n, const float* gap, float* base,
                    int stride) {
  for (int q = 0; q < stride; q += kLanes) {
    float* out = base + q;
    Vector x{};
    Vector y{};
    Vector theta{};
    store_vector3(out, stride, {x, y, theta});
    Rotation heading = {broadcast(1.0F), Vector{}};
    for (int i = 0; i < n; ++i) {
      const float* in = gap + kPoseSize * i * stride + q;
      const auto [dx, dy, turn] = load_vector3(in, stride);
      const Rotation rotation = rotation_of(turn);
      for (int g = 0; g < segments[i].gaps; ++g) {
        out += kPoseSize * stride;
        x = multiply_add(heading.cosine, dx, multiply_add(-heading.sine, dy, x));
        y = multiply_add(heading.sine, dx, multiply_add(heading.cosine, dy, y));
        theta += turn;
        heading = then(heading, rotation);
        store_vector3(out, stride, {x, y, theta});
      }
    }
  }
}

void encode_gaps(int gaps, const float* base, float* gap, int stride) {
  for (int g = 0; g < gaps; ++g) {
    const float* from = base + kPoseSize * g * stride;
    const float* to = from + kPoseSize * stride;
    float* out = gap + kPoseSize * g * stride;
    for (int q = 0; q < stride; q += kLanes) {
      const Vector theta = load(from + 2 * stride + q);
      const Rotation heading = rotation_of(theta);
      const Vector x = load(to + q) - load(from + q);
      const Vector y = load(to + stride + q) - load(from + stride + q);
      store(out + q, multiply_add(heading.cosine, x, heading.sine * y));
      store(out + stride + q, multiply_add(heading.cosine, y, -(heading.sine * x)));
      store(out + 2 * stride + q, load(to + 2 * stride + q) - theta);
    }
  }
}

void decode_gaps(int gaps, const float* gap, float* base, int stride) {
  for (int q = 0; q < stride; q += kLanes) {
    Vector x{};
    Vector y{};
    Vector theta{};
    float* out = base + q;
    store_vector3(out, stride, {x, y, theta});
    for (int g = 0; g < gaps; ++g) {
      const float* in = gap + kPoseSize * g * stride + q;
      const Rotation heading = rotation_of(theta);
      const auto [dx, dy, turn] = load_vector3(in, stride);
      x = multiply_add(heading.cosine, dx, multiply_add(-heading.sine, dy, x));
      y = multiply_add(heading.sine, dx, multiply_add(heading.cosine, dy, y));
      theta += turn;
      out += kPoseSize * stride;
      store_vector3(out, stride, {x, y, theta});
    }
  }
}

// One query's gaps side by side: a lane has a gap, not a query.
struct GapLanes {
  float x[kLanes];
  float y[kLanes];
  float theta[kLanes];
};

void encode_gaps_of_one(int gaps, const float* base, float* gap) {
  for (int from = 0; from < gaps; from += kLanes) {
    const int count = gaps - from < kLanes ? gaps - from : kLanes;
    GapLanes step{};
    for (int i = 0; i < count; ++i) {
      const float* plate = base + kPoseSize * (from + i);
      step.x[i] = plate[kPoseSize] - plate[0];
      step.y[i] = plate[kPoseSize + 1] - plate[1];
      step.theta[i] = plate[2];
    }
    const Rotation heading = rotation_of(load(step.theta));
    const Vector x = load(step.x);
    const Vector y = load(step.y);
    GapLanes seen;
    store(seen.x, multiply_add(heading.cosine, x, heading.sine * y));
    store(seen.y, multiply_add(heading.cosine, y, -(heading.sine * x)));
    for (int i = 0; i < count; ++i) {
      const float* plate = base + kPoseSize * (from + i);
      float* out = gap + kPoseSize * (from + i);
      out[0] = seen.x[i];
      out[1] = seen.y[i];
      out[2] = plate[kPoseSize + 2] - plate[2];
    }
  }
}

void decode_gaps_of_one(int gaps, const float* gap, float* base) {
  float x = 0.0F;
  float y = 0.0F;
  float theta = 0.0F;
  base[0] = x;
  base[1] = y;
  base[2] = theta;
  for (int from = 0; from < gaps; from += kLanes) {
    const int count = gaps - from < kLanes ? gaps - from : kLanes;
    float headings[kLanes] = {};
    for (int i = 0; i < count; ++i) {
      headings[i] = theta;
      theta += gap[kPoseSize * (from + i) + 2];
      base[kPoseSize * (from + i + 1) + 2] = theta;
    }
    const Rotation heading = rotation_of(load(headings));
    float cosine[kLanes];
    float sine[kLanes];
    store(cosine, heading.cosine);
    store(sine, heading.sine);
    for (int i = 0; i < count; ++i) {
      const float* in = gap + kPoseSize * (from + i);
      x = multiply_add(cosine[i], in[0], multiply_add(-sine[i], in[1], x));
      y = multiply_add(sine[i], in[0], multiply_add(cosine[i], in[1], y));
      base[kPoseSize * (from + i + 1)] = x;
      base[kPoseSize * (from + i + 1) + 1] = y;
    }
  }
}

void add(int count, const float* a, const float* b, float* sum) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    store(sum + i, load(a + i) + load(b + i));
  }
  for (; i < count; ++i) {
    sum[i] = a[i] + b[i];
  }
}

inline Vector gated(Vector previous, Vector no_load, Vector change, Vector gate) {
  return multiply_add(logistic(gate), no_load - previous, previous + change);
}

void gated_change(int count, const float* previous, const float* no_load, const float* change,
                  const float* gate, float* next) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    store(next + i, gated(load(previous + i), load(no_load + i), load(change + i), load(gate + i)));
  }
  if (const int rest = count - i; rest > 0) {
    store_part(next + i,
               gated(load_part(previous + i, rest), load_part(no_load + i, rest),
                     load_part(change + i, rest), load_part(gate + i, rest)),
               rest);
  }
}

// Whether any lane is to be changed. Nearly always none is, so this is what bounds cost.
inline bool any_outside(const GapBound<float>& bound, Vector x, Vector y, Vector turn) {
  const Vector square = x * x + y * y;
  const IntVector outside = (square < broadcast(bound.min_square)) |
                            (square > broadcast(bound.max_square)) |
                            (turn < broadcast(bound.min_turn)) | (turn > broadcast(bound.max_turn));
  return non_zero_lanes(reinterpret_cast<Vector>(outside)) != 0;
}

// One comparison that nearly always holds, instead of one for each bound.
inline void bound_one(const GapBound<float>& bound, float* step) {
  const float square = step[0] * step[0] + step[1] * step[1];
  const bool inside = (square >= bound.min_square) & (square <= bound.max_square) &
                      (step[2] >= bound.min_turn) & (step[2] <= bound.max_turn);
  if (__builtin_expect(!inside, 0)) {
    bound_gap(bound, step[0], step[1], step[2]);
  }
}

inline void bound_lanes(const GapBound<float>& bound, Vector& x, Vector& y, Vector& turn) {
  for (int i = 0; i < kLanes; ++i) {
    float step_x = x[i];
    float step_y = y[i];
    float angle = turn[i];
    bound_gap(bound, step_x, step_y, angle);
    x[i] = step_x;
    y[i] = step_y;
    turn[i] = angle;
  }
}

void bound_gaps(int gaps, const GapBound<float>* bounds, float* gap, int stride) {
  for (int g = 0; g < gaps; ++g) {
    float* const row = gap + kPoseSize * g * stride;
    for (int q = 0; q < stride; q += kLanes) {
      auto [x, y, turn] = load_vector3(row + q, stride);
      if (any_outside(bounds[g], x, y, turn)) {
        bound_lanes(bounds[g], x, y, turn);
        store_vector3(row + q, stride, {x, y, turn});
      }
    }
  }
}

void bound_gaps_of_one(int gaps, const GapBound<float>* bounds, float* gap) {
  for (int g = 0; g < gaps; ++g) {
    bound_one(bounds[g], gap + kPoseSize * g);
  }
}

void bound_base(int gaps, const GapBound<float>* bounds, float* base, int stride) {
  for (int q = 0; q < stride; q += kLanes) {
    Vector before[kPoseSize] = {};  // the plate before as it was given, and as it is now
    Vector now[kPoseSize] = {};
    float* plate = base + q;
    for (int r = 0; r < kPoseSize; ++r) {
      store(plate + r * stride, now[r]);
    }
    for (int g = 0; g < gaps; ++g) {
      plate += kPoseSize * stride;
      Vector step[kPoseSize];
      for (int r = 0; r < kPoseSize; ++r) {
        const Vector given = load(plate + r * stride);
        step[r] = given - before[r];
        before[r] = given;
      }
      if (any_outside(bounds[g], step[0], step[1], step[2])) {
        bound_lanes(bounds[g], step[0], step[1], step[2]);
      }
      for (int r = 0; r < kPoseSize; ++r) {
        now[r] += step[r];
        store(plate + r * stride, now[r]);
      }
    }
  }
}

void bound_base_of_one(int gaps, const GapBound<float>* bounds, float* base) {
  float before[kPoseSize] = {};
  float now[kPoseSize] = {};
  base[0] = base[1] = base[2] = 0.0F;
  for (int g = 0; g < gaps; ++g) {
    base += kPoseSize;
    float step[kPoseSize];
    for (int r = 0; r < kPoseSize; ++r) {
      step[r] = base[r] - before[r];
      before[r] = base[r];
    }
    bound_one(bounds[g], step);
    for (int r = 0; r < kPoseSize; ++r) {
      now[r] += step[r];
      base[r] = now[r];
    }
  }
}

constexpr RowKernels kRowKernels = {
    kLanes,
    gather,
    scatter,
    no_load_gaps,
    chain_segments,
    no_load_space_gaps,
    {kPoseSize, kPoseSize, encode_gaps, decode_gaps, encode_gaps_of_one, decode_gaps_of_one,
     bound_gaps, bound_gaps_of_one},
    kSpaceGapKernels,
    add,
    gated_change,
    bound_base,
    bound_base_of_one};

}  // namespace
}  // namespace limber
