#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "asked_problem.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// Whether a planner uses the valves of its problem.
enum class Valves { as_given, left_out };

/// `planner`, with its plans certified (certificate/certificate.hpp) before they are called solved;
/// a certified plan carries the certificate's figures into its file. The search works in float32
/// and the certificate in double, so the search gets a little less room than was asked for: 0.1 mm
/// more clearance (0.2 mm if no margin is asked for), 0.1 mm and 1 mrad less of the goal's
/// tolerances (at most a tenth of them). Certificates are given while the planner searches
/// (PlanJudge), so a refused plan does not cost any other plan. If every plan is refused the status
/// is `not_certified`, and the cheapest is kept as `best_partial`.
///
/// The goal's margin is subtracted from its tolerances, down to a quarter of them; where that is
/// less, it does not fit, and plans may use four fifths. If there is a margin, plans aim at the
/// inner tenth. If nothing keeps the clearance asked for, the last tenth of the
/// limits (at most a second) is spent on smaller ones, and the reason names the largest that gave a
/// plan.
/// @param valves  left_out: plans and certifies as if pressures were the set points, as the paper
/// does
/// @param jobs    threads of the searches with smaller clearances; 0: one for each core
std::unique_ptr<Planner> make_certified_planner(std::unique_ptr<Planner> planner, int jobs,
                                                Valves valves = Valves::as_given);

using SteadyTime = std::chrono::steady_clock::time_point;

/// If nothing was found that keeps the clearance asked for: names in `result` the largest clearance
/// with which there is a plan. Its tries share what the limits' patience keeps back, as far as the
/// search, begun at `start`, has left it.
void try_smaller_clearances(Planner& planner, const PlanningProblem& asked, AskedProblem& shared,
                            const PlannerLimits& limits, SteadyTime start, std::uint64_t seed,
                            const PlannerCallback& callback, PlanResult& result);

}  // namespace limber
