// What the closed loop sends, on runs in which it once struck what the open loop passes.
#include "src/run/closed_loop/certified_frame.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/run/arm_estimate.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {
namespace {

const std::string kStruckRuns = LIMBER_TEST_DATA_DIR "/closed_loop/";

/// Passes everything on to a closed loop, and simulates what becomes of an arm that is sent what it
/// says: by the forward model alone, from where the arm is.
class Replayed final : public Controller {
 public:
  Replayed(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
           Controller& loop)
      : arm_(arm), model_(model), checker_(arm, environment.obstacles), loop_(loop) {}

  EstimateModel estimate_with() const override { return loop_.estimate_with(); }
  void begin(const RunStart& start) override { loop_.begin(start); }
  Decision step(const Moment& now) override {
    Decision decision = loop_.step(now);
    if (decision.setpoint_kpa && decision.is_certified) {
      ++checked;
      const Pressures& sent_kpa = *decision.setpoint_kpa;
      const MotionState& from = now.arm.state();
      const double clearance_m = std::max(
          clearance_along(from, {}, sent_kpa),
          decision.plan == nullptr ? -1.0 : clearance_along(from, rest_of(decision), sent_kpa));
      least_clearance_m = std::min(least_clearance_m, clearance_m);
    }
    return decision;
  }

  int checked = 0;
  double least_clearance_m = 1.0;

 private:
  std::vector<Pressures> rest_of(const Decision& sent) const {
    const Plan& plan = *sent.plan;
    std::vector<Pressures> rest;
    const std::size_t frame = std::min(sent.frame, plan.frames.size() - 1);
    const Pressures off_kpa = *sent.setpoint_kpa - plan.frames[frame].setpoint_kpa;
    Pressures before_kpa = *sent.setpoint_kpa;
    for (std::size_t k = frame + 1; k < plan.frames.size(); ++k) {
      const Pressures wanted_kpa = plan.frames[k].setpoint_kpa + off_kpa;
      before_kpa = within_frame_rule(arm_, before_kpa, wanted_kpa.cast<double>());
      rest.push_back(before_kpa);
    }
    return rest;
  }
  /// Smallest on the way: what is sent, others after it, and then a second's rest.
  double clearance_along(MotionState state, std::vector<Pressures> kpa,
                         const Pressures& first_kpa) const {
    kpa.insert(kpa.begin(), first_kpa);
    kpa.insert(kpa.end(), 20, kpa.back());
    MotionModel::Workspace workspace;
    double smallest_m = 1.0;
    for (const Pressures& one_kpa : kpa) {
      model_.step(one_kpa, state, workspace);
      smallest_m = std::min(smallest_m, checker_.clearance(state.backbone).value_m);
    }
    return smallest_m;
  }

  const ArmDescription& arm_;
  const MotionModel& model_;
  CollisionChecker checker_;
  Controller& loop_;
};

class CertifiedFrameTest : public ::testing::TestWithParam<std::pair<const char*, int>> {};

TEST_P(CertifiedFrameTest, WhatIsSentComesToRestFreeAsTheModelHasIt) {
  const std::string name = kStruckRuns + GetParam().first;
  const ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
  const CompensationModel network = read_model(kStruckRuns + "ten_hours.safetensors");
  const ForwardModel forward(arm, network);
  const MotionModel model(forward, ValveModel(arm, network.valves.value()));
  const Environment environment = load_environment(name + ".yaml", arm);
  const Plan plan = read_plan(name + ".plan.json");
  ClosedLoop loop(arm, model, environment, error_room(forward), ClosedLoopSettings{},
                  static_cast<std::uint64_t>(GetParam().second));
  Replayed replayed(arm, model, environment, loop);
  ExecutionSettings settings;
  settings.controller = &replayed;
  VirtualArm driver(arm);
  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  EXPECT_FALSE(result.collided);
  EXPECT_TRUE(result.goal_reached);
  EXPECT_GT(replayed.checked, 20);
  EXPECT_GT(replayed.least_clearance_m, 0.0);
}

/// Something stands where the arm in mid-motion would come to rest.
TEST(CertifiedFrame, WhereStandingStrikesAnArmGoesBackAlongItsPlan) {
  const std::string name = kStruckRuns + "arm_019";
  const ArmDescription arm = load_arm(LIMBER_SOURCE_DIR "/arms/three_segment.yaml");
  const CompensationModel network = read_model(kStruckRuns + "ten_hours.safetensors");
  const ForwardModel forward(arm, network);
  const MotionModel model(forward, ValveModel(arm, network.valves.value()));
  Environment environment = load_environment(name + ".yaml", arm);
  const Plan plan = read_plan(name + ".plan.json");
  constexpr std::size_t kMoving = 12;
  const PlanFrame& start = plan.frames.front();
  MotionState now = model.settled_state(start.pressure_kpa, start.backbone);
  MotionModel::Workspace workspace;
  for (std::size_t k = 1; k <= kMoving; ++k) {
    model.step(plan.frames[k].setpoint_kpa, now, workspace);
  }
  const Pressures sent_kpa = now.setpoint_kpa();
  MotionState held = now;
  for (int k = 0; k < 40; ++k) {
    model.step(sent_kpa, held, workspace);
  }
  const auto tip_of = [](const MotionState& state) {
    return tip_position_m(state.backbone).cast<double>().eval();
  };
  const Eigen::Vector2d ahead = tip_of(held) - tip_of(now);
  ASSERT_GT(ahead.norm(), 0.02) << "it moves";
  constexpr double kRadiusM = 0.01;
  constexpr double kStruckM = 0.002;
  const double tip_radius_m = CollisionChecker(arm, {}).radius_m(arm.point_count() - 2);
  const double reach_m = kRadiusM + tip_radius_m - kStruckM;
  const Eigen::Vector2d centre = tip_of(held) + reach_m * ahead.normalized();
  environment.obstacles = {Circle{centre.x(), centre.y(), kRadiusM}};

  CertifiedFrame gate(arm, model, environment, 0.0, {});
  ASSERT_FALSE(gate.may_stop(now));
  const CertifiedFrame::Sent sent =
      gate.next(now, {plan, kMoving, sent_kpa}, {{sent_kpa, kMoving}});
  EXPECT_TRUE(sent.is_certified);
  EXPECT_FALSE(sent.frame.has_value());
  EXPECT_GT((sent.kpa - sent_kpa).cwiseAbs().maxCoeff(), 1.0F);
  model.step(sent.kpa, now, workspace);
  EXPECT_TRUE(gate.may_stop(now) ||
              gate.next(now, {plan, kMoving, sent.kpa}, {{sent.kpa, kMoving}}).is_certified);
}

INSTANTIATE_TEST_SUITE_P(Environments, CertifiedFrameTest,
                         ::testing::Values(std::pair("arm_019", 1), std::pair("hard_051", 3)));

}  // namespace
}  // namespace limber
