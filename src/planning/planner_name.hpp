#pragma once

#include <map>
#include <string>
#include <vector>

namespace limber {

/// A planner as people name it: "NAME" or "NAME,key=value,key=value". Names of before are
/// understood.
struct PlannerName {
  std::string name;
  std::map<std::string, std::string> settings;  ///< as they were typed
  std::vector<std::string> notes;               ///< names of before that were used, and today's

  /// @throws InputError naming the part that is no key=value.
  static PlannerName parse(const std::string& text);

  /// The number of a setting, which is then no longer there; `fallback` where it was not given.
  /// @throws InputError if it is not a number from `low` to `high`.
  double take(const std::string& key, double low, double high, double fallback);
};

}  // namespace limber
