#include "limber/certificate/certificate.hpp"

#include <filesystem>
#include <functional>
#include <regex>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "certificate/solved_problem.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/report/plan_report.hpp"
#include "src/planning/certified/certified_planner.hpp"
#include "src/planning/paper/pressure_rrt_star.hpp"
#include "support/property.hpp"
#include "support/space_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

// A network that learnt from set points knows the valves along with the arm.
TEST(Certificate, PutsNoValvesBeforeWhatLearntFromSetPoints) {
  const Solved& s = solved();
  CompensationModel network = s.model.compensation();
  network.learnt_from_setpoints = true;
  EXPECT_TRUE(certify(s.plan, s.arm, &network, {}, s.environment).certified());
  const ValveParameters valves{true, std::vector<SegmentValves>(3, {{0.1, 80.0}, {0.1, 80.0}})};
  Plan with_valves = s.plan;
  with_valves.valves_hash = valves.hash();
  EXPECT_THAT([&] { (void)certify(with_valves, s.arm, &network, valves, s.environment); },
              ThrowsMessage<InputError>(HasSubstr("their lag would count twice")));
}

TEST(Certificate, APlannersPlanIsCertifiedWithRoomToSpare) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty()) << "not solved";
  const Certificate certificate = s.certificate(s.plan);
  EXPECT_THAT(failed_checks(certificate), IsEmpty());
  EXPECT_LT(certificate.max_deviation_m, Certificate::kDeviationM / 5);
  EXPECT_GE(certificate.clearance_m, Certificate::kMinClearanceM);
  EXPECT_NEAR(certificate.goal_distance_m, s.plan.goal_distance_m, Certificate::kDeviationM);
  EXPECT_NEAR(certificate.cost_kpa, s.plan.cost_kpa, 1e-9 * s.plan.cost_kpa);
  ASSERT_TRUE(s.plan.certified);
  EXPECT_EQ(s.plan.certified->clearance_m, certificate.clearance_m);
}

TEST(Certificate, ANoLoadPlanIsCertifiedToo) {
  const Solved& s = solved();
  const ForwardModel model(s.arm);
  PlannerLimits limits;
  limits.iterations = 1500;
  Environment environment = s.environment;
  environment.goal.theta_rad.reset();
  const PlanResult result = make_planner("paper")->plan({s.arm, model, environment}, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  EXPECT_TRUE(certify(*result.plan, s.arm, nullptr, {}, environment).certified());
}

TEST(Certificate, IsNoneBesideObstaclesOfNoNumbers) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  for (const Obstacle& obstacle :
       {Obstacle(Circle{std::nan(""), 0.0, 0.1}), Obstacle(Circle{0.3, 0.0, -0.1}),
        Obstacle(Rectangle{0.3, 0.0, 0.1, 0.0, 0.0}), Obstacle(Polygon{})}) {
    Environment environment = s.environment;
    environment.obstacles = {obstacle};
    const Certifier certifier(s.arm, &s.model.compensation(), {}, environment);
    Plan plan = s.plan;
    plan.environment_hash = certifier.environment_hash();
    EXPECT_THAT([&] { (void)certifier.certify(plan); },
                ThrowsMessage<InputError>(HasSubstr("obstacles[0]: expected finite numbers")));
  }
}

// Each way of changing a plan by hand, and the check that must notice it.
class CertificateOf : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(NetworkAndNoLoad, CertificateOf, testing::Bool());

