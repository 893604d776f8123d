#pragma once

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"

namespace limber {

/// NaN and infinities have no JSON; null says "none".
inline Json json_number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// The value, or null. @param value  a std::optional
inline Json optional_json(const auto& value) {
  return value ? Json(*value) : Json(nullptr);
}

inline Json json_number(const std::optional<double>& value) {
  return value ? json_number(*value) : Json(nullptr);
}

}  // namespace limber
