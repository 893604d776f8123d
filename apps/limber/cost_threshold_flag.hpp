#pragma once

#include <optional>

#include <CLI/CLI.hpp>

namespace limber {

/// --cost-threshold, and its former name, which help texts leave out. @param target  kept by CLI11
inline void add_cost_threshold(CLI::App& app, std::optional<double>& target) {
  CLI::Option* option =
      app.add_option("--cost-threshold", target,
                     "Stop at a plan this cheap, in the unit of the arm's command (kPa of "
                     "pressures); with a large number, stop at the first plan");
  app.add_option("--cost-threshold-kpa", target)->group("")->excludes(option);
}

}  // namespace limber
