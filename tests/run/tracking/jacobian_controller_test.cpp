#include "limber/run/jacobian_controller.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/run/executor.hpp"
#include "support/bending_arms.hpp"
#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kLag_s = 0.1;
constexpr JacobianGains kGains{0.2, 2.0, 1e-4};

/// The plan bends as its own no-load model has it; the arm by a weaker one.
class JacobianControllerTest : public ::testing::Test {
 protected:
  JacobianControllerTest() {
    const auto tip = plan_.frames.back().backbone.bottomRows<1>();
    goal_ = {double(tip(0, 0)), double(tip(0, 1)), std::nullopt, 0.02, 0.1};
    environment_.goal = goal_;
    plan_.environment_hash = environment_hash(environment_);
  }

  ExecutionResult run(const ArmDescription& real, const JacobianGains& gains,
                      FakeFaults faults = {}) {
    JacobianController controller(arm_, plan_, goal_, gains);
    ExecutionSettings settings;
    settings.controller = &controller;
    FakeArm driver(real, kLag_s, faults);
    return execute(arm_, environment_, plan_, driver, settings);
  }

  const ArmDescription arm_ = small_arm();
  Environment environment_;
  Plan plan_ = bending_plan(arm_, environment_);
  PoseGoal goal_;
};

TEST_F(JacobianControllerTest, WithoutGainsItCommandsThePlansSetPoints) {
  const ExecutionResult result = run(bending(arm_, 0.85), {0.0, 0.0, 1e-3});
  ASSERT_GE(result.frames, plan_.frame_count() - 1);
  for (int k = 0; k < plan_.frame_count(); ++k) {
    EXPECT_EQ(result.episode.setpoint_kpa.row(k),
              plan_.frames[static_cast<std::size_t>(k)].setpoint_kpa.transpose());
  }
  EXPECT_GT(result.goal_error.position_m, 0.02) << "the arm is weaker than the plan has it";
}

TEST_F(JacobianControllerTest, ItsIntegralBringsAWeakerArmToTheGoal) {
  const ExecutionResult result = run(bending(arm_, 0.85), kGains);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_LT(result.goal_error.position_m, 0.001);
}

TEST_F(JacobianControllerTest, AHeadingOfAWholeTurnMoreIsTheSameGoal) {
  goal_.theta_rad = double(plan_.frames.back().backbone.bottomRows<1>()(0, 2));
  const Eigen::MatrixXf setpoints_kpa = run(bending(arm_, 0.85), kGains).episode.setpoint_kpa;
  *goal_.theta_rad += 2.0 * std::numbers::pi;
  const ExecutionResult again = run(bending(arm_, 0.85), kGains);
  ASSERT_EQ(again.episode.setpoint_kpa.rows(), setpoints_kpa.rows());
  EXPECT_LT((again.episode.setpoint_kpa - setpoints_kpa).cwiseAbs().maxCoeff(), 1e-4F);
}

TEST_F(JacobianControllerTest, WithoutTrackingItIsOpenLoop) {
  FakeFaults blind;
  blind.drop_every = 1;
  const ExecutionResult result = run(bending(arm_, 0.85), kGains, blind);
  EXPECT_EQ(result.status, ExecutionStatus::done);
  EXPECT_FALSE(result.final_backbone);
  EXPECT_EQ(result.frames, plan_.frame_count() - 1 + arm_.frames_in(10.0));
}

TEST_F(JacobianControllerTest, AGoalOutOfReachKeepsLimitsAndFrameRule) {
  goal_.x_m = 5.0;  // the executor refuses what breaks them
  const ExecutionResult result = run(bending(arm_, 0.85), {2.0, 50.0, 1e-6});
  EXPECT_EQ(result.status, ExecutionStatus::done);
}

TEST(JacobianGains, AreReadByName) {
  EXPECT_FALSE(parse_jacobian("open"));
  const auto gains = parse_jacobian("jacobian,integral=3,damping=0.5");
  EXPECT_EQ(gains->integral_per_s, 3.0);
  EXPECT_EQ(gains->damping_m_per_kpa, 0.5);
  EXPECT_EQ(gains->proportional, parse_jacobian("jacobian")->proportional);
  const auto refuses = [](const std::string& text, const std::string& message) {
    EXPECT_THAT([&] { (void)parse_jacobian(text); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refuses("jacobian,update=0.5",
          "'update=0.5': no such gain; expected proportional, integral, damping");
  refuses("jacobian,integral=-1", "integral=-1: expected integral=NUMBER, from 0 to 100");
  refuses("jacobian,integral", "expected integral=NUMBER");
  refuses("jacobian,", "'': no such gain");
}

}  // namespace
}  // namespace limber
