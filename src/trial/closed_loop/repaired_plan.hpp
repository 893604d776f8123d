#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "limber/planning/planner.hpp"

namespace limber {

/// Whether a plan for this environment may be followed; sets its `certified` if so.
using PlanCheck = std::function<bool(Plan& plan, const Environment& environment)>;

/// The certificate, for plans of this arm and model. Borrows both.
PlanCheck certificate_check(const ArmDescription& arm, const MotionModel& model);

/// A checked plan from the problem's start along these waypoints, their end shifted so that the tip
/// comes to rest as near to the problem's goal as it can (PlanRepair). It keeps the problem's
/// margin, or most of the clearance that the arm has now where that is less.
/// @param max_error_m  none if it ends no nearer (as_length_m)
std::optional<Plan> repaired_plan(PlanningProblem problem,
                                  const std::vector<Pressures>& waypoints_kpa, double max_error_m,
                                  std::uint64_t seed, const PlanCheck& check);

}  // namespace limber
