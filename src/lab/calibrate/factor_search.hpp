#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace limber {

/// The narrowest factor of a list, the largest first, that holds its test (docs/tube.md,
/// Calibration): from `start` towards narrower ones until one is refused; where the first is
/// refused, towards wider ones until one holds.
///
/// A test that accepts a factor that doesn't hold has a probability of at most p, and whoever
/// chose `start` has not seen its runs. Then the answer doesn't hold with a probability of at most
/// max_wider_tests · p: on the way down only the first factor that doesn't hold can be accepted
/// wrongly before the search ends (fixed sequence); on the way up there are that many tests.
/// @param count  of factors in the list
/// @param holds  tests factor k; every k is asked for once at most
/// @pre start < count, max_wider_tests ≥ 1 counts the first test
std::optional<std::size_t> narrowest_factor(std::size_t start, std::size_t count,
                                            int max_wider_tests,
                                            const std::function<bool(std::size_t)>& holds);

}  // namespace limber
