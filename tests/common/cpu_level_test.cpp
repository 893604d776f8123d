#include "limber/common/cpu_level.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

TEST(CpuLevel, IsTheHighestAvailableUnlessForced) {
  const std::vector<CpuLevel> levels = available_cpu_levels();
  EXPECT_EQ(cpu_level_for(""), levels.back());
  for (const CpuLevel level : levels) {
    EXPECT_EQ(cpu_level_for(to_string(level)), level);
  }
  EXPECT_EQ(levels.front(), CpuLevel::baseline);
}

TEST(CpuLevel, NamesWhatThisCpuRunsWhenForcedToSomethingElse) {
  EXPECT_THAT([] { cpu_level_for("sse9"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr(
                  "LIMBER_CPU=sse9; expected one of what this CPU runs: baseline")));
}

}  // namespace
}  // namespace limber
