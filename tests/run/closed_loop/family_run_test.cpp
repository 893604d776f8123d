#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "limber/arm/arm_description.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/model_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// An arm that is seen to bend the other way.
class MirroredArm final : public ArmDriver {
 public:
  MirroredArm(const ArmDescription& arm, const CompensationModel& network)
      : arm_(arm, network, network.valves.value_or(ValveParameters{})) {
    see();
  }

  const ArmState& state() const override { return seen_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    arm_.command(setpoint_kpa);
    see();
    is_vented = false;
    return seen_;
  }
  void vent() noexcept override { is_vented = true; }

  bool is_vented = true;

 private:
  void see() {
    seen_ = arm_.state();
    seen_.backbone->rightCols<2>() *= -1.0F;
  }

  ModelArm arm_;
  ArmState seen_;
};

TEST(FamilyRun, AnArmThatBendsTheOtherWayEndsInAFaultAndIsVented) {
  const ArmDescription arm = load_arm(data_folder() / "arms" / "three_segment.yaml");
  const CompensationModel family =
      read_model(data_folder() / "families" / "three_segment_small.safetensors");
  const int size = family.family->size();
  const CompensationModel network = model_of_arm(
      family, {"", family.family->arms.col(7), 0.01F * Eigen::MatrixXf::Identity(size, size)});
  Environment environment;
  environment.goal = {0.51, 0.33, std::nullopt, 0.02, 0.1};
  const ForwardModel forward(arm, network);
  const MotionModel model(forward, ValveModel(arm, network.valves.value_or(ValveParameters{})));
  PlanSettings planning;
  planning.jobs = 1;
  planning.room.margin_m = 0.0;
  planning.room.goal_margin_m = 0.0;
  PlannerLimits limits;
  limits.queries = 5000;
  const PlanResult found = plan(arm, model, environment, limits, 1, planning);
  ASSERT_TRUE(found.plan) << found.reason;

  ClosedLoopSettings settings;
  settings.corrections.queries = 2000;
  settings.motion_queries = 1000;
  ClosedLoop loop(arm, model, environment, ErrorRoom{}, settings, 1);
  ExecutionSettings execution;
  execution.controller = &loop;
  std::vector<std::pair<double, std::string>> noticed;  // when, and what
  execution.on_frame = [&noticed](const ExecutedFrame& frame) {
    if (!frame.noticed.empty()) {
      noticed.emplace_back(frame.time_s, frame.noticed);
    }
  };
  MirroredArm driver(arm, network);
  const ExecutionResult result = execute(arm, environment, *found.plan, driver, execution);
  EXPECT_EQ(result.status, ExecutionStatus::fault);
  EXPECT_THAT(result.message, HasSubstr("the arm moves like none of its model's family"));
  EXPECT_THAT(result.message, Not(HasSubstr("what may have changed of the arm")));
  EXPECT_TRUE(driver.is_vented);
  ASSERT_TRUE(result.arm_changed_s);
  ASSERT_EQ(noticed.size(), 1U) << "once";
  EXPECT_THAT(noticed.front().second, HasSubstr("the arm is far from where it was predicted"));
  EXPECT_LT(noticed.front().first, *result.arm_changed_s + 1.0) << "while it moves";
}

}  // namespace
}  // namespace limber
