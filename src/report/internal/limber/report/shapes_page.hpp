#pragma once

#include <string>
#include <vector>

#include "limber/data/recording.hpp"

namespace limber {

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
