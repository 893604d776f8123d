#pragma once

#include <string>
#include <utility>
#include <vector>

#include "limber/arm/pose_size.hpp"

namespace limber {

/// What tables call the numbers of a pose, and how the names of those with a unit end.
inline std::vector<std::pair<std::string, std::string>> pose_columns(Dimension dimension) {
  if (dimension == Dimension::plane) {
    return {{"x", "_m"}, {"y", "_m"}, {"theta", "_rad"}};
  }
  return {{"x", "_m"}, {"y", "_m"}, {"z", "_m"}, {"qx", ""}, {"qy", ""}, {"qz", ""}, {"qw", ""}};
}

}  // namespace limber
