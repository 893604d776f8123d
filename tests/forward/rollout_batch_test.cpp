#include "limber/forward/rollout_batch.hpp"

#include <map>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

struct Motion {
  Pressures from_kpa;
  Pressures to_kpa;
  Backbone from;
  int frames;
};

// Lengths of 1 to 40 frames.
std::vector<Motion> random_motions(const ForwardModel& model, int count) {
  RandomStream random(3, 0);
  std::vector<Motion> motions;
  for (int i = 0; i < count; ++i) {
    const auto pressures = [&] {
      return Pressures(Pressures::NullaryExpr(
          model.segment_count(), [&] { return static_cast<float>(random.uniform(-90.0, 90.0)); }));
    };
    Motion motion{pressures(), pressures(), Backbone(model.point_count(), 3),
                  1 + static_cast<int>(random.index(40))};
    model.no_load().backbone(pressures(), motion.from);
    motions.push_back(std::move(motion));
  }
  return motions;
}

// Frame by frame, alone.
Backbone end_of(const ForwardModel& model, const Motion& motion, int frames) {
  ForwardModel::Workspace workspace;
  Backbone backbone = motion.from;
  Pressures before = motion.from_kpa;
  for (int k = 1; k <= frames; ++k) {
    const Pressures now = k == motion.frames
                              ? motion.to_kpa
                              : Pressures(motion.from_kpa + (motion.to_kpa - motion.from_kpa) *
                                                                (float(k) / float(motion.frames)));
    model.step(before, now, backbone, backbone, workspace);
    before = now;
  }
  return backbone;
}

class RolloutBatchOfModel : public ::testing::Test {
 protected:
  ArmDescription arm_ = sample_arm(3);
  ForwardModel model_{arm_, untrained_model(arm_, BackboneLayout::gap_poses, {32, 32}, 1)};
  std::vector<Motion> motions_ = random_motions(model_, 150);

  void add(RolloutBatch& batch, int label) const {
    const Motion& motion = motions_[static_cast<std::size_t>(label)];
    batch.add(label, MotionModel(model_).settled_state(motion.from_kpa, motion.from), motion.to_kpa,
              motion.frames);
  }
};

TEST_F(RolloutBatchOfModel, MotionsAreTheSameToTheBitAsAlone) {
  RolloutBatch batch(model_);
  // Half of them later, so that motions of all ages run beside each other.
  for (int i = 0; i < 75; ++i) {
    add(batch, i);
  }
  int added = 75;
  int steps = 0;
  std::map<int, Backbone> ends;
  while (batch.size() > 0) {
    batch.step();
    ++steps;
    for (int c = batch.size() - 1; c >= 0; --c) {
      if (batch.has_ended(c)) {
        ends[batch.label(c)] = batch.now(c);
        batch.remove(c);
        if (added < 150) {
          add(batch, added++);
        }
      }
    }
  }
  ASSERT_EQ(ends.size(), 150U);
  for (const auto& [label, end] : ends) {
    const Motion& motion = motions_[static_cast<std::size_t>(label)];
    EXPECT_TRUE(end == end_of(model_, motion, motion.frames)) << "motion " << label;
  }
  EXPECT_LE(steps, 120) << "columns of ended motions were filled again";
}

TEST_F(RolloutBatchOfModel, AMotionThatGoesOnIsOneThatIsAddedWhereItEnds) {
  const Pressures next_kpa = motions_[1].to_kpa;
  RolloutBatch batch(model_);
  RolloutBatch added(model_);
  add(batch, 0);
  while (!batch.has_ended(0)) {
    batch.step();
  }
  added.add(0, batch.state(0), next_kpa, 5);
  batch.go_on(0, next_kpa, 5);
  for (int k = 1; k <= 5; ++k) {
    EXPECT_FALSE(batch.has_ended(0));
    batch.step();
    added.step();
    EXPECT_EQ(batch.frame(0), k);
    EXPECT_TRUE(batch.state(0) == added.state(0)) << "frame " << k;
  }
  EXPECT_TRUE(batch.has_ended(0));
  EXPECT_EQ(batch.state(0).setpoint_kpa(), next_kpa);
}

TEST_F(RolloutBatchOfModel, RemovedMotionLeavesTheOthersAlone) {
  RolloutBatch batch(model_);
  add(batch, 0);
  add(batch, 1);
  add(batch, 2);
  batch.step();
  batch.remove(0);
  ASSERT_EQ(batch.size(), 2);
  EXPECT_EQ(batch.label(0), 2);
  EXPECT_EQ(batch.label(1), 1);
  EXPECT_TRUE(batch.before(0) == motions_[2].from);
  EXPECT_TRUE(batch.now(0) == end_of(model_, motions_[2], 1));
  EXPECT_TRUE(batch.now(1) == end_of(model_, motions_[1], 1));
}

}  // namespace
}  // namespace limber
