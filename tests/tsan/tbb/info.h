#pragma once

#include <algorithm>
#include <thread>

namespace tbb::info {

// One thread races with nobody.
inline int default_concurrency() {
  return std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace tbb::info
