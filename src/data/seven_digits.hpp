#pragma once

#include <fmt/format.h>

#include "limber/common/number_text.hpp"

namespace limber {

/// The same on every machine: fits differ in their last digits.
inline double seven_digits(double value) {
  return number_in(fmt::format("{:.7g}", value)).value_or(value);
}

}  // namespace limber
