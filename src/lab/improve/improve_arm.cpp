#include "limber/lab/improve.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_factory.hpp"

namespace limber {

ImproveArm virtual_improve_arm(const ArmDescription& arm) {
  ImproveArm on;
  on.source = "virtual arm";
  on.about = describe(arm, VirtualArmOptions{});
  on.drivers = virtual_arm_factory(arm, {});
  on.execute = [arm](const Environment& environment, const Plan& plan, Controller* then) {
    VirtualArm driver(arm);
    ExecutionSettings execution;
    execution.controller = then;
    return execute(arm, environment, plan, driver, execution);
  };
  on.side_by_side = true;
  return on;
}

}  // namespace limber
