#include "limber/sim/mjcf.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "support/described_xml.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

// XML has no control characters, not even as references.
TEST(Mjcf, IsXmlWhateverTheArmIsCalled) {
  for (const char* name : {"plain", "a<b & \"c\" 'd' >", "\x1b[2J\x07", "tab\tline\nend",
                           "\xC2\x9B", "no UTF-8: \xff", "\uFFFE"}) {
    ArmDescription arm = sample_arm(2);
    arm.name = name;
    const CommandResult described =
        described_xml(chain_mjcf(arm, virtual_arm_parameters(arm), 1e-3));
    EXPECT_EQ(described.code, 0) << described.output;
    EXPECT_NE(described.output.find("mujoco 1"), std::string::npos);
  }
}

TEST(Mjcf, HasNoMoreGapsThanMujocoReads) {
  ArmDescription arm = sample_arm(2);
  arm.segments[0].gaps = 90;
  arm.segments[1].gaps = 5;
  EXPECT_NO_THROW(VirtualArm(arm, {}));
  arm.segments[1].gaps = 6;
  EXPECT_THAT([&] { VirtualArm(arm, {}); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("has 96 gaps")));
}

TEST(Mjcf, GapsDifferInLengthByAtMostTheirSpread) {
  constexpr double kSpread = 0.03;
  const ArmDescription arm = sample_arm(5);
  VirtualArmParameters parameters = virtual_arm_parameters(arm);
  const std::vector<ChainLink> even = chain_links(arm, parameters);
  parameters.gap_length_spread = kSpread;
  parameters.strength_seed = 7;
  const std::vector<ChainLink> links = chain_links(arm, parameters);
  ASSERT_EQ(links.size(), even.size());
  double length_m = 0.0;
  double largest = 0.0;
  for (std::size_t gap = 0; gap < links.size(); ++gap) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(links[gap].segment)];
    EXPECT_EQ(even[gap].length_m, segment.length_m / segment.gaps);
    const double deviation = links[gap].length_m / even[gap].length_m - 1.0;
    EXPECT_LE(std::abs(deviation), kSpread);
    largest = std::max(largest, std::abs(deviation));
    length_m += links[gap].length_m;
  }
  EXPECT_GT(largest, 0.5 * kSpread);
  EXPECT_NE(length_m, arm.length_m()) << "the whole arm's length is free";
  EXPECT_NEAR(length_m, arm.length_m(), kSpread * arm.length_m());
}

TEST(Mjcf, GravityKeepsItsSizeOnATiltedTable) {
  VirtualArmParameters parameters;
  EXPECT_EQ(gravity_m_per_s2(parameters), Eigen::Vector3d(0.0, 0.0, -9.81));
  parameters.table_tilt_rad = 0.1;
  parameters.table_downhill_rad = 2.0;
  const Eigen::Vector3d gravity = gravity_m_per_s2(parameters);
  EXPECT_NEAR(gravity.norm(), 9.81, 1e-12);
  EXPECT_NEAR(std::atan2(gravity.y(), gravity.x()), 2.0, 1e-12);
  EXPECT_NEAR(gravity.head<2>().norm(), 9.81 * std::sin(0.1), 1e-12);
}

}  // namespace
}  // namespace limber
