#include "src/lab/improve/plan_chain.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "support/bending_plan.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

constexpr double kInstant_s = 1e-4;  // lag of a fake arm that is where it is told to be
constexpr double kNoEnd_s = 1e9;

Pressures pressures(float first, float second) {
  return Eigen::Vector2f(first, second);
}

/// A fake arm whose frames take a millisecond, and which waits for nobody.
class RealTimeArm final : public ArmDriver {
 public:
  explicit RealTimeArm(const ArmDescription& arm) : arm_(arm, kInstant_s) {}
  const ArmState& state() const override { return arm_.state(); }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return arm_.command(setpoint_kpa);
  }
  bool is_real_time() const override { return true; }
  void vent() noexcept override { arm_.vent(); }

 private:
  FakeArm arm_;
};

class PlanChains : public ::testing::Test {
 protected:
  /// Environment k has its goal where the arm is under `targets_kpa_[k]`, and a plan there; one
  /// without a target has none.
  PlannedRun plan_in(int number, const std::optional<ArmStart>& start) {
    std::this_thread::sleep_for(search_);
    starts_.push_back(start);
    PlannedRun result;
    result.run.environment = number;
    result.run.status = "limit";
    const std::optional<Pressures>& target_kpa = targets_kpa_.at(static_cast<std::size_t>(number));
    if (!target_kpa) {
      return result;
    }
    result.run.status = "solved";
    result.environment.start = start;
    result.environment.obstacles = obstacles_[static_cast<std::size_t>(number)];
    Plan plan =
        plan_through(arm_, {}, {start ? start->pressures_kpa : pressures(0.0F, 0.0F), *target_kpa});
    const Pose tip = tip_pose(plan.frames.back().backbone);
    result.environment.goal = {tip.x_m, tip.y_m};
    result.environment.goal.position_tolerance_m = 0.01;
    plan.environment_hash = environment_hash(result.environment);
    result.plan = plan;
    return result;
  }

  /// Environments from 0 on, in one chain.
  PlanRuns run(double max_s = kNoEnd_s) {
    FakeArm driver(arm_, kInstant_s, faults_);
    return run_on(driver, max_s);
  }

  PlanRuns run_on(ArmDriver& driver, double max_s = kNoEnd_s) {
    obstacles_.resize(targets_kpa_.size());
    PlanChain chain(arm_, 0, static_cast<int>(targets_kpa_.size()), max_s,
                    [this](int number, const auto& start) { return plan_in(number, start); });
    const PlannedRun* begun = chain.first_plan();
    if (begun == nullptr) {
      return chain.ended({});
    }
    ExecutionSettings settings;
    settings.controller = &chain;
    whole_ = execute(arm_, begun->environment, *begun->plan, driver, settings);
    EXPECT_EQ(whole_.status, ExecutionStatus::done) << whole_.message;
    return chain.ended(whole_);
  }

  ArmDescription arm_ = small_arm();
  std::vector<std::optional<Pressures>> targets_kpa_;
  std::vector<std::vector<Obstacle>> obstacles_;
  FakeFaults faults_;
  std::chrono::milliseconds search_{0};
  std::vector<std::optional<ArmStart>> starts_;
  ExecutionResult whole_;
};

TEST_F(PlanChains, EachPlanBeginsWhereTheOneBeforeEnded) {
  targets_kpa_ = {pressures(50, 0), pressures(50, -40), pressures(-20, 30)};
  const PlanRuns found = run();
  ASSERT_EQ(found.episodes.size(), 1U);
  ASSERT_EQ(starts_.size(), 3U);
  EXPECT_FALSE(starts_[0]);
  const Episode& episode = found.episodes.front();
  EXPECT_EQ(episode.backbone, whole_.episode.backbone);
  int row = 0;
  for (int k = 0; k < 3; ++k) {
    const PlanRun& one = found.runs[static_cast<std::size_t>(k)];
    const auto& target_kpa = targets_kpa_[static_cast<std::size_t>(k)];
    const int end = row + static_cast<int>(std::lround(one.duration_s / arm_.frame_period_s()));
    EXPECT_EQ(episode.setpoint_kpa.row(end), target_kpa->transpose()) << k;
    EXPECT_NE(episode.setpoint_kpa.row(row + 1), episode.setpoint_kpa.row(row)) << k;
    EXPECT_TRUE(std::all_of(episode.motion_index.begin() + row + 1,
                            episode.motion_index.begin() + end + 1,
                            [k](int motion) { return motion == k; }));
    EXPECT_TRUE(one.executed && one.recorded && one.arrived) << k;
    EXPECT_LT(one.distance_m.value(), 1e-4);
    EXPECT_EQ(one.was_vented, k == 0);
    if (k > 0) {
      const ArmStart& start = starts_[static_cast<std::size_t>(k)].value();
      EXPECT_EQ(start.pressures_kpa, *targets_kpa_[static_cast<std::size_t>(k - 1)]);
      EXPECT_EQ(start.backbone.reshaped<Eigen::RowMajor>().transpose(), episode.backbone.row(row));
    }
    row = end;
  }
  EXPECT_EQ(row, whole_.frames);  // and nothing is left over
  EXPECT_NEAR(found.arm_time_s, whole_.frames * arm_.frame_period_s(), 1e-9);
  EXPECT_EQ(found.ventings(), 1);
}

