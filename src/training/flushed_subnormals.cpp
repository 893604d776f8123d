#include "flushed_subnormals.hpp"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace limber {

#if defined(__SSE2__)

namespace {
constexpr unsigned kFlushResults = 1U << 15U;  // of MXCSR …
constexpr unsigned kFlushOperands = 1U << 6U;  // … both
}  // namespace

FlushedSubnormals::FlushedSubnormals() : before_(_mm_getcsr()) {
  _mm_setcsr(static_cast<unsigned>(before_) | kFlushResults | kFlushOperands);
}

FlushedSubnormals::~FlushedSubnormals() {
  _mm_setcsr(static_cast<unsigned>(before_));
}

#elif defined(__aarch64__)

namespace {
constexpr unsigned long long kFlush = 1ULL << 24U;  // of FPCR: operands and results
}  // namespace

FlushedSubnormals::FlushedSubnormals() {
  asm volatile("mrs %0, fpcr" : "=r"(before_));
  asm volatile("msr fpcr, %0" : : "r"(before_ | kFlush));
}

FlushedSubnormals::~FlushedSubnormals() {
  asm volatile("msr fpcr, %0" : : "r"(before_));
}

#else

FlushedSubnormals::FlushedSubnormals() = default;
FlushedSubnormals::~FlushedSubnormals() = default;

#endif

}  // namespace limber
