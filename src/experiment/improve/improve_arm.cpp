#include "limber/experiment/improve.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/hardware/virtual_arm_factory.hpp"

namespace limber {

ImproveArm virtual_improve_arm(const ArmDescription& arm) {
  ImproveArm on;
  on.source = "virtual arm";
  on.about = describe(arm, VirtualArmOptions{});
  on.drivers = virtual_arm_factory(arm, {});
  on.execute = [arm](const Environment& environment, const Plan& plan) {
    VirtualArm driver(arm);
    return execute(arm, environment, plan, driver);
  };
  on.side_by_side = true;
  return on;
}

}  // namespace limber
