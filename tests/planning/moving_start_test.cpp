// Plans that start in mid-motion.
#include <gmock/gmock.h>

#include "limber/certificate/certificate.hpp"
#include "limber/forward/motion_simulator.hpp"
#include "limber/planning/plan_builder.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/planner_setting.hpp"

namespace limber {
namespace {

using ::testing::Contains;
using ::testing::Field;
using ::testing::IsEmpty;

constexpr std::size_t kCut = 6;  // frame of a plan in which the arm moves

/// Slow valves with a dead time of more than two frames, and a plan through them.
struct MovingSetting : Setting {
  ValveParameters parameters{
      true, std::vector<SegmentValves>(3, {{0.1, 100.0}, {0.12, 100.0}, 0.12, 0.2})};
  MotionModel motion{model, ValveModel(arm, parameters)};
  Plan whole;

  explicit MovingSetting(float momentum) : Setting(true, momentum) {
    PlannerLimits limits;
    limits.iterations = 2500;
    PlanResult result = make_planner("default", 1)->plan({arm, motion, environment}, limits, 3);
    EXPECT_EQ(result.status, PlanStatus::solved) << result.reason;
    whole = std::move(*result.plan);
  }

  /// The environment of an arm in frame kCut of the plan.
  Environment in_motion() const {
    Environment result = environment;
    const PlanFrame& now = whole.frames[kCut];
    result.start = ArmStart{now.pressure_kpa, now.backbone};
    result.start->before = whole.frames[kCut - 1].backbone;
    for (std::size_t k = kCut + 1; k-- > 0;) {
      result.start->setpoints_kpa.push_back(whole.frames[k].setpoint_kpa);
    }
    return result;
  }

