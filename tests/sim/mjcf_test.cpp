#include "limber/sim/mjcf.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace limber
