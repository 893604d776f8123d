#include "limber/sim/mujoco_version.hpp"

#include <mujoco/mujoco.h>

namespace limber {

std::string mujoco_version() {
  return mj_versionString();
}

}  // namespace limber
