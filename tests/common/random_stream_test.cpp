#include "limber/common/random_stream.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>

namespace limber {
namespace {

TEST(RandomStream, DrawsDependOnlyOnSeedStreamAndPosition) {
  RandomStream a(7, 3);
  RandomStream b(7, 3);
  for (int k = 0; k < 10; ++k) {
    a.next_u32();
  }
  b.seek(10);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(a.next_u32(), b.next_u32());
  }
}

TEST(RandomStream, StreamsAndSeedsDiffer) {
  EXPECT_NE(RandomStream(7, 3).next_u32(), RandomStream(7, 4).next_u32());
  EXPECT_NE(RandomStream(7, 3).next_u32(), RandomStream(8, 3).next_u32());
}

// Known-answer vector of the Random123 distribution: philox4x32-10, counter 0, key 0.
TEST(RandomStream, IsPhilox4x32WithTenRounds) {
  RandomStream stream(0, 0);
  EXPECT_EQ(stream.next_u32(), 0x6627e8d5U);
  EXPECT_EQ(stream.next_u32(), 0xe169c58dU);
  EXPECT_EQ(stream.next_u32(), 0xbc57ac4cU);
  EXPECT_EQ(stream.next_u32(), 0x9b00dbd8U);
}

TEST(RandomStream, NormalHasZeroMeanAndUnitVariance) {
  constexpr int kSamples = 100000;
  constexpr double kTolerance = 5.0 / 316.0;  // five standard errors of the mean of 1e5 draws
  RandomStream stream(1, 1);
  double sum = 0.0;
  double squares = 0.0;
  for (int k = 0; k < kSamples; ++k) {
    const double x = stream.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kSamples, 0.0, kTolerance);
  EXPECT_NEAR(squares / kSamples, 1.0, 2.0 * kTolerance);
}

TEST(RandomStream, IndexIsUniformOverItsRange) {
  constexpr int kSamples = 30000;
  std::array<int, 3> counts{};
  RandomStream stream(5, 0);
  for (int k = 0; k < kSamples; ++k) {
    ++counts.at(stream.index(3));
  }
  for (const int count : counts) {
    EXPECT_NEAR(count, kSamples / 3, 5.0 * std::sqrt(kSamples * 2.0 / 9.0));
  }
}

}  // namespace
}  // namespace limber