TEST_P(CertificateOf, RefusesAPlanChangedByHandInAnyField) {
  const Solved& s = solved(GetParam());
  ASSERT_TRUE(s.certificate(s.plan).certified());
  ASSERT_FALSE(s.plan.frames.empty());
  const struct {
    const char* check;
    std::function<void(Plan&)> change;
  } cases[] = {
      {"waypoints", [](Plan& p) { p.frames[5].setpoint_kpa[1] += 0.01F; }},
      {"start", [](Plan& p) { p.frames[0].setpoint_kpa[0] += 0.01F; }},
      {"rate", [](Plan& p) { p.frames[5].setpoint_kpa[1] += 20.0F; }},
      {"limits", [](Plan& p) { p.frames.back().setpoint_kpa[0] = 101.0F; }},
      {"limits",
       [](Plan& p) {
         p.limits.assign(3, PressureLimits(100.0));
         p.limits[1] = 0.5 * double(p.waypoints_kpa.back().cwiseAbs()[1]);
       }},
      {"sizes", [](Plan& p) { p.limits.assign(2, PressureLimits(100.0)); }},
      {"hold", [](Plan& p) { p.frames.back().setpoint_kpa[2] += 1e-4F; }},
      {"hold", [](Plan& p) { p.hold_frame_count = 5; }},
      {"model", [](Plan& p) { p.frames[7].backbone(9, 0) += 2e-4F; }},
      {"model", [](Plan& p) { p.frames[0].backbone(15, 1) -= 2e-4F; }},
      {"model", [](Plan& p) { p.frames.back().backbone(3, 2) += 2e-3F; }},
      {"cost", [](Plan& p) { p.cost_kpa -= 0.01; }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa[1][0] += 0.01F; }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa.pop_back(); }},
      {"waypoints", [](Plan& p) { p.waypoints_kpa.push_back(p.waypoints_kpa.back()); }},
      {"waypoints", [](Plan& p) { p.frames.erase(p.frames.begin() + 6); }},
      {"model",
       [](Plan& p) {
         p.frames.pop_back();
         p.frames.back().backbone.setZero();
       }},
      {"valves", [](Plan& p) { p.frames[6].pressure_kpa[1] += 2e-3F; }},
      {"claims", [](Plan& p) { p.clearance_m += 0.01; }},
      {"claims", [](Plan& p) { p.goal_distance_m -= 0.001; }},
      {"claims", [](Plan& p) { p.goal_orientation_rad += 0.01; }},
      {"collision", [](Plan& p) { p.margin_m = p.clearance_m + 0.002; }},
      {"sizes", [](Plan& p) { p.frame_rate_hz = 40.0; }},
      {"sizes", [](Plan& p) { p.frames[4].setpoint_kpa.conservativeResize(2); }},
      {"seal", [](Plan& p) { p.certified->seal_is_intact = false; }},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    Plan changed = s.plan;
    cases[i].change(changed);
    EXPECT_THAT(failed_checks(s.certificate(changed)), Contains(cases[i].check)) << "case " << i;
  }
}

TEST(Certificate, RandomPerturbationsOfAnyFrameAreRefused) {
  ASSERT_FALSE(solved().plan.frames.empty());
  expect_law("a perturbed plan is refused", [] {
    const Solved& s = solved();
    Plan changed = s.plan;
    const auto k = *rc::gen::inRange<std::size_t>(0, changed.frames.size());
    const bool of_backbone = *rc::gen::arbitrary<bool>();
    const float sign = *rc::gen::element(-1.0F, 1.0F);
    // Hundredths above what the certificate lets pass, evenly in the logarithm.
    const float size = std::pow(10.0F, 0.01F * float(*rc::gen::inRange(0, 300)));
    if (of_backbone) {
      const auto entry = *rc::gen::inRange<Eigen::Index>(0, changed.frames[k].backbone.size());
      changed.frames[k].backbone.data()[entry] +=
          sign * size * (entry % 3 == 2 ? 1.3e-3F : 1.3e-4F);
    } else {
      const auto i = *rc::gen::inRange<Eigen::Index>(0, 3);
      changed.frames[k].setpoint_kpa[i] += sign * size * 3e-4F;
    }
    RC_ASSERT(!s.certificate(changed).certified());
  });
}

TEST(Certificate, CollisionsAndMissedGoalsAreNamedWithPlateObstacleAndAmount) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  Environment environment = s.environment;
  const Backbone& last = s.plan.frames.back().backbone;
  environment.obstacles.push_back(Circle{double(last(12, 0)), double(last(12, 1)), 0.001});
  environment.goal.x_m += 0.1;
  Plan plan = s.plan;
  plan.environment_hash = environment_hash(environment);
  const Certificate certificate = certify(plan, s.arm, &s.model.compensation(), {}, environment);
  EXPECT_THAT(failed_checks(certificate), AllOf(Contains("collision"), Contains("goal")));
  for (const CertificateFailure& failure : certificate.failures) {
    if (failure.check == "collision") {
      EXPECT_THAT(failure.message, AllOf(HasSubstr("obstacle 3 (circle)"), HasSubstr("plates ")));
    }
    if (failure.check == "goal") {
      EXPECT_THAT(failure.message, HasSubstr("cm from the goal; tolerance 2.000 cm"));
      EXPECT_EQ(failure.frame, plan.frame_count() - 1);
    }
  }
}

