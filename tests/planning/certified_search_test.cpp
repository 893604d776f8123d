#include "src/planning/certified/certifying_judge.hpp"

#include <gmock/gmock.h>

#include "limber/planning/plan_builder.hpp"
#include "planning/planner_setting.hpp"
#include "src/planning/certified/asked_problem.hpp"
#include "src/planning/plan_judge.hpp"
#include "src/planning/plan_ladder.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;

constexpr double kMarginM =
    3e-4;  // less than the plan of the setting keeps, which was asked for none

/// What a planner was asked for.
struct Asked {
  double margin_m = -1.0;
  PoseGoal goal;
  PoseError goal_margin;
  std::optional<PoseError> aim;
  bool goal_has_room = false;
  bool has_judge = false;
  bool yields = true;
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> iterations;
};

/// Notes what it is asked for, and answers with what a test gives it.
class Scripted final : public Planner {
 public:
  using Answer = std::function<PlanResult(const PlanningProblem&, const PlannerLimits&,
                                          std::uint64_t, const PlannerCallback&)>;
  explicit Scripted(Answer answer = {}) : answer_(std::move(answer)) {}
  const char* name() const override { return "scripted"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    asked = {problem.margin_m,
             problem.environment.goal,
             problem.goal_margin,
             problem.aim,
             problem.goal_has_room,
             problem.judge != nullptr,
             problem.margin_yields_to_start,
             seed,
             limits.iterations};
    return answer_ ? answer_(problem, limits, seed, callback) : PlanResult{};
  }

  Asked asked;

 private:
  Answer answer_;
};

class CertifiedSearch : public ::testing::Test {
 protected:
  void SetUp() override {
    limits_.iterations = 7;
    const PlanResult found = setting_.plan("default", 1500);
    ASSERT_TRUE(found.plan);
    sound_kpa_ = found.plan->waypoints_kpa;
    reckless_kpa_ = {sound_kpa_.front(), sound_kpa_.back()};
    ASSERT_LT(path_cost_kpa(reckless_kpa_), 0.95 * path_cost_kpa(sound_kpa_))
        << "the straight motion has to be the cheaper one";
  }

  PlanResult search(Planner& planner) {
    AskedProblem asked(problem_);
    return certified_search(planner, problem_, asked, limits_, 11, {});
  }

  /// Offers these motions in this order, as searches do, and ends.
  static Scripted offering(std::vector<std::vector<Pressures>> motions) {
    return Scripted([motions](const PlanningProblem& problem, const PlannerLimits& limits,
                              std::uint64_t seed, const PlannerCallback& callback) {
      const CollisionChecker checker(problem.arm, problem.environment.obstacles);
      MotionSimulator simulator(problem.arm, problem.model, checker);
      PlannerBudget budget(limits, callback);
      PlanLadder ladder(problem, simulator, budget, "scripted", seed);
      for (const std::vector<Pressures>& motion : motions) {
        (void)ladder.offer(motion, path_cost_kpa(motion), 1);
      }
      PlanResult result;
      ladder.finish(1, motions.front(), result);
      return result;
    });
  }

  /// Returns a plan of this motion as solved, and asks nobody.
  static Scripted claiming(std::vector<Pressures> motion) {
    return Scripted([motion](const PlanningProblem& problem, const PlannerLimits&,
                             std::uint64_t seed, const PlannerCallback&) {
      const CollisionChecker checker(problem.arm, problem.environment.obstacles);
      MotionSimulator simulator(problem.arm, problem.model, checker);
      PlanResult result;
      result.status = PlanStatus::solved;
      result.plan = build_plan(problem, simulator, motion, "scripted", seed);
      result.first_solution = FirstSolution{};
      result.events.resize(2);
      return result;
    });
  }

  Setting setting_{false};
  PlanningProblem problem_{setting_.arm, setting_.model, setting_.environment};
  PlannerLimits limits_;
  std::vector<Pressures> sound_kpa_, reckless_kpa_;
};

TEST_F(CertifiedSearch, SearchesWithALittleLessRoomThanWasAskedFor) {
  for (const double margin_m : {0.0, 0.5 * Certificate::kMinClearanceM, 0.01}) {
    problem_.margin_m = margin_m;
    Scripted planner;
    (void)search(planner);
    EXPECT_EQ(planner.asked.margin_m, std::max(margin_m, Certificate::kMinClearanceM) + kReserveM);
    EXPECT_EQ(planner.asked.goal.position_tolerance_m,
              setting_.environment.goal.position_tolerance_m - kReserveM);
    EXPECT_EQ(planner.asked.goal.x_m, setting_.environment.goal.x_m);
    EXPECT_TRUE(planner.asked.has_judge);
    EXPECT_FALSE(planner.asked.aim) << "there is no error to keep room for";
    EXPECT_FALSE(planner.asked.yields) << "the margin has yielded before";
    EXPECT_EQ(planner.asked.seed, 11U);
    EXPECT_EQ(planner.asked.iterations, 7U);
  }
}