TEST_F(PlanChains, EnvironmentsWithoutAPlanArePassedOver) {
  targets_kpa_ = {std::nullopt, pressures(50, 0), std::nullopt, std::nullopt, pressures(0, 40)};
  const PlanRuns found = run();
  ASSERT_EQ(found.runs.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    const PlanRun& one = found.runs[static_cast<std::size_t>(k)];
    EXPECT_EQ(one.environment, k);
    EXPECT_EQ(one.executed, k == 1 || k == 4) << k;
    EXPECT_EQ(one.was_vented, k == 1) << k;
  }
  EXPECT_FALSE(starts_[1]);  // still vented
  EXPECT_EQ(starts_[4]->pressures_kpa, pressures(50, 0));
}

TEST_F(PlanChains, NothingIsExecutedWhereNoEnvironmentHasAPlan) {
  targets_kpa_ = {std::nullopt, std::nullopt};
  const PlanRuns found = run();
  EXPECT_EQ(found.runs.size(), 2U);
  EXPECT_EQ(found.ventings(), 0);
  EXPECT_EQ(found.arm_time_s, 0.0);
}

TEST_F(PlanChains, NoPlanBeginsWhenTheTimeIsOver) {
  targets_kpa_.assign(6, pressures(50, 0));
  targets_kpa_[1] = targets_kpa_[3] = targets_kpa_[5] = pressures(-50, 0);
  const double first_s = 0.25 + 1.0;  // 5 frames and the hold
  const PlanRuns found = run(first_s + 0.1);
  EXPECT_EQ(found.runs.size(), 2U);
  EXPECT_GT(found.arm_time_s, first_s + 0.1);
}

TEST_F(PlanChains, APlanIsJudgedInItsOwnEnvironment) {
  targets_kpa_ = {pressures(90, 90), pressures(-90, -90), pressures(0, 0)};
  obstacles_.resize(3);
  const Backbone bent =
      plan_through(arm_, {}, {pressures(0, 0), pressures(90, 90)}).frames.back().backbone;
  const Pose tip = tip_pose(bent);
  // Only the first plan's end, and the second one's start, are there.
  obstacles_[2] = {Circle{tip.x_m, tip.y_m, 0.01}};
  EXPECT_FALSE(run().runs[2].collided);
  starts_.clear();
  obstacles_[1] = obstacles_[2];
  const PlanRuns found = run();
  EXPECT_FALSE(found.runs[0].collided);
  EXPECT_TRUE(found.runs[1].collided);
  EXPECT_FALSE(found.runs[1].arrived);
  EXPECT_FALSE(found.runs[2].collided);
}

TEST_F(PlanChains, AChainOfOnePlanIsJudgedAsTheExecutorJudgedIt) {
  targets_kpa_ = {pressures(50, 0)};
  const PlanRuns found = run();
  ASSERT_EQ(found.runs.size(), 1U);
  EXPECT_EQ(found.runs[0].distance_m, whole_.goal_error.position_m);
  EXPECT_EQ(found.episodes[0].backbone, whole_.episode.backbone);
}

TEST_F(PlanChains, WhileThePlanAfterIsSearchedForTheArmIsHeldAndThatTimeCounts) {
  targets_kpa_ = {pressures(50, 0), pressures(50, -40), pressures(0, 0)};
  const double alone_s = run().arm_time_s;
  starts_.clear();
  search_ = std::chrono::milliseconds(40);
  RealTimeArm driver(arm_);
  const PlanRuns found = run_on(driver);
  ASSERT_EQ(found.episodes.size(), 1U);
  const Episode& episode = found.episodes.front();
  EXPECT_GT(found.arm_time_s, alone_s);
  EXPECT_NEAR(found.arm_time_s, whole_.frames * arm_.frame_period_s(), 1e-9);
  int row = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_TRUE(found.runs[k].arrived) << k;
    row += static_cast<int>(std::lround(found.runs[k].duration_s / arm_.frame_period_s()));
    EXPECT_EQ(episode.setpoint_kpa.row(row), targets_kpa_[k]->transpose()) << k;
    EXPECT_EQ(episode.motion_index[static_cast<std::size_t>(row)], static_cast<int>(k));
    if (k < 2) {  // the next frame is the next plan's
      EXPECT_NE(episode.setpoint_kpa.row(row + 1), episode.setpoint_kpa.row(row)) << k;
    }
  }
}

TEST_F(PlanChains, AChainEndsWhereItsSearchesTakeTooLong) {
  targets_kpa_.assign(300, std::nullopt);
  targets_kpa_.front() = targets_kpa_.back() = pressures(50, 0);
  search_ = std::chrono::milliseconds(10);  // 10 frames of 0.05 s
  RealTimeArm driver(arm_);
  EXPECT_LT(run_on(driver).runs.size(), 300U);
}

TEST_F(PlanChains, AnArmThatIsLostEndsTheChain) {
  targets_kpa_ = {pressures(50, 0), pressures(0, 0)};
  faults_.lost_from_s = 1.0;
  EXPECT_EQ(run().runs.size(), 1U);
}

}  // namespace
}  // namespace limber
