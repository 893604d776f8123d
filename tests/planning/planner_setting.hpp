#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/world/straight_motion.hpp"
#include "planning/dense_oracle.hpp"
#include "planning/play_model.hpp"

namespace limber {

inline constexpr float kPlayM = 0.01F;  ///< half width of the plates' play in the setting with one
inline constexpr float kMomentum = 0.3F;  ///< share of a change that goes on, where velocity counts

/// A pillar to the left, a slanted block to the right, a goal behind the pillar.
inline Environment pillars() {
  Environment e;
  e.name = "pillars";
  e.obstacles = {Circle{0.45, 0.22, 0.025}, Rectangle{0.6, -0.1, 0.04, 0.1, 0.3},
                 Polygon{{{0.1, 0.3}, {0.2, 0.3}, {0.15, 0.4}}}};
  e.goal = {0.30, 0.40, std::nullopt, 0.02, 0.3};
  return e;
}

/// Everything one search needs, kept alive together.
struct Setting {
  ArmDescription arm = three_segment_arm();
  ForwardModel model;
  Environment environment = pillars();

  explicit Setting(bool play, float momentum = 0.0F)
      : model(play ? ForwardModel(arm, play_network(arm, kPlayM, momentum)) : ForwardModel(arm)) {}

  PlanResult plan(const std::string& planner, std::uint64_t iterations, std::uint64_t seed = 3) {
    PlannerLimits limits;
    limits.iterations = iterations;
    return make_planner(planner)->plan({arm, model, environment}, limits, seed);
  }
};

/// Every law of Planner on a plan, by means other than the planner's own.
inline void expect_lawful(const Setting& s, const Plan& plan) {
  EXPECT_NO_THROW(require_plan_of(plan, s.arm, "plan")) << "limits, rates, sizes";
  EXPECT_EQ(plan.cost_kpa, path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa));
  EXPECT_EQ(plan.hold_frame_count, 20);
  EXPECT_EQ(plan.environment_hash, environment_hash(s.environment));
  const int frames = plan.frame_count();

  Eigen::MatrixXf pressures(3, frames);
  Eigen::MatrixXf backbones(48, frames);
  for (int k = 0; k < frames; ++k) {
    pressures.col(k) = plan.frames[static_cast<std::size_t>(k)].setpoint_kpa;
  }
  const Backbone rest = start_state(s.environment, s.arm).backbone;
  backbones.col(0) = Eigen::Map<const Eigen::VectorXf>(rest.data(), 48);
  ForwardModel::Workspace workspace;
  s.model.rollout(pressures, backbones, workspace);
  for (int k = 0; k < frames; ++k) {
    EXPECT_EQ(Backbone(Eigen::Map<const Backbone>(backbones.col(k).data(), 16, 3)),
              plan.frames[static_cast<std::size_t>(k)].backbone)
        << "frame " << k;
  }

  constexpr int kSamplesPerGap = 6;
  constexpr double kRoundingM = 1e-6;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    for (const float t : {0.0F, 0.5F, 1.0F}) {
      const Backbone between =
          (1.0F - t) * plan.frames[k - 1].backbone + t * plan.frames[k].backbone;
      smallest = std::min(
          smallest, oracle::clearance(s.arm, between, s.environment.obstacles, kSamplesPerGap));
    }
  }
  EXPECT_GT(smallest, 0.0);
  EXPECT_LE(plan.clearance_m, smallest + kRoundingM);

  const Pose tip = tip_pose(plan.frames.back().backbone);
  const double distance =
      std::hypot(tip.x_m - s.environment.goal.x_m, tip.y_m - s.environment.goal.y_m);
  EXPECT_LE(distance, s.environment.goal.position_tolerance_m);
  EXPECT_NEAR(distance, plan.goal_distance_m, kRoundingM);
}

/// Whether both searches grew the same tree, edge by edge.
inline bool same_tree(const PlanResult& a, const PlanResult& b) {
  return a.tree.size() == b.tree.size() && std::equal(a.tree.begin(), a.tree.end(), b.tree.begin(),
                                                      [](const TreeEdge& x, const TreeEdge& y) {
                                                        return x.from_m == y.from_m &&
                                                               x.to_m == y.to_m;
                                                      });
}

}  // namespace limber
