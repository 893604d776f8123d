#include "limber/run/tip_tracker.hpp"

#include <gmock/gmock.h>

#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/track_run.hpp"
#include "support/bending_arms.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// The path is where the no-load model has the tip at set points that wander
/// slowly: it can be kept.
class TipTrackerTest : public ::testing::Test {
 protected:
  TipTrackerTest() {
    Backbone shape(arm_.point_count(), 3);
    for (int k = 0; k <= 80; ++k) {
      const double turn = 2.0 * M_PI * k / 80.0;
      Pressures setpoint_kpa(2);
      setpoint_kpa << float(40.0 + 25.0 * std::cos(turn)), float(30.0 + 25.0 * std::sin(turn));
      forward_.no_load().backbone(Eigen::Ref<const Eigen::VectorXf>(setpoint_kpa),
                                  Eigen::Ref<Backbone>(shape));
      path_.time_s.push_back(0.05 * k);
      path_.point_m.emplace_back(shape(shape.rows() - 1, 0), shape(shape.rows() - 1, 1));
    }
    path_.laps = 2;
    environment_.name = "nothing there";
  }

  ExecutionResult run(const ArmDescription& real, TipTrackerSettings settings = {},
                      FakeFaults faults = {}) {
    FakeArm driver(real, kInstant_s, faults);
    return run_on(driver, settings);
  }

