#include "limber/sim/virtual_arm.hpp"

#include <gtest/gtest.h>

#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/exit_interrupted.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

TEST(BenchTest, StopsOnCtrlC) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(exit_interrupted([] { bench_test_all(sample_arm(1), 4); }),
              ::testing::ExitedWithCode(0), "stopped on request");
}

TEST(BenchTest, IsOfAnArmWithoutWearAndLeaks) {
  const ArmDescription arm = sample_arm(1);
  VirtualArmParameters worn;
  worn.weak_side = 1;
  worn.weak_side_loss = 0.2;
  worn.leak_share = 0.1;
  ArmDescription used = arm;
  set_virtual_arm_parameters(used, worn);
  const BenchData fresh = bench_test_all(arm, 4);
  const BenchData same = bench_test_all(used, 4);
  ASSERT_EQ(same[0].size(), fresh[0].size());
  for (std::size_t k = 0; k < fresh[0].size(); ++k) {
    EXPECT_EQ(same[0][k].strain, fresh[0][k].strain);
  }
}

}  // namespace
}  // namespace limber
