#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// --limit: limits to plan within, narrower than the arm's.
class LimitFlags {
 public:
  void add_to(CLI::App& app);

  /// One of each segment; empty where the flag was not given. @throws InputError if a value is no
  /// range, names no segment, or goes beyond the arm's limits.
  std::vector<PressureLimits> limits(const ArmDescription& arm) const;

 private:
  std::vector<std::string> values_;
};

}  // namespace limber
