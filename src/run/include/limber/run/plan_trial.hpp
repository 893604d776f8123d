#pragma once
// For those who compare planners and models over many trials.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

/// Means over the trials of one model in one environment, or in all of them; none where nothing
/// counts.
struct TrialSummary {
  int trials = 0;
  int solved = 0;
  int executed = 0;  ///< to their end
  int collided = 0;
  int reached = 0;  ///< ended within the goal's tolerances, without collision
  std::optional<double> first_solution_s;     ///< over solved trials, certified
  std::optional<double> first_candidate_s;    ///< its two parts: until it was found,
  std::optional<double> first_certificate_s;  ///< and its certificate
  std::optional<double> cost_kpa;             ///< over solved trials
  std::optional<double> distance_m;           ///< executed, including runs that collided
  std::optional<double> distance_free_m;      ///< executed without collision
  std::optional<double> orientation_rad;      ///< executed, where the goal asks for a heading
};
/// @param environment, model  empty: any.
TrialSummary summarise(const std::vector<PlanTrial>& trials, const std::string& environment,
                       const std::string& model);

/// The cheapest solved trial; null if there is none. @param environment, model  empty: any.
const PlanTrial* cheapest_plan(const std::vector<PlanTrial>& trials, const std::string& environment,
                               const std::string& model);

}  // namespace limber
