#include "limber/planning/forest.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

TipGrid grid_of(const Eigen::Matrix3Xf& tips) {
  return {tips, std::vector<float>(static_cast<std::size_t>(tips.cols()), 0.0F)};
}

std::vector<int> near(const TipGrid& grid, const Eigen::Vector2f& place, float radius) {
  std::vector<int> nodes;
  grid.visit_near(place, radius, [&](const TipGrid::Tip& tip) { nodes.push_back(tip.node); });
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::vector<int> near_by_looking_at_all(const Eigen::Matrix3Xf& tips, const Eigen::Vector2f& place,
                                        float radius) {
  std::vector<int> nodes;
  for (int i = 0; i < tips.cols(); ++i) {
    if ((tips.col(i).head<2>() - place).squaredNorm() <= radius * radius) {
      nodes.push_back(i);
    }
  }
  return nodes;
}

TEST(TipGrid, FindsWhatLookingAtAllFinds) {
  RandomStream random(7, 1);
  constexpr int kTips = 2000;
  Eigen::Matrix3Xf tips(3, kTips);
  for (int i = 0; i < kTips; ++i) {
    tips.col(i) << float(random.uniform(-0.2, 0.7)), float(random.uniform(-0.6, 0.6)), 0.0F;
  }
  const TipGrid grid = grid_of(tips);
  std::size_t found = 0;
  for (int k = 0; k < 500; ++k) {
    // Places beyond all tips too, and radii from none to everything.
    const Eigen::Vector2f place(float(random.uniform(-1.0, 1.5)), float(random.uniform(-1.0, 1.0)));
    const float radius = k % 5 == 0 ? 3.0F : float(random.uniform(0.0, 0.3));
    const std::vector<int> expected = near_by_looking_at_all(tips, place, radius);
    EXPECT_EQ(near(grid, place, radius), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 100U * kTips);
}

TEST(TipGrid, TellsPoseCostAndNode) {
  Eigen::Matrix3Xf tips(3, 2);
  tips.col(0) << 0.1F, 0.2F, 0.3F;
  tips.col(1) << 0.5F, 0.6F, 0.7F;
  int visits = 0;
  TipGrid(tips, {8.0F, 9.0F}).visit_near({0.5F, 0.6F}, 0.01F, [&](const TipGrid::Tip& tip) {
    ++visits;
    EXPECT_EQ(tip.node, 1);
    EXPECT_EQ(tip.theta_rad, 0.7F);
    EXPECT_EQ(tip.cost_kpa, 9.0F);
  });
  EXPECT_EQ(visits, 1);
}

TEST(TipGrid, OfTipsAtOnePlaceOrOfNone) {
  EXPECT_EQ(near(grid_of(Eigen::Matrix3Xf::Zero(3, 5)), {0.0F, 0.0F}, 0.0F).size(), 5U);
  EXPECT_TRUE(near(grid_of(Eigen::Matrix3Xf(3, 0)), {0.0F, 0.0F}, 1.0F).empty());
  EXPECT_TRUE(near(TipGrid(), {0.0F, 0.0F}, 1.0F).empty());
}

TEST(TipGrid, OfPlacesThatAreNoNumbersStaysWithinItsCells) {
  constexpr float kHuge = 3e38F;
  Eigen::Matrix3Xf tips = Eigen::Matrix3Xf::Zero(3, 3);
  tips.col(1).setConstant(kHuge);
  tips.col(2).setConstant(-kHuge);
  const TipGrid grid = grid_of(tips);
  EXPECT_EQ(near(grid, {0.0F, 0.0F}, 1.0F), std::vector<int>{0});
  EXPECT_TRUE(near(grid, {std::numeric_limits<float>::quiet_NaN(), 0.0F}, 1.0F).empty());
}

}  // namespace
}  // namespace limber
