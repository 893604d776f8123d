// The library's front door, `plan`: what `limber plan` does by default.
#include <gmock/gmock.h>

#include "limber/arm/arm_identity.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/planner_setting.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr PredictionError kError{40, 3.0, 0.02, 0.012, 0.007, 0.05};

/// So wide that no shape of the arm meets them.
GapBounds wide_bounds(const ArmDescription& arm) {
  const int gaps = arm.point_count() - 1;
  return {Eigen::VectorXf::Constant(gaps, 0.01F), Eigen::VectorXf::Constant(gaps, 0.2F),
          Eigen::VectorXf::Constant(gaps, -3.0F), Eigen::VectorXf::Constant(gaps, 3.0F)};
}

struct Trained {
  ArmDescription arm = three_segment_arm();
  CompensationModel network = play_network(arm, kPlayM);
  Environment environment = pillars();
  PlannerLimits limits;

  Trained() {
    network.bounds = wide_bounds(arm);
    network.prediction_error = kError;
    network.valves = ValveParameters{
        true, std::vector<SegmentValves>(3, {{0.1, 100.0}, {0.12, 100.0}, 0.02, 0.2})};
    limits.iterations = 2500;
  }

  PlanResult plan(const PlanSettings& settings = {}) const {
    return limber::plan(arm, network, environment, limits, 3, settings);
  }
};

std::string bytes_of(const Plan& plan, const TemporaryFolder& folder) {
  write_plan(folder.path() / "plan.json", plan);
  return read_file(folder.path() / "plan.json");
}

TEST(PlanWithModel, IsThePlanOfTheProblemThatKeepsTheModelsRoomBehindItsValves) {
  const TemporaryFolder folder;
  const Trained s;
  const PlanResult result = s.plan();
  ASSERT_EQ(result.status, PlanStatus::solved) << result.reason;
  const ForwardModel forward(s.arm, s.network);
  const MotionModel model(forward, ValveModel(s.arm, *s.network.valves));
  const PlanResult by_hand = make_planner("default")->plan(
      problem_with_room(s.arm, model, s.environment, error_room(forward)), s.limits, 3);
  ASSERT_TRUE(by_hand.plan);
  EXPECT_EQ(bytes_of(*result.plan, folder), bytes_of(*by_hand.plan, folder));
}

TEST(PlanWithModel, MovesNoFasterThanAskedAndStaysAPlanOfTheArm) {
  Trained s;
  s.network.arm_description = arm_keys_to_yaml(s.arm);
  constexpr double kRate = 25.0;  // [kPa/s], a quarter of the arm's
  PlanSettings slow;
  slow.rate_limit_kpa_per_s = kRate;
  const PlanResult result = s.plan(slow);
  ASSERT_TRUE(result.plan) << result.reason;
  float steepest = 0.0F;
  for (std::size_t k = 1; k < result.plan->frames.size(); ++k) {
    steepest = std::max(
        steepest, (result.plan->frames[k].setpoint_kpa - result.plan->frames[k - 1].setpoint_kpa)
                      .cwiseAbs()
                      .maxCoeff());
  }
  EXPECT_LE(steepest * s.arm.frame_rate_hz, kRate * (1.0 + 1e-5));
  EXPECT_NO_THROW(require_plan_of(*result.plan, s.arm, "the plan"));
  EXPECT_EQ(rate_limit_of(result.plan->arm(), "the plan"), kRate);
  for (const double wrong : {0.0, -1.0, 101.0}) {
    slow.rate_limit_kpa_per_s = wrong;
    EXPECT_THAT([&] { (void)s.plan(slow); },
                ThrowsMessage<InputError>(HasSubstr("at most the arm's 100")));
  }
  slow.rate_limit_kpa_per_s = 1e-9;
  EXPECT_THAT([&] { (void)s.plan(slow); },
              ThrowsMessage<InputError>(HasSubstr("frames; expected at most 1000000")));
}

TEST(PlanWithModel, KeepsTheErrorThatTheModelStates) {
  const Trained s;
  const PlanResult result = s.plan();
  ASSERT_TRUE(result.plan) << result.reason;
  EXPECT_EQ(result.plan->margin_m, kError.off_path_m);
  EXPECT_GE(result.plan->clearance_m, kError.off_path_m);
  EXPECT_LE(result.plan->goal_distance_m,
            s.environment.goal.position_tolerance_m - kError.end_position_m);
  EXPECT_EQ(result.plan->valves_hash, s.network.valves->hash());
  EXPECT_THAT(result.warnings, IsEmpty());
}

