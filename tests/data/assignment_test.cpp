#include "limber/data/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

constexpr double kRounding = 1e-12;

double best_of_all_orders(const Eigen::MatrixXd& gain) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(gain.rows()));
  std::iota(order.begin(), order.end(), 0);
  double best = assigned_sum(gain, order);
  while (std::next_permutation(order.begin(), order.end())) {
    best = std::max(best, assigned_sum(gain, order));
  }
  return best;
}

// The oracle tries every order.
TEST(Assignment, IsTheBestOfAllOrders) {
  RandomStream random(3, 0);
  for (int trial = 0; trial < 60; ++trial) {
    const Eigen::Index n = 1 + trial % 6;
    Eigen::MatrixXd gain(n, n);
    for (double& value : gain.reshaped()) {
      // Rounded in every other trial: equal sums must not confuse it.
      value = trial % 2 == 0 ? random.uniform(-3.0, 3.0) : std::floor(random.uniform(0.0, 3.0));
    }
    const std::vector<Eigen::Index> found = best_assignment(gain);
    std::vector<Eigen::Index> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_EQ(sorted[static_cast<std::size_t>(i)], i) << "a column is used twice";
    }
    EXPECT_NEAR(assigned_sum(gain, found), best_of_all_orders(gain), kRounding);
  }
}

TEST(Assignment, FindsAShuffledDiagonalOf64) {
  RandomStream random(4, 0);
  std::vector<Eigen::Index> shuffled(64);
  std::iota(shuffled.begin(), shuffled.end(), 0);
  for (std::size_t i = shuffled.size() - 1; i > 0; --i) {
    std::swap(shuffled[i], shuffled[random.index(static_cast<std::uint32_t>(i + 1))]);
  }
  Eigen::MatrixXd gain(64, 64);
  for (double& value : gain.reshaped()) {
    value = random.uniform(0.0, 1.0);
  }
  for (Eigen::Index i = 0; i < 64; ++i) {
    gain(i, shuffled[static_cast<std::size_t>(i)]) = 2.0;
  }
  EXPECT_EQ(best_assignment(gain), shuffled);
}

// Of two rows there is one other order; what it loses is the margin.
TEST(AssignmentMargin, IsWhatTheNextBestExchangeLoses) {
  Eigen::Matrix2d gain;
  gain << 3.0, 1.0, 0.5, 2.0;
  EXPECT_NEAR(assignment_margin(gain, {0, 1}), 3.5, kRounding);
  EXPECT_NEAR(assignment_margin(gain, {1, 0}), -3.5, kRounding);
  EXPECT_TRUE(std::isinf(assignment_margin(gain.topLeftCorner<1, 1>(), {0})));
}

}  // namespace
}  // namespace limber
