#pragma once

#include <map>
#include <string>

namespace limber {

/// A planner as users name it: "NAME" or "NAME,key=value,key=value".
struct PlannerName {
  std::string name;
  std::map<std::string, std::string> settings;  ///< as they were typed

  /// @throws InputError naming the part that is no key=value.
  static PlannerName parse(const std::string& text);

  /// Takes out the number of a setting; `fallback` if it was not given.
  /// @throws InputError if it is not a number from `low` to `high`.
  double take(const std::string& key, double low, double high, double fallback);
};

}  // namespace limber