  Certificate certificate(const Plan& plan, const Environment& where) const {
    return certify(plan, arm, &model.compensation(), parameters, where);
  }
};

std::vector<Pressures> rest_of_waypoints(const Plan& plan, const ArmDescription& arm) {
  std::vector<Pressures> rest{plan.frames[kCut].setpoint_kpa};
  std::size_t frame = 0;
  for (std::size_t w = 1; w < plan.waypoints_kpa.size(); ++w) {
    frame += std::size_t(motion_frame_count(plan.waypoints_kpa[w - 1], plan.waypoints_kpa[w],
                                            arm.pressure_step_limit_kpa()));
    if (frame > kCut) {
      rest.push_back(plan.waypoints_kpa[w]);
    }
  }
  return rest;
}

/// Of models that read velocities, and of others.
class MovingStart : public testing::TestWithParam<float> {};

INSTANTIATE_TEST_SUITE_P(Momentum, MovingStart, testing::Values(0.0F, kMomentum));

TEST_P(MovingStart, TheRestOfAPlanIsAPlanFromWhereTheArmIsThen) {
  constexpr float kRoundingKpa = 1e-4F;  // of the set points between two waypoints
  constexpr float kRoundingM = 1e-5F;
  const MovingSetting s(GetParam());
  const Environment here = s.in_motion();
  const PlanningProblem problem{s.arm, s.motion, here};
  const CollisionChecker checker = checker_of(problem);
  MotionSimulator simulator(s.arm, s.motion, checker);
  const Plan rest = build_plan(problem, simulator, rest_of_waypoints(s.whole, s.arm), "rest", 1);
  ASSERT_EQ(rest.frames.size() + kCut, s.whole.frames.size());
  for (std::size_t k = 0; k < rest.frames.size(); ++k) {
    const PlanFrame& expected = s.whole.frames[kCut + k];
    EXPECT_TRUE(rest.frames[k].setpoint_kpa.isApprox(expected.setpoint_kpa, kRoundingKpa)) << k;
    EXPECT_LT((rest.frames[k].pressure_kpa - expected.pressure_kpa).cwiseAbs().maxCoeff(),
              10.0F * kRoundingKpa)
        << k;
    EXPECT_LT((rest.frames[k].backbone - expected.backbone).cwiseAbs().maxCoeff(), kRoundingM) << k;
  }
  EXPECT_TRUE(s.certificate(rest, here).certified());
}

TEST_P(MovingStart, ItsStateHoldsWhatIsStillDelayed) {
  const MovingSetting s(GetParam());
  const std::vector<PlanFrame> until(s.whole.frames.begin(), s.whole.frames.begin() + kCut + 1);
  const Environment here = s.in_motion();
  ASSERT_GT(s.motion.valves().setpoint_count(), 2);
  EXPECT_TRUE(state_of(*here.start, s.motion) == state_after(until, s.motion));
}

TEST_P(MovingStart, EveryPlannersPlanIsCertifiedFromThere) {
  const MovingSetting s(GetParam());
  const Environment here = s.in_motion();
  for (const char* planner : {"default", "paper,valves=1"}) {
    PlannerLimits limits;
    limits.iterations = 2500;
    const PlanResult result = make_planner(planner, 1)->plan({s.arm, s.motion, here}, limits, 4);
    ASSERT_EQ(result.status, PlanStatus::solved) << planner << ": " << result.reason;
    EXPECT_EQ(result.plan->frames[0].setpoint_kpa, s.whole.frames[kCut].setpoint_kpa);
    EXPECT_EQ(result.plan->frames[0].pressure_kpa, s.whole.frames[kCut].pressure_kpa);
    EXPECT_TRUE(s.certificate(*result.plan, here).certified()) << planner;
  }
}

TEST_P(MovingStart, AGivenMotionBeginsAtTheSetPointsInForce) {
  const MovingSetting s(GetParam());
  const Environment here = s.in_motion();
  std::vector<Pressures> rest = rest_of_waypoints(s.whole, s.arm);
  ASSERT_NE(rest.front(), here.start->pressures_kpa);
  rest.erase(rest.begin());
  const PlanResult result = plan_along({s.arm, s.motion, here}, rest, "mine");
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_EQ(result.plan->waypoints_kpa.front(), here.start->setpoint_kpa());
  EXPECT_TRUE(s.certificate(*result.plan, here).certified());
}

TEST_P(MovingStart, ACertificateKnowsWhatWasCommandedAndWhatWasMeasured) {
  const MovingSetting s(GetParam());
  const Environment here = s.in_motion();
  PlannerLimits limits;
  limits.iterations = 2500;
  const PlanResult result = make_planner("default", 1)->plan({s.arm, s.motion, here}, limits, 4);
  ASSERT_EQ(result.status, PlanStatus::solved);
  const auto failures_from = [&](const Environment& other) {
    Plan plan = *result.plan;
    plan.certified.reset();
    plan.environment_hash = environment_hash(other);
    return s.certificate(plan, other).failures;
  };
  const auto is = [](const char* check) { return Field(&CertificateFailure::check, check); };
  EXPECT_TRUE(failures_from(here).empty());
  Environment other = here;
  other.start->pressures_kpa[1] += 1.0F;
  EXPECT_THAT(failures_from(other), Contains(is("valves")));
  other = here;
  other.start->setpoints_kpa[1][0] += 5.0F;  // one that is still delayed
  EXPECT_THAT(failures_from(other), Contains(is("valves")));
  other = here;
  other.start->setpoints_kpa[0][0] += 0.5F;
  EXPECT_THAT(failures_from(other), Contains(is("start")));
  other = here;
  other.start->setpoints_kpa.clear();  // at rest: then the pressures are the set points
  EXPECT_THAT(failures_from(other), Contains(is("start")));
  other = here;
  other.start->before.resize(0, 3);  // it stood still
  if (GetParam() > 0.0F) {
    EXPECT_THAT(failures_from(other), Contains(is("model")));
  } else {
    EXPECT_THAT(failures_from(other), IsEmpty());
  }
}

}  // namespace
}  // namespace limber
