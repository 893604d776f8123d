#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Tube awkward_tube(int plates) {
  Tube tube;
  for (int i = 0; i < plates; ++i) {
    tube.plate_scale_m.push_back(1e-4 + i / 700.0);
  }
  tube.end_scale_m = 0.1 / 7.0;
  tube.end_heading_scale_rad = 2.0 / 3.0;
  tube.growth = {1.0 / 3.0, 0.1 / 3.0};
  tube.source = "virtual arm";
  tube.levels = {{0.9, 1.0 / 0.7, 4000, 371, 0.95, 4000, 380}, {0.95, 1.9, 4000, 170, 0.95, 0, 0}};
  return tube;
}

TEST(TubeText, SurvivesTheRoundTripExactly) {
  const Tube tube = awkward_tube(16);
  EXPECT_EQ(read_tube(YamlReader::from_text(tube_to_metadata(tube), "m")), tube);
}

TEST(TubeText, IsKeptByModelFilesAndAbsentFromOthers) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(3), BackboneLayout::gap_poses, {7}, 1);
  write_model(path, model);
  EXPECT_FALSE(read_model(path).tube);
  model.tube = awkward_tube(16);
  write_model(path, model);
  EXPECT_EQ(read_model(path).tube, model.tube);
  EXPECT_EQ(read_model(path).member(0).tube, model.tube);
  model.tube->plate_scale_m.pop_back();
  EXPECT_THAT([&] { write_model(path, model); },
              ThrowsMessage<InputError>(HasSubstr("plate_scale_m has 15 numbers; expected 16")));
}

TEST(Tube, GrowsFromItsShareAtTheStartToItsFullWidth) {
  Tube tube = awkward_tube(2);
  tube.growth = {0.4, 0.1};
  const double full_m = 1.9 * tube.plate_scale_m[1];
  EXPECT_DOUBLE_EQ(tube.radius_m(tube.levels[1], 1, 0.0), 0.4 * full_m);
  EXPECT_DOUBLE_EQ(tube.radius_m(tube.levels[1], 1, 0.05), 0.7 * full_m);
  EXPECT_DOUBLE_EQ(tube.radius_m(tube.levels[1], 1, 0.1), full_m);
  EXPECT_DOUBLE_EQ(tube.radius_m(tube.levels[1], 1, 7.0), full_m);
}

TEST(Tube, HasADefaultLevelOfNinetyFivePercentOrWhatIsBelow) {
  Tube tube = awkward_tube(2);
  EXPECT_EQ(tube.default_level().level, 0.95);
  tube.levels.push_back({0.99, 3.0, 0, 0, 0.95, 0, 0});
  EXPECT_EQ(tube.default_level().level, 0.95);
  tube.levels.erase(tube.levels.begin() + 1);
  EXPECT_EQ(tube.default_level().level, 0.9);
  tube.levels.erase(tube.levels.begin());
  EXPECT_EQ(tube.default_level().level, 0.99);
  EXPECT_EQ(tube.find(0.95), nullptr);
  EXPECT_EQ(tube.find(0.99), &tube.levels.front());
}

TEST(Tube, EveryNumberOutOfRangeIsNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const struct {
    const char* message;
    std::function<void(Tube&)> change;
  } cases[] = {
      {"tube.plate_scale_m is empty", [](Tube& t) { t.plate_scale_m.clear(); }},
      {"tube.levels is empty", [](Tube& t) { t.levels.clear(); }},
      {"tube.plate_scale_m[1] is 0", [](Tube& t) { t.plate_scale_m[1] = 0.0; }},
      {"tube.end_scale_m is nan", [](Tube& t) { t.end_scale_m = kNan; }},
      {"tube.end_heading_scale_rad is -1", [](Tube& t) { t.end_heading_scale_rad = -1.0; }},
      {"tube.start_share is 0", [](Tube& t) { t.growth.start_share = 0.0; }},
      {"tube.start_share is 1.1", [](Tube& t) { t.growth.start_share = 1.1; }},
      {"tube.full_after_m is nan", [](Tube& t) { t.growth.full_after_m = kNan; }},
      {"tube.full_after_m is -1", [](Tube& t) { t.growth.full_after_m = -1.0; }},
      {"tube.levels[0].level is 1", [](Tube& t) { t.levels[0].level = 1.0; }},
      {"tube.levels[1].level is 0.5, after 0.9", [](Tube& t) { t.levels[1].level = 0.5; }},
      {"tube.levels[0].factor is 0", [](Tube& t) { t.levels[0].factor = 0.0; }},
      {"tube.levels[0].confidence is 0", [](Tube& t) { t.levels[0].confidence = 0.0; }},
      {"tube.levels[0]: 5000 of 4000 runs", [](Tube& t) { t.levels[0].outside = 5000; }},
      {"tube.levels[1].audit: 1 of 0 runs", [](Tube& t) { t.levels[1].audit_outside = 1; }},
  };
  for (const auto& one : cases) {
    Tube tube = awkward_tube(3);
    one.change(tube);
    EXPECT_THAT([&] { validate(tube, "file"); },
                ThrowsMessage<InputError>(HasSubstr(std::string("file: ") + one.message)));
  }
}

}  // namespace
}  // namespace limber
