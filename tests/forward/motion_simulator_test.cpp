#include "limber/forward/motion_simulator.hpp"

#include <gtest/gtest.h>

#include "planning/play_model.hpp"

namespace limber {
namespace {

constexpr float kPlayM = 0.02F;
constexpr float kFloatM = 1e-5F;

// The play network, looked at by itself: clamp(b_{t−1}, c − w, c + w).
TEST(PlayModel, FollowsItsClosedForm) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm, play_network(arm, kPlayM));
  const NoLoadModel no_load(arm);
  RandomStream random(7, 0);
  for (int trial = 0; trial < 20; ++trial) {
    const Backbone before = no_load_backbone(no_load, random_pressures(arm, random));
    const Pressures q = random_pressures(arm, random);
    const Backbone c = no_load_backbone(no_load, q);
    Backbone expected =
        before.cwiseMax((c.array() - kPlayM).matrix()).cwiseMin((c.array() + kPlayM).matrix());
    expected.col(2) = c.col(2);
    EXPECT_LT((model.checked_step(q, q, before) - expected).cwiseAbs().maxCoeff(), kFloatM);
  }
}

TEST(MotionSimulator, SameMotionFromAnotherShapeEndsInAnotherShape) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm, play_network(arm, kPlayM));
  const CollisionChecker checker(arm, {});
  MotionSimulator simulator(arm, model, checker);
  const Pressures zero = Pressures::Zero(3);
  const Pressures bent = Pressures::Constant(3, 40.0F);
  const MotionState straight = simulator.start(start_state(Environment{}, arm));
  MotionState there, back;
  ASSERT_TRUE(simulator.move(straight, bent, there));
  ASSERT_TRUE(simulator.move(there, zero, back));
  EXPECT_NEAR((back.backbone - straight.backbone).leftCols<2>().rowwise().norm()[15],
              kPlayM * std::sqrt(2.0), 0.01);
  EXPECT_EQ(simulator.queries(), 16U);
}

TEST(MotionSimulator, CheckedUncheckedRecordedAndBatchedMotionsAgreeToTheBit) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm, play_network(arm, kPlayM));
  const CollisionChecker checker(arm, {Circle{5.0, 5.0, 0.1}});
  MotionSimulator simulator(arm, model, checker);
  RandomStream random(8, 0);
  constexpr int kMotions = 17;
  const Pressures to = random_pressures(arm, random);
  std::vector<MotionState> from;
  std::vector<MotionState> ends;
  for (int j = 0; j < kMotions; ++j) {
    const Pressures q = random_pressures(arm, random);
    const Backbone b = no_load_backbone(model.no_load(), random_pressures(arm, random));
    from.push_back(simulator.start({q, b}));
    MotionState checked, unchecked;
    ASSERT_TRUE(simulator.move(from.back(), to, checked));
    simulator.move_unchecked(from.back(), to, unchecked);
    std::vector<PlanFrame> frames{{q, q, b}};
    simulator.append_motion(to, frames);
    EXPECT_TRUE(checked == unchecked);
    EXPECT_TRUE(checked == state_after(frames, simulator.model()));
    ends.push_back(checked);
  }
  MotionBatch batch(simulator);
  batch.run(from, to.replicate(1, kMotions));
  for (int j = 0; j < kMotions; ++j) {
    EXPECT_TRUE(batch.end(j) == ends[static_cast<std::size_t>(j)]);
    EXPECT_EQ(Backbone(batch.frame(j, batch.frame_count(j))), batch.end(j).backbone);
    EXPECT_TRUE(batch.is_free(j, checker));
  }
}

TEST(MotionSimulator, StopsAtTheFirstCollision) {
  const ArmDescription arm = three_segment_arm();
  const ForwardModel model(arm);
  const CollisionChecker checker(arm, {Circle{0.6, -0.2, 0.05}});
  MotionSimulator simulator(arm, model, checker);
  MotionState end;
  EXPECT_FALSE(simulator.move(simulator.start(start_state(Environment{}, arm)),
                              Pressures::Constant(3, 90.0F), end));
  EXPECT_FALSE(checker.is_free(end.backbone));
  EXPECT_LT(simulator.queries(), 18U) << "frames behind the collision are not simulated";
}

}  // namespace
}  // namespace limber
