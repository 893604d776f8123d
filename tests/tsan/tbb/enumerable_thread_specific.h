#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "parallel_for.h"

namespace tbb {

/// One value for each thread of a loop. No lock: it would put the threads in an order, and hide
/// their races. Two loops that use it at once race, and are reported.
template <class Value>
class enumerable_thread_specific {
 public:
  Value& local() {
    std::unique_ptr<Value>& value = values_[static_cast<std::size_t>(stand_in::place.index)];
    if (!value) {
      value = std::make_unique<Value>();
    }
    return *value;
  }

 private:
  std::array<std::unique_ptr<Value>, stand_in::kMaxThreads> values_;
};

}  // namespace tbb
