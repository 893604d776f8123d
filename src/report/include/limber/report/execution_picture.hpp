#pragma once
// For those who show results.

#include <string>

#include "limber/hardware/executor.hpp"

namespace limber {

/// One run as an SVG file's text: obstacles and goal; where the plan predicts the arm to end, and
/// shapes that it really took, the last one full (at the fault, if there was one); the way of
/// both tips; the shape at the first collision, in red. Shapes are those that were recorded.
std::string execution_picture(const ArmDescription& arm, const Environment& environment,
                              const Plan& plan, const ExecutionResult& result);

/// The same as a page in which the arm moves (report/animation.hpp): as the model predicts it,
/// and as it was measured where something was.
std::string execution_animation(const ArmDescription& arm, const Environment& environment,
                                const Plan& plan, const ExecutionResult& result);

}  // namespace limber
