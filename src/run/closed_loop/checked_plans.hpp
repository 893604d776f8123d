#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// Whether a plan for this environment may be followed; sets its `certified` if so.
using PlanCheck = std::function<bool(Plan& plan, const Environment& environment)>;

/// The certificate, for plans of this arm and model. Borrows both.
PlanCheck certificate_check(const ArmDescription& arm, const MotionModel& model);

/// Makes plans of waypoints from a problem's start. They keep the problem's margin, or most of the
/// clearance that the arm has now where that is less.
///
/// Borrows what the problem borrows. Threads: one of these, one thread.
class CheckedPlans {
 public:
  CheckedPlans(const PlanningProblem& problem, PlanCheck check);
  CheckedPlans(const CheckedPlans&) = delete;  // the simulator borrows the checker
  CheckedPlans& operator=(const CheckedPlans&) = delete;

  const PlanningProblem& problem() const { return problem_; }
  const MotionState& from() const { return from_; }
  /// Stops at what is too near.
  MotionSimulator& simulator() { return simulator_; }

  /// Where the arm comes to rest; none if something is too near on the way.
  /// @param waypoints_kpa  start first
  std::optional<MotionState> end_of(const std::vector<Pressures>& waypoints_kpa);
  /// @param planner  Plan::planner
  /// @return none if the check refuses it
  std::optional<Plan> checked(const std::vector<Pressures>& waypoints_kpa,
                              const std::string& planner, std::uint64_t seed);

 private:
  MotionState from_;
  PlanningProblem problem_;
  PlanCheck check_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
};

}  // namespace limber
