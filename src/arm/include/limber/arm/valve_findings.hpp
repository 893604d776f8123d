#pragma once
// For those who train and evaluate models.

#include <cstdint>
#include <string>
#include <vector>

#include "limber/arm/valve_parameters.hpp"

namespace limber {

/// |Modelled − measured| pressure over frames in which a set point has changed within the last
/// 0.5 s. In the unit of the arm's command.
struct ValveErrors {
  double mean_kpa = 0.0;
  double p95_kpa = 0.0;
  double max_kpa = 0.0;
  std::int64_t frames = 0;  ///< 0: not measured
};

/// How valves were identified, or why they were not. No part of the parameters' hash.
struct ValveFindings {
  std::string source;          ///< the recordings
  ValveErrors held_back;       ///< on motions that the fit has not seen
  ValveErrors from_setpoints;  ///< on the same motions, if set points were taken for pressures
  std::string reason;          ///< why there are no parameters; empty if there are
  std::vector<std::string> warnings;  ///< what is suspicious about the recordings
};

struct IdentifiedValves {
  ValveParameters parameters;  ///< ideal where there is a reason
  ValveFindings findings;
};

}  // namespace limber
