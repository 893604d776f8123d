#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

/// Where PlanningProblem::margin_yields_to_start says so, and the arm starts nearer to an obstacle
/// than the margin: plans keep what it starts with. A sentence about it goes to `notes`.
void yield_to_start(PlanningProblem& problem, std::vector<std::string>& notes);

/// A problem as its user asked for it, with what its plans are checked against: made once, when it
/// is first needed, and shared by all searches for its plans. Borrows what the problem borrows.
class AskedProblem {
 public:
  explicit AskedProblem(const PlanningProblem& problem) : problem_(problem) {}

  const Certifier& certifier();
  /// If there is no certifier yet, computed without one, because a certifier takes longer to make.
  const std::string& environment_hash();

 private:
  const PlanningProblem problem_;
  std::optional<Certifier> certifier_;
  std::string environment_hash_;
};

/// Searches work in float32 and certificates in double, so a search gets this much less room: far
/// above the rounding of the forward model over a plan, and far below what matters to a plan.
inline constexpr double kReserveM = Certificate::kDeviationM;
inline constexpr double kReserveRad = Certificate::kHeadingDeviationRad;

/// `environment`, with its goal's tolerances reduced by the model's error and a reserve.
Environment with_room(Environment environment, const PoseError& margin);

/// The part of its goal that a search prefers, if there is an error to keep room for.
std::optional<PoseError> aim_of(const PlanningProblem& problem);

/// Whether plans that end where they aim are in the goal also with the model's error.
bool has_room(const PlanningProblem& problem);

/// The tube that plans keep; whether it holds the goal as well. None if the problem has none.
std::optional<PlanTube> tube_of_plans(const PlanningProblem& problem);
/// Its largest radius.
double max_room_m(const PlanTube& tube);

/// If the goal has no room for the error: what plans aim at instead.
std::vector<std::string> warnings_of_aim(const PlanningProblem& problem);

}  // namespace limber
