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

/// Why a run that was carried out to its end did not arrive: what it struck, that it was not seen,
/// how far it ended from the goal. Empty if it arrived.
/// @param environment  in which it ended (with_appeared)
std::string why_not_arrived(const ExecutionResult& run, const Environment& environment);

/// The end of a message that says why: what a miss hints at, frames that were not certified, and,
/// however the run ended, what it believes has changed of the arm.
/// @param plan  the one that was followed last
std::string hint_of(const ExecutionResult& run, const ArmDescription& arm,
                    const Environment& environment, const Plan& plan, Correction correction);

}  // namespace limber
