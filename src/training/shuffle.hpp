#pragma once

#include <utility>
#include <vector>

#include "limber/common/random_stream.hpp"

namespace limber {

/// Fisher and Yates.
template <class Number>
void shuffle(RandomStream& random, std::vector<Number>& values) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[random.index(std::uint32_t(i))]);
  }
}

}  // namespace limber