TEST_F(CertifiedSearch, TakesTheModelsErrorOffTheGoal) {
  problem_.goal_margin = {0.005, 0.1};
  Scripted planner;
  (void)search(planner);
  const PoseGoal& goal = setting_.environment.goal;
  EXPECT_DOUBLE_EQ(planner.asked.goal.position_tolerance_m,
                   goal.position_tolerance_m - 0.005 - kReserveM);
  EXPECT_EQ(planner.asked.goal_margin.position_m, 0.0) << "it is taken off already";
  ASSERT_TRUE(planner.asked.aim);
  EXPECT_LT(planner.asked.aim->position_m, planner.asked.goal.position_tolerance_m);
  EXPECT_TRUE(planner.asked.goal_has_room);
  problem_.goal_margin.position_m = goal.position_tolerance_m;
  (void)search(planner);
  EXPECT_FALSE(planner.asked.goal_has_room);
  EXPECT_GT(planner.asked.goal.position_tolerance_m, 0.5 * goal.position_tolerance_m);
}

// The cheaper plan is refused and costs the dearer, sound one nothing, whichever came first.
TEST_F(CertifiedSearch, KeepsTheBestPlanThatIsCertified) {
  for (const bool sound_first : {true, false}) {
    Scripted planner =
        sound_first ? offering({sound_kpa_, reckless_kpa_}) : offering({reckless_kpa_, sound_kpa_});
    const PlanResult result = search(planner);
    ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
    EXPECT_EQ(result.plan->waypoints_kpa, sound_kpa_);
    ASSERT_TRUE(result.certificate);
    EXPECT_TRUE(result.certificate->certified());
    const Certificate alone =
        certify(*result.plan, setting_.arm, nullptr, {}, setting_.environment);
    EXPECT_TRUE(alone.certified());
    EXPECT_EQ(result.certificate->clearance_m, alone.clearance_m);
    EXPECT_EQ(result.plan->certified->clearance_m, alone.clearance_m);
  }
}

TEST_F(CertifiedSearch, SaysSoWhereEveryPlanIsRefused) {
  Scripted planner = offering({reckless_kpa_});
  const PlanResult result = search(planner);
  EXPECT_NE(result.status, PlanStatus::solved);
  EXPECT_FALSE(result.plan);
}

// A planner that asks nobody gets no plan past the certificate.
TEST_F(CertifiedSearch, JudgesWhatAPlannerClaims) {
  Scripted reckless = claiming(reckless_kpa_);
  const PlanResult refused = search(reckless);
  EXPECT_EQ(refused.status, PlanStatus::not_certified);
  EXPECT_FALSE(refused.plan);
  ASSERT_TRUE(refused.best_partial);
  EXPECT_EQ(refused.best_partial->waypoints_kpa, reckless_kpa_);
  EXPECT_FALSE(refused.first_solution);
  EXPECT_TRUE(refused.events.empty());
  ASSERT_TRUE(refused.certificate);
  EXPECT_FALSE(refused.certificate->certified());
  EXPECT_THAT(refused.reason, HasSubstr("is refused by its certificate"));
}

// Plans name the problem as it was asked, not the one with less room.
TEST_F(CertifiedSearch, PlansAreForTheProblemThatWasAsked) {
  problem_.margin_m = kMarginM;
  const std::string hash = environment_hash(setting_.environment);
  Scripted sound = claiming(sound_kpa_);
  const PlanResult solved = search(sound);
  ASSERT_TRUE(solved.plan) << solved.reason;
  EXPECT_EQ(solved.plan->environment_hash, hash);
  EXPECT_EQ(solved.plan->margin_m, kMarginM);
  Scripted nothing([&](const PlanningProblem& problem, const PlannerLimits&, std::uint64_t seed,
                       const PlannerCallback&) {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles);
    MotionSimulator simulator(problem.arm, problem.model, checker);
    PlanResult result;
    result.best_partial = build_plan(problem, simulator, reckless_kpa_, "scripted", seed);
    return result;
  });
  const PlanResult partial = search(nothing);
  ASSERT_TRUE(partial.best_partial);
  EXPECT_EQ(partial.best_partial->environment_hash, hash);
  EXPECT_EQ(partial.best_partial->margin_m, kMarginM);
}

}  // namespace
}  // namespace limber
