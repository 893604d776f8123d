#pragma once

#include "limber/run/arm_driver.hpp"
#include "limber/run/safety_gate.hpp"

namespace limber {

/// An arm for the length of a run. Whatever moves arms moves them through this, so that each set
/// point passes the SafetyGate, also on the way to a driver in this process, which has no gate of
/// its own, and each state has the arm's sizes. What else is measured is watched only behind a
/// ProcessDriver: the thresholds are those of hardware.
class GatedDriver final : public ArmDriver {
 public:
  /// @param arm, driver  both outlive this; the driver is vented
  /// @param check_rate  as in SafetyGate
  GatedDriver(const ArmDescription& arm, ArmDriver& driver, bool check_rate);

  /// @throws SystemFault, here and after a command, where a state is none of the arm's.
  const ArmState& state() const override;
  /// @throws SystemFault, before anything is sent, where the gate refuses; as ArmDriver.
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;
  std::vector<PressureLimits> limits_kpa() const override { return driver_.limits_kpa(); }
  bool is_real_time() const override { return driver_.is_real_time(); }
  void vent() noexcept override { driver_.vent(); }

 private:
  const ArmDescription& arm_;
  ArmDriver& driver_;
  SafetyGate gate_;
};

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
