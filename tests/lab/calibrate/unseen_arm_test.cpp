#include "limber/lab/unseen_arm.hpp"

#include <gtest/gtest.h>

#include "limber/common/data_folder.hpp"
#include "limber/lab/tube_runs.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {
namespace {

/// limber's own family of arms with two segments.
class UnseenArmTest : public testing::Test {
 protected:
  UnseenArmTest()
      : arm_(load_arm(data_folder() / "arms/two_segment.yaml")),
        family_(own_family(arm_).value()) {}

  ArmDescription arm_;
  CompensationModel family_;
};

TEST_F(UnseenArmTest, IsPredictedBetterThanTheFamilysMiddle) {
  constexpr int kArms = 4;
  double adapted_m = 0.0;
  double middle_m = 0.0;
  for (std::uint64_t number = 0; number < kArms; ++number) {
    const UnseenArm unseen = unseen_arm(arm_, family_, {WidePhysics{}, 20.0}, 77, number);
    EXPECT_NE(virtual_arm_to_yaml(unseen.arm), virtual_arm_to_yaml(arm_));
    EXPECT_EQ(unseen.arm.hash(), arm_.hash()) << "physics is no part of what plans are made for";
    EXPECT_FALSE(unseen.adaptation.has_trained_weights);
    EXPECT_NEAR(unseen.adaptation.seconds, 20.0, 0.1);
    adapted_m += unseen.adaptation.fitted_error_m;
    middle_m += unseen.adaptation.middle_error_m;
  }
  EXPECT_LT(adapted_m, 0.5 * middle_m);
}

TEST_F(UnseenArmTest, MovesAboutAMinuteStraightThroughPressureSpaceWhileItIsIdentified) {
  constexpr double kLongerThanItIs_s = 1000.0;
  constexpr float kRounding_kpa = 1e-3F;
  const Episode run = identifying_run(arm_, kLongerThanItIs_s, 77, 0);
  EXPECT_NEAR(run.time_s[run.time_s.size() - 1], 60.0, 15.0);
  const auto steps = run.setpoint_kpa.bottomRows(run.frame_count() - 1) -
                     run.setpoint_kpa.topRows(run.frame_count() - 1);
  EXPECT_LE(steps.cwiseAbs().maxCoeff(),
            static_cast<float>(arm_.pressure_step_limit_kpa()) + kRounding_kpa);
}

TEST_F(UnseenArmTest, OfAFamilyEachRunOfAPhaseHasAnArmOfItsOwnWhateverTheThreads) {
  TubeRunSettings settings;
  settings.arm = settings.executed_arm = arm_;
  settings.model = family_;
  settings.unseen = UnseenArms{WidePhysics{}, 10.0};
  settings.limits.queries = 1000;
  settings.progress = Progress::Mode::quiet;
  const auto run = [&](int jobs) {
    settings.jobs = jobs;
    return run_tube_phase(settings, {"shape", 2}, nullptr);
  };
  const TubeRuns one = run(1);
  const TubeRuns two = run(2);
  ASSERT_EQ(one.executed(), 2);
  ASSERT_EQ(one.all.size(), two.all.size());
  for (std::size_t i = 0; i < one.all.size(); ++i) {
    EXPECT_EQ(one.all[i].expected_error_m, two.all[i].expected_error_m);
    EXPECT_EQ(one.all[i].tip_m, two.all[i].tip_m);
    EXPECT_GT(one.all[i].expected_error_m, 0.0);
  }
  EXPECT_NE(one.all[0].expected_error_m, one.all[1].expected_error_m);
  EXPECT_GT(one.expected_error_m(), 0.0);
}

}  // namespace
}  // namespace limber
