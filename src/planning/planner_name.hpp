#pragma once

#include <cmath>
#include <map>
#include <string>

#include "limber/common/refuse_if.hpp"

namespace limber {

/// @throws InputError if a planner's setting is out of range.
inline void require_between(const char* name, double value, double low, double high) {
  refuse_if(!(value >= low && value <= high), "planner setting {} = {}; expected {} to {}", name,
            value, low, high);
}

/// Of a planner's setting. @throws InputError if it is no whole number.
inline int whole(const std::string& key, double value) {
  refuse_if(value != std::floor(value), "planner setting {} = {}; expected a whole number", key,
            value);
  return int(value);
}

/// The number of a planner's setting. @throws InputError if it is none from `low` to `high`.
double setting_number(const std::string& key, const std::string& value, double low, double high);

/// A planner as users name it: "NAME" or "NAME,key=value,key=value".
struct PlannerName {
  std::string name;
  std::map<std::string, std::string> settings;  ///< as they were typed

  /// @throws InputError naming the part that is no key=value.
  static PlannerName parse(const std::string& text);

  /// Takes out the number of a setting; `fallback` if it was not given.
  /// @throws InputError if it is not a number from `low` to `high`.
  double take(const std::string& key, double low, double high, double fallback);
  /// The same of a whole number.
  int take_whole(const std::string& key, int low, int high, int fallback);
};

}  // namespace limber
