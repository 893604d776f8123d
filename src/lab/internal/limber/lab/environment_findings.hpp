#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "limber/lab/environment_measures.hpp"
#include "limber/lab/planning_experiment.hpp"

namespace limber {

/// Limits that limber's own environments must satisfy (docs/environments.md).
inline constexpr double kMissedByM = 0.08;    ///< a no-load plan that ends farther off has failed
inline constexpr double kNarrowWidths = 1.5;  ///< narrow: at most this × the arm's local width …
inline constexpr double kNarrowExtraM = 0.02;  ///< … + this

/// Whether a passage counts as narrow for the arm's local width.
bool is_narrow(const Passage& passage);

struct FindingsSettings {
  int trials = 3;  ///< plans of each model, ≥ 1
  PlanTrialSettings planning;
  int monotone_motions = 20000;  ///< tried before a reversal counts as needed
};

/// What an environment demands of a planner and of a model, found by planning and executing in it.
struct EnvironmentFindings {
  std::vector<PlanTrial> trials;  ///< no load first, then network
  TrialSummary no_load;
  TrialSummary network;
  int network_reached = 0;  ///< network plans that ran free and ended within the goal's tolerances
  int no_load_failed = 0;   ///< no-load plans that collided or ended more than kMissedByM off
  bool straight_line_collides = false;  ///< to the end of every plan found, by the network model
  bool needs_reversal = false;          ///< no motion in which every pressure is monotone was found
  std::optional<Passage> passage;  ///< the narrowest that the cheapest network plan goes through

  /// The network model solves every trial, and the straight line collides. That the goal can be
  /// reached on the arm is proven by environments/witnesses/.
  bool keeps_rules() const;
};

/// Plans `trials` times with each model, executes every plan, and looks for straight and monotone
/// motions. Depends on the seed alone if the planner's limits are iterations.
EnvironmentFindings find_out(const ArmDescription& arm, const MotionModel& no_load,
                             const MotionModel& network, const EnvironmentCase& item,
                             const FindingsSettings& settings, std::uint64_t seed);

}  // namespace limber
