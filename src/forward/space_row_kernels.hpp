#pragma once

// The gaps of arms in space for the instruction set that the including file is compiled for (see
// kernels/vector_float.hpp). One query passes through the same functions as many, never inlined, so
// that its bits are the same.

#include "kernels/space_chain.hpp"
#include "kernels/space_gap_bound.hpp"
#include "kernels/vector_float.hpp"
#include "limber/arm/pose_size.hpp"
#include "row_kernels.hpp"
#include "strain_kernel.hpp"

namespace limber {
namespace {

inline Vector3<Vector> load_vector3(const float* at, int stride) {
  return {load(at), load(at + stride), load(at + 2 * stride)};
}
inline void store_vector3(float* at, int stride, const Vector3<Vector>& v) {
  store(at, v.x);
  store(at + stride, v.y);
  store(at + 2 * stride, v.z);
}

// Files and columns have x, y, z, w.
inline Quaternion<Vector> load_rotation(const float* at, int stride) {
  return {load(at + 3 * stride), load_vector3(at, stride)};
}
inline void store_rotation(float* at, int stride, const Quaternion<Vector>& q) {
  store_vector3(at, stride, q.v);
  store(at + 3 * stride, q.w);
}

// Lanes of poses to those of gaps, all `stride` apart.
__attribute__((noinline)) void encode_lanes(const float* from, const float* to, int stride,
                                            float* gap) {
  const Quaternion<Vector> back = conjugate(load_rotation(from + 3 * stride, stride));
  const Vector3<Vector> step = load_vector3(to, stride) - load_vector3(from, stride);
  Quaternion<Vector> turn = product(back, load_rotation(to + 3 * stride, stride));
  // Of the two quaternions of a rotation, the one whose angle is at most π.
  const Vector sign = select(turn.w < Vector{}, broadcast(-1.0F), broadcast(1.0F));
  turn = {sign * turn.w, sign * turn.v};
  store_vector3(gap, stride, rotated(back, step));
  store_vector3(gap + 3 * stride, stride, rotation_vector_of(turn));
}

// From one plate's lanes to the next one's.
__attribute__((noinline)) void decode_lanes(const float* gap, const float* from, int stride,
                                            float* to) {
  const Quaternion<Vector> rotation = load_rotation(from + 3 * stride, stride);
  store_vector3(to, stride,
                load_vector3(from, stride) + rotated(rotation, load_vector3(gap, stride)));
  store_rotation(to + 3 * stride, stride,
                 product(rotation, rotation_of(load_vector3(gap + 3 * stride, stride))));
}

void encode_space_gaps(int gaps, const float* base, float* gap, int stride) {
  for (int g = 0; g < gaps; ++g) {
    const float* const from = base + kSpacePoseSize * g * stride;
    for (int q = 0; q < stride; q += kLanes) {
      encode_lanes(from + q, from + kSpacePoseSize * stride + q, stride,
                   gap + kSpaceGapSize * g * stride + q);
    }
  }
}

void decode_space_gaps(int gaps, const float* gap, float* base, int stride) {
  for (int q = 0; q < stride; q += kLanes) {
    for (int r = 0; r < kSpacePoseSize; ++r) {
      store(base + r * stride + q, broadcast(r + 1 == kSpacePoseSize ? 1.0F : 0.0F));
    }
    for (int g = 0; g < gaps; ++g) {
      float* const from = base + kSpacePoseSize * g * stride + q;
      decode_lanes(gap + kSpaceGapSize * g * stride + q, from, stride,
                   from + kSpacePoseSize * stride);
    }
  }
}

// A lane has a gap, not a query.
void encode_space_gaps_of_one(int gaps, const float* base, float* gap) {
  float from[kSpacePoseSize * kLanes] = {};
  float to[kSpacePoseSize * kLanes] = {};
  float seen[kSpaceGapSize * kLanes];
  for (int first = 0; first < gaps; first += kLanes) {
    const int count = gaps - first < kLanes ? gaps - first : kLanes;
    for (int i = 0; i < count; ++i) {
      const float* const plate = base + kSpacePoseSize * (first + i);
      for (int r = 0; r < kSpacePoseSize; ++r) {
        from[r * kLanes + i] = plate[r];
        to[r * kLanes + i] = plate[kSpacePoseSize + r];
      }
    }
    encode_lanes(from, to, kLanes, seen);
    for (int i = 0; i < count; ++i) {
      for (int r = 0; r < kSpaceGapSize; ++r) {
        gap[kSpaceGapSize * (first + i) + r] = seen[r * kLanes + i];
      }
    }
  }
}

void decode_space_gaps_of_one(int gaps, const float* gap, float* base) {
  float step[kSpaceGapSize * kLanes] = {};
  float from[kSpacePoseSize * kLanes] = {};
  float to[kSpacePoseSize * kLanes];
  from[(kSpacePoseSize - 1) * kLanes] = 1.0F;
  for (int g = 0; g <= gaps; ++g) {
    for (int r = 0; r < kSpacePoseSize; ++r) {
      base[kSpacePoseSize * g + r] = from[r * kLanes];
    }
    if (g == gaps) {
      break;
    }
    for (int r = 0; r < kSpaceGapSize; ++r) {
      step[r * kLanes] = gap[kSpaceGapSize * g + r];
    }
    decode_lanes(step, from, kLanes, to);
    for (int r = 0; r < kSpacePoseSize; ++r) {
      from[r * kLanes] = to[r * kLanes];
    }
  }
}

inline void bound_one_space_gap(const GapBound<float>& bound, float* numbers, int stride) {
  SpaceGap<float> gap;
  for (int i = 0; i < 3; ++i) {
    gap.d[i] = numbers[i * stride];
    gap.omega[i] = numbers[(3 + i) * stride];
  }
  if (is_within(bound, gap)) {
    return;
  }
  bound_gap(bound, gap);
  for (int i = 0; i < 3; ++i) {
    numbers[i * stride] = gap.d[i];
    numbers[(3 + i) * stride] = gap.omega[i];
  }
}

// Whether any lane may be outside; nearly always none is, so this is what bounds cost.
inline bool any_near_edge(const GapBound<float>& bound, const float* gap, int stride) {
  constexpr float kRounding = 1e-5F;
  const Vector3<Vector> d = load_vector3(gap, stride);
  const Vector3<Vector> omega = load_vector3(gap + 3 * stride, stride);
  const Vector square = dot(d, d);
  const Vector bend = omega.y * omega.y + omega.z * omega.z;
  const IntVector near =
      ~((square > broadcast(bound.min_square * (1.0F + kRounding))) &
        (square < broadcast(bound.max_square * (1.0F - kRounding))) &
        (bend < broadcast(bound.max_bend * bound.max_bend * (1.0F - kRounding))) &
        (omega.x > broadcast(bound.min_turn + kRounding)) &
        (omega.x < broadcast(bound.max_turn - kRounding)));
  return non_zero_lanes(reinterpret_cast<Vector>(near)) != 0;
}

void bound_space_gaps(int gaps, const GapBound<float>* bounds, float* gap, int stride) {
  for (int g = 0; g < gaps; ++g) {
    float* const row = gap + kSpaceGapSize * g * stride;
    for (int q = 0; q < stride; q += kLanes) {
      if (any_near_edge(bounds[g], row + q, stride)) {
        for (int i = 0; i < kLanes; ++i) {
          bound_one_space_gap(bounds[g], row + q + i, stride);
        }
      }
    }
  }
}

void bound_space_gaps_of_one(int gaps, const GapBound<float>* bounds, float* gap) {
  for (int g = 0; g < gaps; ++g) {
    bound_one_space_gap(bounds[g], gap + kSpaceGapSize * g, 1);
  }
}

// (25): strains of a chamber.
inline Vector strain_of_chamber(const NoLoadChamber& chamber, Vector command) {
  const Vector sense = broadcast(chamber.sense);
  if (!chamber.has_strain) {
    return sense * command;
  }
  const Vector strain = sense * strain_of(chamber.strain, command);
  return select(command < Vector{}, -strain, strain);
}

// (26), (24): a row of each chamber's command to the gap of each segment.
__attribute__((noinline)) void no_load_lanes(const NoLoadInSpace& arm, const float* command,
                                             float* gap, int stride) {
  for (int s = 0; s < arm.segments; ++s) {
    Vector shape[3] = {};
    for (int k = 0; k < arm.channels; ++k) {
      const Vector strain = strain_of_chamber(arm.chambers[k], load(command + k * stride));
      for (int r = 0; r < 3; ++r) {
        shape[r] =
            multiply_add(broadcast(arm.shape[(3 * s + r) * arm.channels + k]), strain, shape[r]);
      }
    }
    const Vector share = broadcast(arm.gap_share[s]);
    const Vector omega_y = shape[0] * share;
    const Vector omega_z = shape[1] * share;
    const Vector length = broadcast(arm.gap_length_m[s]) * (broadcast(1.0F) + shape[2]);
    float* const out = gap + kSpaceGapSize * s * stride;
    store_vector3(out, stride, element_end(length, omega_y, omega_z));
    store_vector3(out + 3 * stride, stride, {Vector{}, omega_y, omega_z});
  }
}

void no_load_space_gaps(const NoLoadInSpace& arm, const float* command, float* gap, int stride) {
  for (int q = 0; q < stride; q += kLanes) {
    no_load_lanes(arm, command + q, gap + q, stride);
  }
}

constexpr GapKernels kSpaceGapKernels = {kSpacePoseSize,           kSpaceGapSize,
                                         encode_space_gaps,        decode_space_gaps,
                                         encode_space_gaps_of_one, decode_space_gaps_of_one,
                                         bound_space_gaps,         bound_space_gaps_of_one};

}  // namespace
}  // namespace limber
