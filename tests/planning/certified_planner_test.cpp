#include "src/planning/certified/certified_planner.hpp"

#include <gtest/gtest.h>

#include "planning/planner_setting.hpp"
#include "src/planning/plan_ladder.hpp"

namespace limber {
namespace {

/// Its cheapest plan goes straight through whatever stands in the way.
class Reckless final : public Planner {
 public:
  Reckless(std::vector<Pressures> sound, std::vector<Pressures> reckless)
      : sound_(std::move(sound)), reckless_(std::move(reckless)) {}
  const char* name() const override { return "reckless"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    const CollisionChecker checker(problem.arm, problem.environment.obstacles, problem.margin_m);
    MotionSimulator simulator(problem.arm, problem.model, checker);
    PlannerBudget budget(limits, callback);
    PlanLadder ladder(problem, simulator, budget, name(), seed);
    (void)ladder.offer(sound_, path_cost_kpa(sound_), 1);
    (void)ladder.offer(reckless_, path_cost_kpa(reckless_), 2);
    PlanResult result;
    ladder.finish(2, sound_, result);
    return result;
  }

 private:
  std::vector<Pressures> sound_, reckless_;
};

TEST(CertifiedPlanner, ReturnsTheBestPlanThatItsCertificateLetsStand) {
  Setting s(false);
  const PlanResult sound = s.plan("default", 1500);
  ASSERT_TRUE(sound.plan);
  const std::vector<Pressures>& way = sound.plan->waypoints_kpa;
  const std::vector<Pressures> straight{way.front(), way.back()};
  ASSERT_LT(motion_cost_kpa(way.front(), way.back()), 0.95 * sound.plan->cost_kpa)
      << "no way round: nothing would be refused";
  const PlanResult result = make_certified_planner(std::make_unique<Reckless>(way, straight), 0)
                                ->plan({s.arm, s.model, s.environment},
                                       [] {
                                         PlannerLimits limits;
                                         limits.iterations = 1;
                                         return limits;
                                       }(),
                                       1, {});
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.plan->waypoints_kpa.size(), way.size());
  EXPECT_TRUE(result.certificate->certified());
  EXPECT_GT(result.first_solution->certificate_s, 0.0);
  expect_lawful(s, *result.plan);
}

}  // namespace
}  // namespace limber
