#pragma once

#include <functional>

#include "limber/arm/characterisation.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {

/// Of an arm on the bench: nothing depends on history, or differs from one actuator to another.
void make_ideal(VirtualArmParameters& parameters);

/// Holds set points until nothing moves: the pressure that `channel` then has, and `strain()`.
BenchPoint settled_point(VirtualArm& arm, const Pressures& setpoint_kpa, Eigen::Index channel,
                         const std::function<double()>& strain);

}  // namespace limber
