#pragma once

// A vector of floats as wide as the instruction set that the including file is compiled for: the
// files <stem>_<level>.cpp, each of which compiles it for another one, or any other file, which
// compiles it for the oldest. Everything is in an unnamed namespace and nothing of the standard
// library is called, so that no function compiled for a newer CPU can be linked into code that runs
// on an older one.

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace limber {
namespace {

#if defined(__AVX512F__)
constexpr int kLanes = 16;
#elif defined(__AVX2__)
constexpr int kLanes = 8;
#else
constexpr int kLanes = 4;
#endif

// Registers that a tile of a matrix product may fill with sums, of 32 or of 16, and its height: the
// usual one, and that of a tile with few columns.
#if defined(__AVX512F__) || defined(__aarch64__)
constexpr int kTileVectors = 4;
constexpr int kTallVectors = 8;
constexpr int kAccumulators = 24;
constexpr int kWidestTile = 12;
#else
constexpr int kTileVectors = 3;
constexpr int kTallVectors = 3;
constexpr int kAccumulators = 12;
constexpr int kWidestTile = 12;
#endif

typedef float Vector __attribute__((vector_size(4 * kLanes)));
typedef int IntVector __attribute__((vector_size(4 * kLanes)));
typedef float UnalignedVector __attribute__((vector_size(4 * kLanes), aligned(4), may_alias));

inline Vector load(const float* p) {
  return *reinterpret_cast<const UnalignedVector*>(p);
}

// Has the compiler load a vector before it is used, rather than as an operand of each use.
inline void keep_in_register(Vector& v) {
#if defined(__AVX512F__)
  asm("" : "+v"(v));
#elif defined(__SSE2__)
  asm("" : "+x"(v));
#elif defined(__aarch64__)
  asm("" : "+w"(v));
#endif
}

inline void store(float* p, Vector v) {
  *reinterpret_cast<UnalignedVector*>(p) = v;
}

// Minus zero, not plus: x − 0 is x for every x, −0 too, so that the compiler leaves it out, and
// loads all lanes at once. An addition it has to carry out, on the ports that the products need.
inline Vector broadcast(float x) {
  return x - Vector{};
}

#if !defined(__AVX512F__) && defined(__AVX2__)
inline __m256i first_lanes(int count) {
  return _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
}
#endif

// The first `count` ≤ kLanes floats at p, zeros behind; nothing past them is touched.
inline Vector load_part(const float* p, int count) {
#if defined(__AVX512F__)
  return _mm512_maskz_loadu_ps(static_cast<__mmask16>((1U << count) - 1U), p);
#elif defined(__AVX2__)
  return _mm256_maskload_ps(p, first_lanes(count));
#else
  Vector v{};
  for (int i = 0; i < count; ++i) {
    v[i] = p[i];
  }
  return v;
#endif
}

inline void store_part(float* p, Vector v, int count) {
#if defined(__AVX512F__)
  _mm512_mask_storeu_ps(p, static_cast<__mmask16>((1U << count) - 1U), v);
#elif defined(__AVX2__)
  _mm256_maskstore_ps(p, first_lanes(count), v);
#else
  for (int i = 0; i < count; ++i) {
    p[i] = v[i];
  }
#endif
}

// a·b + c, rounded once where the level has fused multiply-add; spelt out, so that the compiler's
// choice never makes two kernels differ in the last bit.
inline Vector multiply_add(Vector a, Vector b, Vector c) {
#if defined(__AVX512F__)
  return _mm512_fmadd_ps(a, b, c);
#elif defined(__AVX2__)
  return _mm256_fmadd_ps(a, b, c);
#elif defined(__aarch64__)
  return vfmaq_f32(c, a, b);
#else
  return a * b + c;
#endif
}

// The same of one number: to the bit what each lane gets.
inline float multiply_add(float a, float b, float c) {
#if defined(__AVX512F__) || defined(__AVX2__) || defined(__aarch64__)
  return __builtin_fmaf(a, b, c);
#else
  return a * b + c;
#endif
}

// A NaN stays a NaN, so that a diverging training run cannot hide behind a ReLU.
inline Vector relu(Vector v) {
#if defined(__AVX512F__)
  return _mm512_max_ps(Vector{}, v);
#elif defined(__AVX2__)
  return _mm256_max_ps(Vector{}, v);
#else
  return v < Vector{} ? Vector{} : v;
#endif
}

// Bit i says whether lane i is other than 0.
inline unsigned non_zero_lanes(Vector v) {
#if defined(__AVX512F__)
  return _mm512_cmp_ps_mask(v, Vector{}, _CMP_NEQ_UQ);
#elif defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(v, Vector{}, _CMP_NEQ_UQ)));
#elif defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpneq_ps(v, Vector{})));
#else
  unsigned mask = 0;
  for (int i = 0; i < kLanes; ++i) {
    mask |= (v[i] != 0.0F ? 1U : 0U) << i;
  }
  return mask;
#endif
}

inline Vector absolute(Vector v) {
  return reinterpret_cast<Vector>(reinterpret_cast<IntVector>(v) & 0x7fffffff);
}

// Nearest integer, for |v| < 2²².
inline Vector round_to_integer(Vector v) {
  const Vector magic = broadcast(12582912.0F);  // 1.5·2²³: adding it leaves no bits for a fraction
  return (v + magic) - magic;
}

}  // namespace
}  // namespace limber
