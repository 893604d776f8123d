#pragma once

#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/run/plan_trial.hpp"

namespace limber {

/// The paper's Fig. 5 for one environment, as SVG text: obstacles, goal, and the final backbones of
/// the executed trials, no-load plans in one colour and network plans in another; runs that
/// collided are dashed.
std::string final_shapes_picture(const ArmDescription& arm, const EnvironmentCase& item,
                                 const std::vector<PlanTrial>& trials);

/// One thing to see in a page of shapes.
struct ShownShapes {
  std::string name;
  std::string color;             ///< variable of web/src/style.css
  const FrameMatrix* backbones;  ///< T×7m; a frame that is no number shows the one before
};

/// An HTML page of an arm in space that can be turned by mouse, touch and keys (web/src/shapes.ts):
/// what was recorded of the episode and, over it, what was predicted. It holds all that it needs.
/// @param still  SVG that stands in it where scripts are off
std::string shapes_page(const std::string& title, const ArmDescription& arm, const Episode& episode,
                        const std::vector<ShownShapes>& predicted, const std::string& still);

}  // namespace limber
