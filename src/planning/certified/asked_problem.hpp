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

}  // namespace limber