TEST(Certifier, SaysTheSameOfEveryPlanAsOneMadeForItAlone) {
  const Solved& s = solved();
  const ValveParameters ideal;
  const Certifier certifier(s.arm, &s.model.compensation(), ideal, s.environment);
  EXPECT_EQ(certifier.environment_hash(), environment_hash(s.environment));
  Plan other = s.plan;
  other.frames[7].backbone(9, 0) += 2e-4F;
  for (const Plan& plan : {s.plan, other, s.plan}) {
    const Certificate again = certifier.certify(plan);
    const Certificate alone = s.certificate(plan);
    EXPECT_EQ(to_json(again, s.arm.command, s.environment),
              to_json(alone, s.arm.command, s.environment));
    EXPECT_FALSE(again.unfinished);
  }
}

// Whenever it gives up, it says so, and is never certified.
TEST(Certifier, GivesUpWhenAskedTo) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  const ValveParameters ideal;
  const Certifier certifier(s.arm, &s.model.compensation(), ideal, s.environment);
  int asked = 0;
  ASSERT_TRUE(certifier.certify(s.plan, [&] { return ++asked < 0; }).certified());
  ASSERT_GT(asked, 2 * s.plan.frame_count()) << "simulation and collision both ask";
  for (int when = 1; when <= asked; ++when) {
    int left = when;
    const Certificate certificate = certifier.certify(s.plan, [&] { return --left <= 0; });
    EXPECT_TRUE(certificate.unfinished);
    EXPECT_FALSE(certificate.certified());
    ASSERT_THAT(failed_checks(certificate), ElementsAre("unfinished")) << when;
    EXPECT_THAT(certificate.failures.front().message, HasSubstr("not finished in the time left"));
    EXPECT_EQ(left, 0) << "asked again after it gave up";
  }
}

// Another machine's fit of the same bench test: the same arm, and the plan still holds on it.
TEST(Certificate, HoldsForTheSameArmFittedElsewhere) {
  const Solved& s = solved();
  ArmDescription arm = s.arm;
  for (Segment& segment : arm.segments) {
    segment.strain_polynomial[0] += 0.99 * kSameStrain / segment.pressure_limit_kpa.largest_kpa();
  }
  ASSERT_NE(arm.hash(), s.arm.hash());
  CompensationModel model = s.model.compensation();
  model.set_arm(s.arm);
  const Certificate certificate = certify(s.plan, arm, &model, {}, s.environment);
  EXPECT_GT(certificate.max_deviation_m, 1e-6) << "another arm in its last digits";
  EXPECT_TRUE(certificate.certified());
}

TEST(Certificate, OtherArmsEnvironmentsAndModelsAreBadInput) {
  const Solved& s = solved();
  ArmDescription arm = s.arm;
  arm.segments[0].length_m += 0.001;
  EXPECT_THAT([&] { (void)certify(s.plan, arm, &s.model.compensation(), {}, s.environment); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("made for another arm"),
                                              HasSubstr(s.arm.hash()), HasSubstr(arm.hash()))));
  Environment environment = s.environment;
  environment.goal.x_m += 1e-3;
  EXPECT_THAT([&] { (void)certify(s.plan, s.arm, &s.model.compensation(), {}, environment); },
              ThrowsMessage<InputError>(HasSubstr("made for another environment")));
  EXPECT_THAT([&] { (void)certify(s.plan, s.arm, nullptr, {}, s.environment); },
              ThrowsMessage<InputError>(HasSubstr("another kind of model")));
}

