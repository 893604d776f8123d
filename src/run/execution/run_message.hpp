#pragma once

#include <string>

#include "limber/run/executor.hpp"

namespace limber {

/// What could be done about a miss.
enum class Correction {
  none,     ///< a plan as it stands: open loop
  replans,  ///< more plans, from where the arm is measured
  feedback  ///< a controller
};

/// One sentence that says why a run that was carried out to its end did not arrive: what it struck,
/// that it was not seen, how far it ended from the goal and what that hints at. Empty if it
/// arrived.
/// @param environment  in which it ended (with_appeared)
/// @param plan         the one that was followed last
std::string why_not_arrived(const ExecutionResult& run, const Environment& environment,
                            const Plan& plan, Correction correction);

}  // namespace limber
