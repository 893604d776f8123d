#pragma once
// For everyone.

#include <cstdint>

namespace limber {

/// Counter-based random numbers (Philox 4x32-10): sample k depends on (seed, stream, k) alone.
///
/// Give every unit of work (episode, trial, batch) a stream of its own; then results do not depend
/// on which thread did the work, nor on how many there were. Threads: one stream, one thread.
class RandomStream {
 public:
  /// @param stream  names the unit of work; streams of one seed are independent.
  RandomStream(std::uint64_t seed, std::uint64_t stream);

  /// Uniform over all 32-bit words.
  std::uint32_t next_u32();

  /// Uniform in [0, 1), 53 bits.
  double uniform();

  /// Uniform in [low, high). @pre low ≤ high, both finite.
  double uniform(double low, double high);

  /// Standard normal deviate (Box–Muller).
  double normal();

  /// Uniform in {0, …, count − 1}. @pre count > 0.
  std::uint32_t index(std::uint32_t count);

  /// Number of 32-bit words used so far (two for a uniform sample); `seek(position())`
  /// continues the stream from the same point.
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);

 private:
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t position_ = 0;  // counted in 32-bit words
  std::uint32_t block_[4] = {};
};

}  // namespace limber