TEST(PlanWithModel, KeepsWhatIsAskedForInstead) {
  const Trained s;
  PlanSettings settings;
  settings.room.margin_m = 0.003;
  settings.within = std::vector<PressureLimits>(3, PressureLimits(90.0));
  settings.planner = "default,improved_plans=0";
  const PlanResult result = s.plan(settings);
  ASSERT_TRUE(result.plan) << result.reason;
  EXPECT_EQ(result.plan->margin_m, 0.003);
  EXPECT_EQ(result.plan->limits, settings.within);
  EXPECT_EQ(result.plan->planner, settings.planner);
}

TEST(PlanWithModel, NamesTheFileThatTheModelIsIn) {
  const TemporaryFolder folder;
  const Trained s;
  const auto file = folder.path() / "model.safetensors";
  write_model(file, s.network);
  PlanResult result = plan(s.arm, file, s.environment, s.limits, 3);
  PlanResult in_memory = s.plan();
  ASSERT_TRUE(result.plan && in_memory.plan);
  EXPECT_EQ(result.plan->model_hash, content_hash(read_file(file)));
  EXPECT_THAT(in_memory.plan->model_hash, IsEmpty());
  in_memory.plan->model_hash = result.plan->model_hash;
  EXPECT_EQ(bytes_of(*result.plan, folder), bytes_of(*in_memory.plan, folder));
}

TEST(PlanWithModel, SaysWhatNobodyMeasured) {
  Trained s;
  s.network.prediction_error.reset();
  s.network.valves.reset();
  EXPECT_THAT(s.plan().warnings,
              ElementsAre(HasSubstr("no valve model"), HasSubstr("error was not measured")));
  const ForwardModel no_load(s.arm);
  EXPECT_THAT(plan(s.arm, MotionModel(no_load), s.environment, s.limits, 3).warnings,
              Contains(HasSubstr("the no-load model's error is not known")));
}

TEST(PlanWithModel, WithoutASolutionThereIsNoPlan) {
  Trained s;
  s.environment.goal.x_m = 3.0;
  const PlanResult result = s.plan();
  EXPECT_EQ(result.status, PlanStatus::goal_unreachable);
  EXPECT_THAT(result.reason, HasSubstr("beyond the arm's reach"));
  EXPECT_FALSE(result.plan);
}

TEST(PlanWithModel, RefusesWhatTheModelDoesNotStore) {
  const TemporaryFolder folder;
  Trained s;
  PlanSettings recorded;
  recorded.stay_recorded = true;
  EXPECT_THAT([&] { (void)s.plan(recorded); },
              ThrowsMessage<InputError>(HasSubstr("--stay-recorded: the model does not store")));
  s.network.bounds.reset();
  EXPECT_THAT([&] { (void)s.plan(); }, ThrowsMessage<InputError>(HasSubstr("the model")));
  const auto file = folder.path() / "model.safetensors";
  write_model(file, s.network);
  EXPECT_THAT([&] { (void)plan(s.arm, file, s.environment, s.limits, 3); },
              ThrowsMessage<InputError>(HasSubstr(file.string())));
}

template <class Model>
concept Plannable = requires(const ArmDescription& arm, const Model& model,
                             const Environment& environment) {
  plan(arm, model, environment);
};

// It would become a motion model behind ideal valves, whatever its network was trained with.
TEST(PlanWithModel, AForwardModelHasToSayItsValves) {
  EXPECT_FALSE(Plannable<ForwardModel>);
  EXPECT_TRUE(Plannable<MotionModel>);
}

TEST(PlannerLimits, AreTenSecondsWhereNoneIsGiven) {
  EXPECT_EQ(PlannerLimits{}.or_default().time_s, 10.0);
  EXPECT_EQ(PlannerLimits{.memory_mb = 1.0}.or_default().time_s, 10.0);
  EXPECT_EQ(PlannerLimits{.time_s = 1.0}.or_default().time_s, 1.0);
  EXPECT_FALSE(PlannerLimits{.iterations = 5}.or_default().time_s);
  EXPECT_FALSE(PlannerLimits{.queries = 5}.or_default().time_s);
}

}  // namespace
}  // namespace limber
