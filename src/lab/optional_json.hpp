#pragma once

#include <nlohmann/json.hpp>

namespace limber {

/// The value, or null. @param value  a std::optional
inline nlohmann::ordered_json optional_json(const auto& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace limber
