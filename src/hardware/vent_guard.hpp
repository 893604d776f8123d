#pragma once

#include "limber/hardware/arm_driver.hpp"

namespace limber {

/// Vents the arm however the scope is left: at its end, by an exception, by Ctrl-C.
class VentGuard {
 public:
  explicit VentGuard(ArmDriver& driver) : driver_(driver) {}
  ~VentGuard() { driver_.vent(); }
  VentGuard(const VentGuard&) = delete;
  VentGuard& operator=(const VentGuard&) = delete;

 private:
  ArmDriver& driver_;
};

}  // namespace limber
