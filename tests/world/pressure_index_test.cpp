#include "limber/world/pressure_index.hpp"

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

Eigen::VectorXf random_point(int dimension, RandomStream& random, bool coarse) {
  Eigen::VectorXf p(dimension);
  for (float& value : p) {
    value = static_cast<float>(random.uniform(-1.0, 1.0));
    value = coarse ? std::round(4.0F * value) / 4.0F : value;  // many ties
  }
  return p;
}

TEST(PressureIndex, AgreesWithALookAtEveryPoint) {
  for (const int dimension : {1, 3, 5}) {
    for (const bool coarse : {false, true}) {
      RandomStream random(5, static_cast<std::uint64_t>(dimension));
      PressureIndex index(dimension);
      std::vector<Eigen::VectorXf> points;
      EXPECT_EQ(index.nearest(Eigen::VectorXf::Zero(dimension)), -1);
      for (int k = 0; k < 600; ++k) {
        points.push_back(random_point(dimension, random, coarse));
        index.add(points.back());
        const Eigen::VectorXf query = random_point(dimension, random, coarse);
        const auto radius = static_cast<float>(random.uniform(0.0, 0.6));
        int nearest = 0;
        std::vector<int> expected;
        for (int i = 0; i <= k; ++i) {
          const auto distance = [&](int j) {
            return (points[static_cast<std::size_t>(j)] - query).squaredNorm();
          };
          nearest = distance(i) < distance(nearest) ? i : nearest;
          if (distance(i) <= radius * radius) {
            expected.push_back(i);
          }
        }
        std::vector<int> found;
        index.within(query, radius, found);
        ASSERT_EQ(index.nearest(query), nearest) << dimension << ' ' << k;
        ASSERT_EQ(found, expected) << dimension << ' ' << k;
      }
      EXPECT_EQ(index.size(), 600);
    }
  }
}

TEST(PressureIndex, TakesAnyNumberOfEqualPoints) {
  PressureIndex index(2);
  for (int k = 0; k < 200; ++k) {
    index.add(Eigen::Vector2f(0.5F, 0.5F));
  }
  index.add(Eigen::Vector2f(0.0F, 0.0F));
  std::vector<int> found;
  index.within(Eigen::Vector2f(0.5F, 0.5F), 0.1F, found);
  EXPECT_EQ(found.size(), 200U);
  EXPECT_EQ(index.nearest(Eigen::Vector2f(0.1F, 0.1F)), 200);
  EXPECT_EQ(index.nearest(Eigen::Vector2f(0.6F, 0.6F)), 0) << "the first of equals";
}

}  // namespace
}  // namespace limber
