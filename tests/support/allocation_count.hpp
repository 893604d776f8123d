#pragma once

// Counts what a test program takes from the heap: malloc is replaced for the whole program, so one
// source of a program includes this. Sanitizers replace it themselves; there nothing is counted.

#include <atomic>
#include <cstdlib>

#if defined(__has_feature)  // clang's way to say it
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LIMBER_HEAP_IS_THE_SANITIZERS
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIMBER_HEAP_IS_THE_SANITIZERS
#endif

namespace limber {

/// Blocks taken from the heap so far, by any thread.
inline std::atomic<long> allocations{0};

#if defined(__GLIBC__) && !defined(LIMBER_HEAP_IS_THE_SANITIZERS)
inline constexpr bool kCountsAllocations = true;
#else
inline constexpr bool kCountsAllocations = false;
#endif

}  // namespace limber

#if defined(__GLIBC__) && !defined(LIMBER_HEAP_IS_THE_SANITIZERS)
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* __libc_memalign(std::size_t alignment, std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++limber::allocations;
  return __libc_malloc(size);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++limber::allocations;
  return __libc_memalign(alignment, size);
}
#endif
