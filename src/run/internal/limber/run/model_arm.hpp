#pragma once

#include <cstdint>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

/// An arm that is what a network says: a rehearsal for those whose arm has no virtual twin. It
/// starts vented and straight, as the no-load model has it, and is seen without noise.
///
/// Laws: as ArmDriver. Threads: one driver, one thread.
class ModelArm final : public ArmDriver {
 public:
  /// @throws InputError where network or valves don't fit the arm.
  ModelArm(const ArmDescription& arm, CompensationModel network, const ValveParameters& valves);

  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;
  /// Nothing to open: the set points that follow are what counts.
  void vent() noexcept override {}

 private:
  void look();

  ArmDescription arm_;
  ForwardModel forward_;
  MotionModel motion_;
  MotionModel::Workspace workspace_;
  MotionState motion_state_;
  ArmState state_;
  std::int64_t frame_ = 0;
};

}  // namespace limber
