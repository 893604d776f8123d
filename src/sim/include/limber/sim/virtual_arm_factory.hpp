#pragma once
// For those who move an arm, real or virtual.

#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

/// A fresh virtual arm per episode; `options.stream` is replaced by the episode's index, so that
/// each has noise and drops of its own.
DriverFactory virtual_arm_factory(const ArmDescription& arm, const VirtualArmOptions& options);

/// What decides a virtual arm's motion in addition to its set points, in one line: hash of its
/// parameters and the options that are on ("physics 1f2e3d4c, noise 0.001 m, drop rate 0.01").
std::string describe(const ArmDescription& arm, const VirtualArmOptions& options);

/// Settings for collection on the virtual arm, with source, driver and seed filled in.
CollectionSettings virtual_collection(const ArmDescription& arm, const ScheduleSettings& schedule,
                                      const VirtualArmOptions& options);

}  // namespace limber
