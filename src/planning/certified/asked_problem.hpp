#pragma once

#include <optional>
#include <string>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/planner.hpp"

namespace limber {

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