  ExecutionResult run_on(ArmDriver& driver, TipTrackerSettings settings) {
    settings.queries = 1200;
    const TrackStart start = find_track_start(arm_, model_, path_, 1);
    EXPECT_LT(start.distance_m, 0.002);
    TipTracker tracker(arm_, model_, path_, start, settings, 1);
    ExecutionSettings execution;
    execution.controller = &tracker;
    Plan plan;
    plan.arm_name = arm_.name;
    plan.arm_hash = arm_.hash();
    plan.environment_hash = environment_hash(environment_);
    plan.frame_rate_hz = arm_.frame_rate_hz;
    const ArmStart rest = start_state(environment_, arm_);
    plan.waypoints_kpa = {rest.pressures_kpa};
    plan.frames = {{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
    const ExecutionResult result = execute(arm_, environment_, plan, driver, execution);
    errors_ = track_errors(path_, result.episode, tracker.path_start_frame() + result.lag_frames);
    return result;
  }

  const ArmDescription arm_ = small_arm();
  const ForwardModel forward_{arm_};
  const MotionModel model_{forward_};
  Environment environment_;
  TipPath path_;
  TrackErrors errors_;
};

TEST_F(TipTrackerTest, KeepsAPathThatItsModelKnowsToHalfAMillimetre) {
  const ExecutionResult result = run(arm_);
  EXPECT_EQ(result.status, ExecutionStatus::done) << result.message;
  ASSERT_TRUE(errors_.first_lap && errors_.later_laps);
  EXPECT_LT(errors_.first_lap->rms_m, 1e-3);
  EXPECT_LT(errors_.later_laps->rms_m, 5e-4);
}

TEST_F(TipTrackerTest, KeepsLimitsAndFrameRuleOnAPathFarOutOfReach) {
  path_.point_m.assign(path_.point_m.size(), Eigen::Vector2d(0.1, 0.35));
  const std::vector<PressureLimits> limits(2, PressureLimits(60.0));
  const ArmDescription narrow = with_limits(arm_, limits);
  const TrackStart start = find_track_start(narrow, model_, path_, 1);
  EXPECT_GT(start.distance_m, 0.02) << "and it is told so";
  path_.laps = 1;
  TipTracker tracker(narrow, model_, path_, start, {}, 1);
  FakeArm driver(arm_, kInstant_s);
  ArmEstimate estimate(arm_, tracker.estimate_with());
  estimate.observe(Pressures::Zero(2), driver.state());
  while (const auto next = tracker.step({estimate}).setpoint_kpa) {
    EXPECT_NO_THROW(require_frame_rule(arm_, 0, estimate.setpoint_kpa(), *next));
    EXPECT_LE(next->cwiseAbs().maxCoeff(), 60.0F);
    estimate.observe(*next, driver.command(*next));
  }
}

TEST_F(TipTrackerTest, IsRefusedWhereTheDriverAllowsASegmentNothing) {
  const ArmDescription held = with_limits(arm_, {PressureLimits(60.0), PressureLimits(0.0)});
  EXPECT_THAT([&] { (void)tracker_for(held, model_, path_, "path.csv", {}, 1); },
              ThrowsMessage<InputError>(HasSubstr("segment 1 has the limits ± 0 kPa in force")));
}

TEST_F(TipTrackerTest, ItsDisturbanceEstimateHelpsWithAnArmThatTheModelDoesNotKnow) {
  TipTrackerSettings without;
  without.missed_share = 0.0;
  (void)run(bending(arm_, 0.85), without);
  const double before_m = errors_.later_laps->rms_m;
  (void)run(bending(arm_, 0.85));
  EXPECT_LT(errors_.later_laps->rms_m, 0.5 * before_m);
}

/// Answers at once, as hardware does: its state is the end of the frame before, and says so.
class LateArm final : public ArmDriver {
 public:
  explicit LateArm(const ArmDescription& arm) : inner_(arm, kInstant_s), state_(inner_.state()) {
    state_.setpoint_kpa = state_.pressure_kpa;
  }
  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    state_ = shown_.value_or(state_);
    shown_ = inner_.command(setpoint_kpa);
    shown_->setpoint_kpa = setpoint_kpa;
    return state_;
  }
  void vent() noexcept override {}

 private:
  FakeArm inner_;
  ArmState state_;
  std::optional<ArmState> shown_;  // a frame later
};

TEST_F(TipTrackerTest, ADriverThatAnswersAtOnceIsTrackedAsWell) {
  (void)run(bending(arm_, 0.85));
  const double at_its_frame_m = errors_.later_laps->rms_m;
  LateArm late(bending(arm_, 0.85));
  (void)run_on(late, {});
  EXPECT_LT(errors_.later_laps->rms_m, 1.1 * at_its_frame_m + 1e-4);
}

TEST_F(TipTrackerTest, LapsTeach) {
  TipTrackerSettings without;
  without.missed_share = 0.0;
  without.lap_share = 0.0;
  (void)run(bending(arm_, 0.85), without);
  const double before_m = errors_.later_laps->rms_m;
  TipTrackerSettings with = without;
  with.lap_share = 0.5;
  (void)run(bending(arm_, 0.85), with);
  EXPECT_LT(errors_.later_laps->rms_m, 0.7 * before_m);
}

TEST_F(TipTrackerTest, SeedsRepeatToTheBit) {
  const ExecutionResult a = run(bending(arm_, 0.85));
  const ExecutionResult b = run(bending(arm_, 0.85));
  EXPECT_EQ(a.episode.setpoint_kpa, b.episode.setpoint_kpa);
  EXPECT_EQ(a.episode.backbone, b.episode.backbone);
}

TEST_F(TipTrackerTest, BridgesLostFramesByPrediction) {
  FakeFaults every_third;
  every_third.drop_every = 3;
  const ExecutionResult result = run(arm_, {}, every_third);
  EXPECT_EQ(result.status, ExecutionStatus::done) << result.message;
  EXPECT_LT(errors_.later_laps->rms_m, 1e-3);
}

TEST_F(TipTrackerTest, StopsWithAMessageWhereNothingTracksTheArm) {
  FakeFaults blind;
  blind.drop_every = 1;
  const ExecutionResult result = run(arm_, {}, blind);
  EXPECT_EQ(result.status, ExecutionStatus::stopped);
  EXPECT_THAT(result.message, HasSubstr("its shape has to be measured"));
  EXPECT_EQ(result.frames, 0) << "before it moved";
}

TEST_F(TipTrackerTest, StopsWhereTrackingIsLostForLong) {
  const TrackStart start = find_track_start(arm_, model_, path_, 1);
  TipTracker tracker(arm_, model_, path_, start, {}, 1);
  FakeArm driver(arm_, kInstant_s);
  ArmEstimate estimate(arm_, tracker.estimate_with());
  ArmState state = driver.state();
  estimate.observe(Pressures::Zero(2), state);
  Decision decision = tracker.step({estimate});
  ASSERT_TRUE(decision.setpoint_kpa);
  state.backbone.reset();
  int frames = -1;
  while (decision.setpoint_kpa) {
    estimate.observe(*decision.setpoint_kpa, state);
    decision = tracker.step({estimate});
    ++frames;
  }
  EXPECT_EQ(frames, arm_.frames_in(0.5));
  EXPECT_THAT(decision.reason, HasSubstr("nothing has tracked the arm for 0.55 s"));
}

}  // namespace
}  // namespace limber
