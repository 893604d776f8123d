#pragma once
// For those who plan.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

struct Forest;

/// Names that `make_planner` knows, the default first; beside them ompl:NAME for any of OMPL's.
std::vector<std::string> planner_names();

/// Its plans are certified (docs/planning.md, Certificate).
/// @param name    one of those; settings may follow it: "default,improved_plans=0"
/// @param jobs    threads to use if the planner uses several, 0 for one per core
/// @param forest  of the arm, model and start to plan for, for the default planner; borrowed
/// @throws InputError naming the known planners, or the one that can't use a forest.
std::unique_ptr<Planner> make_planner(const std::string& name, int jobs = 0,
                                      const Forest* forest = nullptr);

/// What `plan` does otherwise than by default.
struct PlanSettings {
  AskedRoom room;                      ///< in place of the error that the model states
  std::vector<PressureLimits> within;  ///< PlanningProblem::limits
  /// In place of the arm's, > 0 and at most that [the command's unit per second].
  std::optional<double> rate_limit_kpa_per_s;
  bool stay_recorded = false;       ///< whether plans keep to set points, rates and shapes recorded
  std::string planner = "default";  ///< of make_planner, as jobs and forest
  int jobs = 0;
  const Forest* forest = nullptr;
  PlannerCallback callback = {};
  PlanCallback on_plan = {};  ///< PlanningProblem::on_plan
};

/// What `limber plan` does, and the same plan: plans keep the tube that the model carries, or the
/// error that it states (error_room), stand behind the valves that it was trained with, and are
/// certified. What is doubtful is among the result's warnings: an error that was not measured,
/// valves that nobody knows, a plan beyond the model's recordings.
/// @param model_file  of `limber train`; the plan keeps its hash, which `limber verify` compares
/// @param limits      none: kDefaultTimeLimitS
/// @throws InputError as read_model, ForwardModel and Planner; if the network has no bounds; if a
/// setting asks for what the model does not store.
[[nodiscard]] PlanResult plan(const ArmDescription& arm, const std::filesystem::path& model_file,
                              const Environment& environment, const PlannerLimits& limits = {},
                              std::uint64_t seed = 1, const PlanSettings& settings = {});
/// The same with a network in memory, and a plan that names no file.
[[nodiscard]] PlanResult plan(const ArmDescription& arm, const CompensationModel& network,
                              const Environment& environment, const PlannerLimits& limits = {},
                              std::uint64_t seed = 1, const PlanSettings& settings = {});
/// The same with valves of your own, or with the no-load model.
[[nodiscard]] PlanResult plan(const ArmDescription& arm, const MotionModel& model,
                              const Environment& environment, const PlannerLimits& limits = {},
                              std::uint64_t seed = 1, const PlanSettings& settings = {});
/// It would be planned with ideal valves, whatever the network was trained with.
PlanResult plan(const ArmDescription& arm, const ForwardModel& model,
                const Environment& environment, const PlannerLimits& limits = {},
                std::uint64_t seed = 1, const PlanSettings& settings = {}) = delete;

/// The motion that a planner of your own proposes: from the problem's start straight to each
/// waypoint in turn, simulated with the problem's model, held, and certified, as every planner's
/// plans are. Solved if it is. If not, the status is `not_certified`, the reason says what is
/// wrong, and the motion is `best_partial`, its clearance measured; motions that collide or end
/// outside of the goal take no certificate. An arm that starts nearer to an obstacle than the
/// margin is refused (invalid_start), unless PlanningProblem::margin_yields_to_start says that the
/// margin then yields.
/// @param waypoints_kpa  at least one, each of n set points within the problem's limits
/// @param planner        name that the plan file keeps
/// @param seed           that the plan file keeps
/// @throws InputError naming the waypoint that does not fit.
[[nodiscard]] PlanResult plan_along(const PlanningProblem& problem,
                                    const std::vector<Pressures>& waypoints_kpa,
                                    const std::string& planner, std::uint64_t seed = 0);

/// Whether that is the default planner, with settings or without.
/// @throws InputError if the settings are no key=value.
bool is_default_planner(const std::string& name);

}  // namespace limber
