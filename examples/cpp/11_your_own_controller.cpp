// A controller of one's own: the plan's set points, moved by what the tip misses along one axis.
//
//   11_your_own_controller PLAN.json ENVIRONMENT.yaml

#include <algorithm>
#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/run/controller.hpp"
#include "limber/sim/virtual_arm.hpp"

/// Presses the first segment harder while the tip is left of where the plan has it.
class Nudge final : public limber::Controller {
 public:
  void begin(const limber::RunStart& start) override {
    arm_ = &start.arm;
    plan_ = &start.plan;
  }

  limber::Decision step(const limber::Moment& now) override {
    const auto next = static_cast<std::size_t>(now.arm.frames()) + 1;
    if (next >= plan_->frames.size()) {
      return {};  // the end
    }
    const auto seen = next - 1 - std::min<std::size_t>(next - 1, std::size_t(now.arm.lag_frames()));
    if (const auto& shape = now.arm.measured().backbone) {
      const auto planned = limber::tip_position_m(plan_->frames[seen].backbone);
      nudge_kpa_ += kGain * (limber::tip_position_m(*shape) - planned).y();
    }
    Eigen::VectorXd wanted = plan_->frames[next].setpoint_kpa.cast<double>();
    wanted[0] += nudge_kpa_;
    limber::Decision decision;
    decision.setpoint_kpa = limber::within_frame_rule(*arm_, now.arm.setpoint_kpa(), wanted);
    decision.plan = plan_;  // what the prediction's error is taken from
    decision.frame = next;
    return decision;
  }

 private:
  static constexpr double kGain = 20.0;  // [kPa/m], in each frame
  const limber::ArmDescription* arm_ = nullptr;
  const limber::Plan* plan_ = nullptr;
  double nudge_kpa_ = 0.0;
};

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "11_your_own_controller PLAN.json ENVIRONMENT.yaml\n";
    return 2;
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const limber::Environment environment = limber::load_environment(argv[2], arm);
  const limber::Plan plan = limber::read_plan(argv[1]);
  limber::VirtualArm virtual_arm(arm);
  Nudge nudge;
  limber::ExecutionSettings settings;
  settings.controller = &nudge;
  const auto result = limber::execute(arm, environment, plan, virtual_arm, settings);
  std::cout << to_string(result.status) << ": " << result.goal_error.position_m * 100.0
            << " cm from the goal after " << result.frames << " frames\n";
  return result.status == limber::ExecutionStatus::done ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
