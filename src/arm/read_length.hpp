#pragma once

#include <fmt/format.h>

#include "limber/common/yaml_reader.hpp"

namespace limber {

inline constexpr double kMaxLength_m = 10.0;  ///< of a segment, or its width
inline constexpr double kMaxRadius_m = 1.0;   ///< of an actuator

/// A length > 0. @throws InputError also beyond kMaxLength_m, where it may be in millimetres.
inline double read_length_m(const YamlReader& node) {
  const double length_m = node.positive("a length in metres");
  if (length_m > kMaxLength_m) {
    node.refuse(fmt::format(
        "{} found; expected a length in metres, > 0 and at most {}. Is it in millimetres?",
        length_m, kMaxLength_m));
  }
  return length_m;
}

/// A radius >= 0. @throws InputError also beyond kMaxRadius_m.
inline double read_radius_m(const YamlReader& node) {
  const double radius_m = node.number("a length in metres", 0.0);
  if (radius_m > kMaxRadius_m) {
    node.refuse(
        fmt::format("{} found; expected a length in metres, from 0 to {}. Is it in millimetres?",
                    radius_m, kMaxRadius_m));
  }
  return radius_m;
}

}  // namespace limber
