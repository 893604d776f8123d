#pragma once

#include <string>
#include <vector>

#include "limber/run/plan_trial.hpp"

namespace limber {

/// The paper's Fig. 5 for one environment, as SVG text: obstacles, goal, and the final backbones of
/// the executed trials, no-load plans in one colour and network plans in another; runs that
/// collided are dashed.
std::string final_shapes_picture(const ArmDescription& arm, const EnvironmentCase& item,
                                 const std::vector<PlanTrial>& trials);

}  // namespace limber
