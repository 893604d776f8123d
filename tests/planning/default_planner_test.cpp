#include "src/planning/search/default_planner.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "planning/planner_setting.hpp"
#include "src/planning/plan_judge.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Refuses what is cheaper than it likes.
class Dear final : public PlanJudge {
 public:
  explicit Dear(double min_kpa) : min_kpa_(min_kpa) {}
  Verdict judge(Plan& plan, const std::function<bool()>&) override {
    return plan.cost_kpa >= min_kpa_ ? Verdict::holds : Verdict::refused;
  }

 private:
  double min_kpa_;
};

TEST(DefaultPlanner, SearchesOnFromWhatItsJudgeLetsStand) {
  Setting s(false);
  PlannerLimits limits;
  limits.iterations = 1500;
  const double min_kpa =
      make_default_planner()->plan({s.arm, s.model, s.environment}, limits, 3).plan->cost_kpa;
  Dear judge(1.05 * min_kpa);
  PlanningProblem judged{s.arm, s.model, s.environment};
  judged.judge = &judge;
  const PlanResult result = make_default_planner()->plan(judged, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::solved);
  EXPECT_GE(result.plan->cost_kpa, 1.05 * min_kpa);
  EXPECT_LE(result.plan->cost_kpa, 1.3 * min_kpa);
}

// Batches end a little beyond it; what comes after the search is one plan more, built and measured.
TEST(DefaultPlanner, ImprovingEndsWhenItHasHadItsQueries) {
  const Setting s(true);
  DefaultPlannerSettings settings;
  settings.improvement_queries = 20'000;
  settings.improvement_queries_without_room = 5'000;
  PlannerLimits limits;
  limits.queries = 1'000'000;
  constexpr double kBatch = 6'000;
  for (const bool has_room : {true, false}) {
    PlanningProblem problem{s.arm, s.model, s.environment};
    problem.goal_has_room = has_room;
    const PlanResult result = make_default_planner(settings)->plan(problem, limits, 3);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_FALSE(result.limit);
    EXPECT_THAT(result.reason, HasSubstr("improving the plan has ended"));
    const double spent = double(result.statistics.queries - result.first_solution->queries);
    EXPECT_NEAR(spent, has_room ? 20'000 : 5'000, kBatch);
    expect_lawful(s, *result.plan);
  }
}

/// Friction holds the arm bent, without pressure, in the goal: so says a network with much play.
/// For one with hardly any the arm is straight after the hold, beside the goal.
struct HeldInGoal {
  ArmDescription arm = three_segment_arm();
  Environment environment;

  HeldInGoal() {
    const Backbone bent = no_load_backbone(NoLoadModel(arm), Eigen::Vector3f(5.0F, 0.0F, 0.0F));
    const Pose tip = tip_pose(bent);
    environment.start = ArmStart{Pressures::Zero(3), bent};
    environment.goal = {tip.x_m, tip.y_m, std::nullopt, 0.004, 0.3};
  }

  PlanResult plan(const CompensationModel& network) const {
    const ForwardModel model(arm, network);
    PlannerLimits limits;
    limits.iterations = 50;
    return make_default_planner()->plan({arm, model, environment}, limits, 3);
  }
};

TEST(DefaultPlanner, StaysWhereItIsOnlyIfEachNetworkFindsThatInTheGoal) {
  const HeldInGoal s;
  CompensationModel network = play_network(s.arm, 0.05F);
  const PlanResult alone = s.plan(network);
  ASSERT_EQ(alone.status, PlanStatus::solved) << alone.reason;
  EXPECT_EQ(alone.plan->cost_kpa, 0.0);
  network.more_members.push_back(play_network(s.arm, 0.0005F).layers);
  const PlanResult both = s.plan(network);
  EXPECT_TRUE(!both.plan || both.plan->cost_kpa > 0.0);
}

// The straight arm is 1.4 cm from the centre of a goal of 2 cm; ends in its inner 2 mm come first.
TEST(DefaultPlanner, LeavesAStartThatIsInTheGoalButNotInItsAim) {
  constexpr double kAimM = 0.002;
  constexpr double kRoundingM = 1e-6;
  Setting s(false);
  s.environment.goal = {0.704, 0.014, std::nullopt, 0.02, 0.3};
  PlanningProblem problem{s.arm, s.model, s.environment};
  PlannerLimits limits;
  limits.iterations = 1500;
  const PlanResult stays = make_default_planner()->plan(problem, limits, 3);
  ASSERT_EQ(stays.status, PlanStatus::solved) << stays.reason;
  EXPECT_EQ(stays.plan->cost_kpa, 0.0) << "without an aim all of the goal is alike";
  problem.aim = PoseError{kAimM, 0.03};
  const PlanResult moves = make_default_planner()->plan(problem, limits, 3);
  ASSERT_EQ(moves.status, PlanStatus::solved) << moves.reason;
  EXPECT_GT(moves.plan->cost_kpa, 0.0);
  EXPECT_LE(moves.plan->goal_distance_m, kAimM + kRoundingM);
}

TEST(DefaultPlanner, RefusesSettingsOutOfRange) {
  DefaultPlannerSettings settings;
  settings.goal_bias = 0.8;
  EXPECT_THAT([&] { (void)make_default_planner(settings); },
              ThrowsMessage<InputError>(
                  HasSubstr("goal_bias + goal_steering_share = 1.1; expected 0 to 1")));
}

}  // namespace
}  // namespace limber
