#include "factor_search.hpp"

namespace limber {

std::optional<std::size_t> narrowest_factor(std::size_t start, std::size_t count,
                                            int max_wider_tests,
                                            const std::function<bool(std::size_t)>& holds) {
  if (holds(start)) {
    std::size_t narrowest = start;
    while (narrowest + 1 < count && holds(narrowest + 1)) {
      ++narrowest;
    }
    return narrowest;
  }
  for (int test = 1; test < max_wider_tests && start > 0; ++test) {
    if (holds(--start)) {
      return start;
    }
  }
  return std::nullopt;
}

}  // namespace limber