TEST(Certificate, ValvesOfAnotherArmAndArmsInSpaceAreBadInput) {
  const Solved& s = solved();
  const ValveParameters two{true, std::vector<SegmentValves>(2, {{0.1, 80.0}, {0.1, 80.0}})};
  Plan plan = s.plan;
  plan.valves_hash = two.hash();
  EXPECT_THAT([&] { (void)certify(plan, s.arm, &s.model.compensation(), two, s.environment); },
              ThrowsMessage<InputError>(HasSubstr("valves: 2 segments found; the arm has 3")));
  const ArmDescription hanging = testing_support::space_arm();
  plan = s.plan;
  plan.arm_hash = hanging.hash();
  plan.model = "no_load";
  EXPECT_THAT([&] { (void)certify(plan, hanging, nullptr, {}, s.environment); },
              ThrowsMessage<InputError>(HasSubstr("a certificate can't use an arm in space yet")));
}

TEST(Certificate, TheSealBreaksWhateverIsChangedInTheFile) {
  const Solved& s = solved();
  ASSERT_FALSE(s.plan.frames.empty());
  const TemporaryFolder folder;
  const auto file = folder.path() / "p.json";
  write_plan(file, s.plan);
  EXPECT_TRUE(read_plan(file).certified->seal_is_intact);
  const std::string text = read_file(file);
  for (const auto& [from, to] : {std::pair{"\"seed\": 3", "\"seed\": 4"},
                                 std::pair{"\"planner\": \"default\"", "\"planner\": \"paper\""}}) {
    std::string changed = text;
    ASSERT_NE(changed.find(from), std::string::npos);
    changed.replace(changed.find(from), std::string(from).size(), to);
    write_file_atomically(file, changed);
    EXPECT_FALSE(read_plan_unchecked(file).certified->seal_is_intact) << from;
    EXPECT_THAT([&] { (void)read_plan(file); },
                ThrowsMessage<InputError>(HasSubstr("changed since it was certified")));
  }
  // Layout and order are nobody's business.
  write_file_atomically(file, nlohmann::json::parse(text).dump());
  EXPECT_TRUE(read_plan(file).certified->seal_is_intact);
}

/// Returns a plan whose last backbone is not what the model says.
class BrokenPlanner final : public Planner {
 public:
  const char* name() const override { return "broken"; }
  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    PlanResult result = make_pressure_rrt_star()->plan(problem, limits, seed, callback);
    if (result.plan) {
      result.plan->frames.back().backbone(15, 0) += 0.001F;
    }
    return result;
  }
};

TEST(CertifiedPlanner, APlanThatIsRefusedIsADefectAndNoSolution) {
  const Solved& s = solved();
  PlannerLimits limits;
  limits.iterations = 1500;
  const PlanResult result = make_certified_planner(std::make_unique<BrokenPlanner>(), 0)
                                ->plan({s.arm, s.model, s.environment}, limits, 3);
  ASSERT_EQ(result.status, PlanStatus::not_certified) << result.reason;
  EXPECT_FALSE(result.plan);
  EXPECT_TRUE(result.best_partial);
  EXPECT_THAT(result.reason, HasSubstr("planner 'paper' found is refused by its "
                                       "certificate, the cheapest for this: model"));
}

// The certificate is worth as much as it is independent: its sources see plain
// values of the world, and nothing of it that computes.
TEST(Certificate, ItsSourcesIncludeNothingThatThePlannerComputesWith) {
  const std::regex include("#include \"(limber/[^\"]+)\"");
  const std::vector<std::string> allowed{"limber/arm/arm_description.hpp",
                                         "limber/arm/names.hpp",
                                         "limber/arm/backbone.hpp",
                                         "limber/arm/valve_parameters.hpp",
                                         "limber/common/cpu_level.hpp",
                                         "limber/common/error.hpp",
                                         "limber/common/interrupt.hpp",
                                         "limber/common/refuse_if.hpp",
                                         "limber/common/units.hpp",
                                         "limber/network/compensation_model.hpp",
                                         "limber/certificate/certificate.hpp",
                                         "limber/world/environment.hpp",
                                         "limber/world/plan.hpp"};
  int seen = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(LIMBER_SOURCE_DIR) / "src/certificate")) {
    const std::string text = entry.is_regular_file() ? read_file(entry.path()) : "";
    for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
      EXPECT_THAT(allowed, Contains((*it)[1].str())) << entry.path();
      ++seen;
    }
  }
  EXPECT_GE(seen, 10);
}

}  // namespace
}  // namespace limber
