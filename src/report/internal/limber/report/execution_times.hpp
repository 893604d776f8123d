#pragma once

#include <string>

#include "limber/run/executor.hpp"

namespace limber {

/// One run over time, as the text of an SVG file with three charts: set points, predicted and
/// measured pressures of each segment; x and y of the tip, predicted and as recorded; clearance
/// from the obstacles (of one that appeared, from then on). Predictions end where the plan does.
std::string execution_times_picture(const ArmDescription& arm, const Environment& environment,
                                    const Plan& plan, const ExecutionResult& result);

}  // namespace limber
