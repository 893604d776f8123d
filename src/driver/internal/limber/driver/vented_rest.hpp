#pragma once

#include <functional>

#include "limber/arm/arm_description.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/world/environment.hpp"

namespace limber {

/// Where a vented arm lies, once it lies still: pressures are down long before it has stopped
/// swinging, by centimetres. RestAverage tells when it does: 3 mm in 0.5 s are more than most of a
/// tracker's noise of 0.5 mm.
/// @param look  a fresh state of the arm, a frame after the last one
/// @throws SystemFault where nothing tracks it, or after 10 s; Interrupted.
ArmStart vented_rest(const ArmDescription& arm, const std::function<const ArmState&()>& look);
/// The same of an arm behind a driver.
ArmStart vented_rest(const ArmDescription& arm, ProcessDriver& driver);

}  // namespace limber
