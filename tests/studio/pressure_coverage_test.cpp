#include "src/studio/scene_json.hpp"

#include <gmock/gmock.h>

#include "limber/common/data_folder.hpp"

namespace limber {
namespace {

// Limits of ±100 kPa in 24 cells: cell 0 begins at -100, cell 12 at 0, and 23 ends at 100.
TEST(PressureCoverage, CountsEachFrameInTheCellOfItsPressures) {
  const ArmDescription arm = load_arm(data_folder() / "arms/three_segment.yaml");
  ASSERT_EQ(arm.segments[0].pressure_limit_kpa.lower_kpa, -100.0);
  Episode episode;
  episode.pressure_kpa = FrameMatrix(3, 3);
  episode.pressure_kpa << 0.0F, -100.0F, 100.0F,  //
      1.0F, -99.0F, 1000.0F,                      // beyond the limit: as at it
      -100.0F, 0.0F, 0.0F;
  const nlohmann::ordered_json json = coverage_to_json(arm, {episode});
  ASSERT_EQ(json["cells"], 24);
  ASSERT_EQ(json["pairs"].size(), 3U);
  EXPECT_EQ(json["pairs"][0]["segments"], (std::vector<int>{0, 1}));
  EXPECT_EQ(json["pairs"][2]["segments"], (std::vector<int>{1, 2}));
  const auto frames = [&](int pair, int column, int row) {
    return json["pairs"][std::size_t(pair)]["frames"][std::size_t(row * 24 + column)].get<int>();
  };
  EXPECT_EQ(frames(0, 12, 0), 2);
  EXPECT_EQ(frames(0, 0, 12), 1);
  EXPECT_EQ(frames(1, 12, 23), 2);
  EXPECT_EQ(frames(2, 0, 23), 2);
  EXPECT_EQ(frames(2, 12, 12), 1);
}

}  // namespace
}  // namespace limber
