#pragma once
// For those who show results.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/run/executor.hpp"

namespace limber {

/// The object of `limber execute --json`; lengths in cm, unknown values null.
nlohmann::ordered_json to_json(const ExecutionResult& result, const Environment& environment);

/// The same in a few lines for people.
std::string to_text(const ExecutionResult& result, const Environment& environment);

/// One run as the text of an SVG file. It shows obstacles and goal; where the plan predicts the arm
/// to end, and shapes that it really took, the last one in full colour (at the fault, if there was
/// one); the paths of both tips; and the shape at the first collision, in red. Shapes are the
/// recorded ones.
std::string execution_picture(const ArmDescription& arm, const Environment& environment,
                              const Plan& plan, const ExecutionResult& result);

/// The same as a page in which the arm moves (report/animation.hpp): as predicted by the model and,
/// if anything was measured, as measured.
std::string execution_animation(const ArmDescription& arm, const Environment& environment,
                                const Plan& plan, const ExecutionResult& result);

}  // namespace limber
