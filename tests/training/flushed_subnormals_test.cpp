#include "src/training/flushed_subnormals.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace limber {
namespace {

float half_of(float value) {
  volatile float kept = value;
  return kept * 0.5F;
}

TEST(FlushedSubnormals, CountAsZeroWhileOneLives) {
#if defined(__SSE2__) || defined(__aarch64__)
  constexpr float kLeast = std::numeric_limits<float>::min();
  EXPECT_GT(half_of(kLeast), 0.0F);
  {
    const FlushedSubnormals flushed;
    EXPECT_EQ(half_of(kLeast), 0.0F);
    EXPECT_EQ(half_of(std::numeric_limits<float>::denorm_min() * 4.0F), 0.0F);
    EXPECT_GT(half_of(4.0F * kLeast), 0.0F);
  }
  EXPECT_GT(half_of(kLeast), 0.0F);
#endif
}

}  // namespace
}  // namespace limber
