#include "limber/sim/virtual_arm.hpp"

#include <gtest/gtest.h>

#include "support/exit_interrupted.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

TEST(BenchTest, StopsOnCtrlC) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(exit_interrupted([] { bench_test_all(sample_arm(1), 4); }),
              ::testing::ExitedWithCode(0), "stopped on request");
}

}  // namespace
}  // namespace limber
