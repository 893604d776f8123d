#pragma once
// For those who compare planners and models over many trials.

#include <cstdint>
#include <optional>
#include <string>

#include "limber/planning/planner.hpp"
#include "limber/run/executor.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// An environment and its short name in files and tables, "03_gap_in_a_wall".
struct EnvironmentCase {
  std::string id;
  Environment environment;
};

/// One plan and its outcome on the virtual arm.
struct PlanTrial {
  std::string environment;  ///< EnvironmentCase::id
  std::string model;        ///< "no_load" or "network"
  std::string planner;
  std::string controller = "open";  ///< that executed the plan
  std::string disturbance;          ///< "friction", "tip_load=0.1,noise"; empty: none
  std::uint64_t seed = 0;
  bool asks_heading = false;  ///< whether the goal does
  PlanResult planning;
  std::optional<ExecutionResult> execution;  ///< none without a plan

  bool solved() const { return planning.status == PlanStatus::solved; }
};

}  // namespace limber
