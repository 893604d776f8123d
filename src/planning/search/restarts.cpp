#include "restarts.hpp"

#include <bit>

namespace limber {

double Restarts::length(std::uint64_t i) {
  // i = 2^k − 1 has length 2^(k−1); the terms between two of those repeat the sequence.
  while (!std::has_single_bit(i + 1)) {
    i -= std::bit_floor(i) - 1;
  }
  return static_cast<double>((i + 1) / 2);
}

}  // namespace limber
