#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "limber/arm/arm_description.hpp"

namespace limber {

/// --limit, --rate-limit: what to plan within, narrower than the arm's limits.
class LimitFlags {
 public:
  void add_to(CLI::App& app);

  /// One of each segment; empty where the flag was not given. @throws InputError if a value is no
  /// range, names no segment, or goes beyond the arm's limits.
  std::vector<PressureLimits> limits(const ArmDescription& arm) const;
  /// None where the flag was not given.
  std::optional<double> rate_limit() const { return rate_limit_; }

 private:
  std::vector<std::string> values_;
  std::optional<double> rate_limit_;
};

}  // namespace limber
