#pragma once

#include <cstddef>

namespace tbb {

/// Does nothing: an arena has the threads that it was asked for.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
};

}  // namespace tbb
