#pragma once

#include "limber/hardware/arm_driver.hpp"

namespace limber {

/// A driver that somebody else owns, for those who take one of their own.
class BorrowedDriver final : public ArmDriver {
 public:
  /// Borrows `driver`.
  explicit BorrowedDriver(ArmDriver& driver) : driver_(driver) {}

  const ArmState& state() const override { return driver_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    return driver_.command(setpoint_kpa);
  }
  bool is_real_time() const override { return driver_.is_real_time(); }
  void vent() noexcept override { driver_.vent(); }

 private:
  ArmDriver& driver_;
};

}  // namespace limber
