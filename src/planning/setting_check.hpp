#pragma once

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

/// @throws InputError if a planner's setting is out of range.
inline void require_between(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    throw InputError(
        fmt::format("planner setting {} = {}; expected {} to {}", name, value, low, high));
  }
}

}  // namespace limber
