#include "src/lab/demo/demo_recipe.hpp"

#include <set>

#include <gtest/gtest.h>

namespace limber {
namespace {

TEST(DemoRecipe, DerivedSeedsDifferFromEachOtherAndFromTheSeed) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    seeds.insert(seed);
    for (std::uint64_t part = 0; part < 200; ++part) {
      seeds.insert(derived_seed(seed, part));
    }
  }
  EXPECT_EQ(seeds.size(), 50U * 201U);
}

}  // namespace
}  // namespace limber
