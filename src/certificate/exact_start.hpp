#pragma once

#include <vector>

#include "exact_arm.hpp"
#include "exact_valves.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// Where an arm is at a plan's frame 0, and what was commanded until then.
struct ExactStart {
  std::vector<double> pressure_kpa;
  std::vector<double> setpoint_kpa;        ///< of an arm at rest the pressures
  ExactValves::Configurations before_kpa;  ///< set points before that, the newest first
  ExactArm::Shape shape;
  ExactArm::Shape before;  ///< a frame earlier
};

/// The environment's start, at rest or in motion; without one, the straight arm without pressure.
ExactStart exact_start(const Environment& environment, const ArmDescription& arm,
                       const ExactArm& model);

}  // namespace limber
