#pragma once

#include <concepts>
#include <ranges>
#include <type_traits>
#include <vector>

namespace limber {

/// What `function` makes of each element of `range`, or of each number from 0 to below `range` if
/// that is a number.
template <typename Value, typename Range, typename Function>
std::vector<Value> mapped(Range&& range, const Function& function) {
  std::vector<Value> values;
  if constexpr (std::integral<std::remove_cvref_t<Range>>) {
    values.reserve(range);
    for (std::remove_cvref_t<Range> i = 0; i < range; ++i) {
      values.push_back(function(i));
    }
  } else {
    if constexpr (std::ranges::sized_range<Range>) {
      values.reserve(std::ranges::size(range));
    }
    for (auto&& element : range) {
      values.push_back(function(element));
    }
  }
  return values;
}

/// The same, added up in this order.
template <typename Value, typename Range, typename Function>
requires std::is_arithmetic_v<Value> Value sum_of(Range&& range, const Function& function) {
  Value sum{};
  if constexpr (std::integral<std::remove_cvref_t<Range>>) {
    for (std::remove_cvref_t<Range> i = 0; i < range; ++i) {
      sum += function(i);
    }
  } else {
    for (auto&& element : range) {
      sum += function(element);
    }
  }
  return sum;
}

}  // namespace limber
