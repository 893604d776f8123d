#include "src/planning/certified/asked_problem.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class AskedProblemOf : public ::testing::Test {
 protected:
  void SetUp() override {
    const PlanResult found = setting_.plan("default", 1500);
    ASSERT_TRUE(found.plan);
    plan_ = *found.plan;
  }

  Setting setting_{true};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  Plan plan_;
};

TEST_F(AskedProblemOf, MakesItsCertifierOnce) {
  AskedProblem asked(problem_);
  const Certifier* first = &asked.certifier();
  (void)asked.environment_hash();
  EXPECT_EQ(&asked.certifier(), first);
}

// With a certifier at hand or without, the hash is the environment's.
TEST_F(AskedProblemOf, NamesTheEnvironmentTheSameBeforeAndAfter) {
  const std::string expected = environment_hash(setting_.environment);
  AskedProblem before(problem_);
  EXPECT_EQ(before.environment_hash(), expected);
  (void)before.certifier();
  EXPECT_EQ(before.environment_hash(), expected);
  AskedProblem after(problem_);
  (void)after.certifier();
  EXPECT_EQ(after.environment_hash(), expected);
}

TEST_F(AskedProblemOf, CertifiesAsTheCertificateDoes) {
  AskedProblem asked(problem_);
  const Certificate expected =
      certify(plan_, setting_.arm, &setting_.model.compensation(), {}, setting_.environment);
  const Certificate found = asked.certifier().certify(plan_);
  EXPECT_TRUE(expected.certified());
  EXPECT_TRUE(found.certified());
  EXPECT_EQ(found.clearance_m, expected.clearance_m);
  EXPECT_EQ(found.max_deviation_m, expected.max_deviation_m);
  EXPECT_EQ(found.goal_distance_m, expected.goal_distance_m);
  EXPECT_EQ(found.frames, expected.frames);
}

// It keeps a copy of the problem: searches change their own margins and models.
TEST_F(AskedProblemOf, IsWhatWasAskedWhateverSearchesMakeOfIt) {
  AskedProblem asked(problem_);
  const ForwardModel other(setting_.arm);
  problem_.margin_m = 0.2;
  problem_.model = MotionModel(other);
  EXPECT_TRUE(asked.certifier().certify(plan_).certified());
}

TEST_F(AskedProblemOf, AsksWithTheProblemsModelAndValves) {
  const ForwardModel no_load(setting_.arm);
  AskedProblem without_network({setting_.arm, no_load, setting_.environment});
  EXPECT_THAT([&] { (void)without_network.certifier().certify(plan_); },
              ThrowsMessage<InputError>(HasSubstr("another kind of model")));
  const ValveParameters valves{true, std::vector<SegmentValves>(3, {{0.1, 80.0}, {0.1, 80.0}})};
  AskedProblem with_valves({setting_.arm,
                            MotionModel(setting_.model, ValveModel(setting_.arm, valves)),
                            setting_.environment});
  EXPECT_THAT([&] { (void)with_valves.certifier().certify(plan_); },
              ThrowsMessage<InputError>(HasSubstr("another valve model")));
}

}  // namespace
}  // namespace limber
