#include "src/planning/search/sparse_tree.hpp"

#include <map>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

constexpr StateCells kCells{0.1, 0.01, 0.1};

struct Setting {
  ArmDescription arm = three_segment_arm();
  ArmStart start = start_state(Environment{}, arm);
  ForwardModel model{arm};
  MotionModel motion{model};
  SparseTree tree{arm, motion, kCells, motion.settled_state(start.pressures_kpa, start.backbone)};
  Pressures kpa = Eigen::Vector3f(15.0F, 15.0F, 15.0F);

  /// Settled at `kpa`, with the start's backbone, its tip moved aside.
  MotionState with_tip(float y_m) const {
    Backbone b = start.backbone;
    b(b.rows() - 1, 1) = y_m;
    return motion.settled_state(kpa, b);
  }
};

TEST(SparseTree, OfLikeStatesTheCheapestStands) {
  Setting s;
  const auto dear = s.tree.add(s.with_tip(0.0F), 0, 50.0);
  ASSERT_TRUE(dear);
  EXPECT_FALSE(s.tree.add(s.with_tip(0.0F), 0, 50.0)) << "no cheaper";
  const auto cheap = s.tree.add(s.with_tip(0.0F), 0, 45.0);
  ASSERT_TRUE(cheap);
  // Whoever asks for the dear one's pressures gets the cheap one, always.
  RandomStream random(1, 1);
  for (int k = 0; k < 50; ++k) {
    EXPECT_EQ(s.tree.parent_near(s.kpa, 0.0, random), *cheap);
  }
}

// The same pressures with another tip are another state: what overshot and came back lives on
// beside what came straight.
TEST(SparseTree, StatesWithOtherTipsLiveSideBySide) {
  Setting s;
  EXPECT_TRUE(s.tree.add(s.with_tip(0.0F), 0, 45.0));
  EXPECT_TRUE(s.tree.add(s.with_tip(0.05F), 0, 90.0));
  EXPECT_EQ(s.tree.size(), 3);
}

TEST(SparseTree, StepsNoFartherThanAskedAndNeverBeyondTheLimits) {
  Setting s;
  RandomStream random(2, 1);
  for (int k = 0; k < 200; ++k) {
    const Pressures target = s.tree.box().sample(random);
    EXPECT_LE((target.array().abs() - s.tree.scales_kpa().array()).maxCoeff(), 0.0F);
    const Pressures stepped = s.tree.stepped(0, target, 0.25);
    constexpr float kRounding = 1e-5F;
    EXPECT_LE(s.tree.scaled(stepped - s.start.pressures_kpa).norm(), 0.25F + kRounding);
    // On the way to the target.
    const Eigen::Vector3f way = stepped - s.start.pressures_kpa;
    const Eigen::Vector3f whole = target - s.start.pressures_kpa;
    EXPECT_LT(way.cross(whole).norm(), kRounding * whole.squaredNorm());
  }
  EXPECT_EQ(s.tree.box().limited(Eigen::Vector3f(500.0F, -500.0F, 3.0F)),
            Pressures(Eigen::Vector3f(100.0F, -100.0F, 3.0F)));
}

TEST(SparseTree, PowersOfTwoAreDrawnAlikeUpToTheMost) {
  RandomStream random(3, 1);
  std::map<int, int> drawn;
  constexpr int kSamples = 6000;
  for (int k = 0; k < kSamples; ++k) {
    ++drawn[random_power_of_two(random, 32)];
  }
  ASSERT_EQ(drawn.size(), 6U);
  constexpr int kSpread = 150;  // five standard deviations
  for (const auto& [power, count] : drawn) {
    EXPECT_EQ(power & (power - 1), 0);
    EXPECT_NEAR(count, kSamples / 6, kSpread) << power;
  }
}

}  // namespace
}  // namespace limber
