#pragma once

#include <string>

namespace limber {

/// Version of the MuJoCo library that is loaded, "2.2.2".
std::string mujoco_version();

}  // namespace limber
