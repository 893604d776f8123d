#pragma once

#include "limber/run/arm_driver.hpp"

namespace limber {

/// Vents the arm when the scope ends, in whatever way: normally, by an exception, by Ctrl-C.
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
