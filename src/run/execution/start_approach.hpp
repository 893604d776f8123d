#pragma once

#include <functional>

#include "limber/arm/arm_description.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// Leads an arm at rest to `start_kpa`, straight in pressure space, and holds it there until it has
/// settled: a plan takes the arm to have long stood at its start, so slow valves get their time.
/// Does nothing where no pressure is asked for.
/// @param before_each  called before every set point
void approach_start(const ArmDescription& arm, ArmDriver& driver, const Pressures& start_kpa,
                    const std::function<void()>& before_each);

}  // namespace limber
