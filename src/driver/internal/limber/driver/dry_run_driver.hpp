#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "limber/arm/arm_description.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// Stands in for a driver in a dry run: hands every line that would be sent to `print`, and is
/// where it was told to be.
class DryRunDriver final : public ArmDriver {
 public:
  DryRunDriver(const ArmDescription& arm, std::function<void(const std::string& line)> print);
  ~DryRunDriver() override;

  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;
  void vent() noexcept override;

 private:
  double period_s_;
  std::function<void(const std::string&)> print_;
  ArmState state_;
  std::int64_t seq_ = 0;
  bool resting_ = true;
};

}  // namespace limber
