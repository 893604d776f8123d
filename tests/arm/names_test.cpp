#include "limber/arm/names.hpp"

#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

#include "arm/test_arms.hpp"
#include "limber/common/atomic_file.hpp"

namespace limber {
namespace {

TEST(Names, CountFrom0AtTheBase) {
  const ArmDescription arm = arm_of(3);  // 3, 4 and 5 gaps
  EXPECT_EQ(segment_name(0), "segment 0");
  EXPECT_EQ(plate_name(0), "plate 0");
  EXPECT_EQ(gap_name(arm, 0), "between plates 0 and 1 (segment 0)");
  EXPECT_EQ(gap_name(arm, 3), "between plates 3 and 4 (segment 1)");
  EXPECT_EQ(frame_name(0), "frame 0");
  EXPECT_EQ(waypoint_name(2), "waypoint 2");
  EXPECT_EQ(motion_name(7), "motion 7");
  EXPECT_EQ(episode_name(0), "episode 0");
  EXPECT_EQ(column_name(3), "column 3");
  EXPECT_EQ(point_name(1), "point 1");
}

// One way to count: whoever writes "segment {}" by himself may count from anywhere.
TEST(Names, EveryMessageGoesThroughThem) {
  const std::regex by_hand(R"((segment|plate|plates|obstacle|frame|waypoint|motion|episode) \{)");
  const std::filesystem::path root(LIMBER_SOURCE_DIR);
  for (const char* folder : {"src", "apps"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::filesystem::path& path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".hpp") {
        continue;
      }
      const bool may = path.filename() == "names.hpp" || path.filename() == "environment.cpp";
      EXPECT_EQ(std::regex_search(read_file(path), by_hand), may) << path;
    }
  }
}

}  // namespace
}  // namespace limber
