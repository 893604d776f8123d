// What the closed loop sends, on runs in which it once struck what the open loop passes.
#include "src/run/closed_loop/certified_frame.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/run/closed_loop.hpp"
#include "src/run/estimate/arm_estimate.hpp"

namespace limber {
namespace {

const std::string kStruckRuns = LIMBER_TEST_DATA_DIR "/closed_loop/";

/// Passes everything on to a closed loop, and simulates what becomes of an arm that is sent what it
/// says: by the forward model alone, from where the arm was measured.
class Replayed final : public PlanSource {
 public:
  Replayed(const ArmDescription& arm, const MotionModel& model, const Environment& environment,
           PlanSource& loop)
      : arm_(arm),
        model_(model),
        checker_(arm, environment.obstacles),
        loop_(loop),
        estimate_(model, 10) {}

  void observe(const Pressures& setpoint_kpa, const ArmState& state) override {
    estimate_.observe(setpoint_kpa, state);
    loop_.observe(setpoint_kpa, state);
  }
  FrameSetpoint setpoint(const Plan& plan, std::size_t frame, std::size_t next) override {
    const FrameSetpoint sent = loop_.setpoint(plan, frame, next);
    if (sent.is_certified) {
      ++checked;
      const double clearance_m =
          std::max(clearance_along({}, sent.kpa), clearance_along(rest_of(plan, sent), sent.kpa));
      least_clearance_m = std::min(least_clearance_m, clearance_m);
    }
    return sent;
  }
  bool may_hold() override { return loop_.may_hold(); }
  std::function<MotionAdvice()> advise(const Plan& plan, std::size_t next) override {
    return loop_.advise(plan, next);
  }
  bool may_go_on(const Plan& plan, std::size_t frame, const ArmState& state) override {
    return loop_.may_go_on(plan, frame, state);
  }
  std::optional<Plan> next(const Plan& plan, std::size_t frame, const ArmState& state) override {
    return loop_.next(plan, frame, state);
  }

  int checked = 0;
  double least_clearance_m = 1.0;

 private:
  std::vector<Pressures> rest_of(const Plan& plan, const FrameSetpoint& sent) const {
    std::vector<Pressures> rest;
    const Pressures off_kpa = sent.kpa - plan.frames[sent.frame].setpoint_kpa;
    Pressures before_kpa = sent.kpa;
    for (std::size_t k = sent.frame + 1; k < plan.frames.size(); ++k) {
      const Pressures wanted_kpa = plan.frames[k].setpoint_kpa + off_kpa;
      before_kpa = within_frame_rule(arm_, before_kpa, wanted_kpa.cast<double>());
      rest.push_back(before_kpa);
    }
    return rest;
  }
  /// Smallest on the way: what is sent, others after it, and then a second's rest.
  double clearance_along(std::vector<Pressures> kpa, const Pressures& first_kpa) const {
    kpa.insert(kpa.begin(), first_kpa);
    kpa.insert(kpa.end(), 20, kpa.back());
    MotionState state = estimate_.state();
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
  PlanSource& loop_;
  ArmEstimate estimate_;
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
  settings.replanner = &replayed;
  VirtualArm driver(arm);
  const ExecutionResult result = execute(arm, environment, plan, driver, settings);
  EXPECT_FALSE(result.collided);
  EXPECT_TRUE(result.goal_reached);
  EXPECT_GT(replayed.checked, 20);
  EXPECT_GT(replayed.least_clearance_m, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Environments, CertifiedFrameTest,
                         ::testing::Values(std::pair("arm_019", 1), std::pair("hard_051", 3)));

}  // namespace
}  // namespace limber
