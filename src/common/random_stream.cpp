#include "limber/common/random_stream.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include <Random123/philox.h>

namespace limber {

namespace {

constexpr std::uint64_t kWordsPerBlock = 4;

void fill_block(std::uint64_t seed, std::uint64_t stream, std::uint64_t index,
                std::uint32_t (&block)[kWordsPerBlock]) {
  const auto low = [](std::uint64_t x) { return std::uint32_t(x); };
  const auto high = [](std::uint64_t x) { return std::uint32_t(x >> 32U); };
  const r123::Philox4x32::ctr_type counter = {{low(index), high(index), low(stream), high(stream)}};
  const r123::Philox4x32::key_type key = {{low(seed), high(seed)}};
  const auto words = r123::Philox4x32()(counter, key);
  for (std::size_t i = 0; i < kWordsPerBlock; ++i) {
    block[i] = words[i];
  }
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::uint64_t stream)
    : seed_(seed), stream_(stream) {}

std::uint32_t RandomStream::next_u32() {
  const std::uint64_t word = position_ % kWordsPerBlock;
  if (word == 0) {
    fill_block(seed_, stream_, position_ / kWordsPerBlock, block_);
  }
  ++position_;
  return block_[word];
}

void RandomStream::seek(std::uint64_t position) {
  position_ = position;
  if (position % kWordsPerBlock != 0) {
    fill_block(seed_, stream_, position / kWordsPerBlock, block_);
  }
}

double RandomStream::uniform() {
  const std::uint64_t high = next_u32() >> 5U;
  const std::uint64_t low = next_u32() >> 6U;
  return double((high << 26U) | low) * 0x1.0p-53;
}

double RandomStream::uniform(double low, double high) {
  assert(low <= high);
  return low + (high - low) * uniform();
}

double RandomStream::normal() {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

std::uint32_t RandomStream::index(std::uint32_t count) {
  assert(count > 0);
  // Lemire's multiply-shift with rejection: no bias for any count.
  const std::uint32_t threshold = (0U - count) % count;
  for (;;) {
    const std::uint64_t product = std::uint64_t{next_u32()} * count;
    if (std::uint32_t(product) >= threshold) {
      return std::uint32_t(product >> 32U);
    }
  }
}

}  // namespace limber
