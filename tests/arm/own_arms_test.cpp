#include <filesystem>
#include <utility>

#include <gtest/gtest.h>

#include "limber/arm/arm_description.hpp"

namespace limber {
namespace {

TEST(OwnArms, LoadAndAreWhatTheirNamesSay) {
  const std::filesystem::path folder = std::filesystem::path(LIMBER_SOURCE_DIR) / "arms";
  const std::pair<const char*, int> arms[] = {
      {"two_segment", 2},   {"three_segment", 3}, {"five_segment", 5}, {"motor_driven", 2},
      {"uneven_limits", 2}, {"hanging_3x2", 2},   {"hanging_3x3", 3},  {"upright_4x2", 2}};
  for (const auto& [name, segments] : arms) {
    const ArmDescription arm = load_arm(folder / (std::string(name) + ".yaml"));
    EXPECT_EQ(arm.name, name);
    EXPECT_EQ(arm.segment_count(), segments);
  }
  const ArmDescription paper = load_arm(folder / "three_segment.yaml");
  EXPECT_EQ(paper.point_count(), 16);
  EXPECT_NEAR(paper.length_m(), 0.705, 1e-12);
}

TEST(OwnArms, KeepTheirHashes) {
  const std::filesystem::path folder = std::filesystem::path(LIMBER_SOURCE_DIR) / "arms";
  EXPECT_EQ(load_arm(folder / "two_segment.yaml").hash(), "c8ef573571516db1a64188e9de6861e3");
  EXPECT_EQ(load_arm(folder / "three_segment.yaml").hash(), "644c82f85342553733138332bd8726b7");
  EXPECT_EQ(load_arm(folder / "five_segment.yaml").hash(), "f2be52a8b2ae90702423ec5945f50891");
  EXPECT_EQ(load_arm(folder / "motor_driven.yaml").hash(), "a94142d3d7031990145055696905b64e");
}

}  // namespace
}  // namespace limber
