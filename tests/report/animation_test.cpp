#include "limber/report/plan_picture.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "planning/random_shapes.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

nlohmann::json data_of(const std::string& page) {
  const std::string open = "<script id=\"data\" type=\"application/json\">";
  const std::size_t from = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

TEST(Animation, HoldsEveryFrameOfEveryArmWithItsObstaclesAndGoal) {
  const ArmDescription arm = three_segment_arm();
  const NoLoadModel model(arm);
  RandomStream random(1, 0);
  Environment environment;
  environment.obstacles = {Circle{0.4, 0.2, 0.03}, Rectangle{0.5, -0.2, 0.1, 0.2, 0.3}};
  environment.goal = {0.3, 0.4, 1.2, 0.02, 0.3};
  AnimationTrack track{"arm", "#123456", {}};
  std::vector<Pressures> setpoints;
  for (int k = 0; k < 4; ++k) {
    setpoints.push_back(random_pressures(arm, random));
    track.shapes.push_back(no_load_backbone(model, setpoints.back()));
  }
  const nlohmann::json data =
      data_of(animation_page(arm, environment, "t", {track, track}, setpoints, {setpoints[1]}));
  ASSERT_EQ(data["tracks"].size(), 2U);
  ASSERT_EQ(data["tracks"][1]["shapes"].size(), 4U);
  constexpr double kQuantizedM = 0.51e-4;
  for (std::size_t k = 0; k < 4; ++k) {
    for (int i = 0; i < 16; ++i) {
      const auto& p = data["tracks"][0]["shapes"][k][static_cast<std::size_t>(i)];
      EXPECT_NEAR(p[0].get<double>(), track.shapes[k](i, 0), kQuantizedM);
      EXPECT_NEAR(p[1].get<double>(), track.shapes[k](i, 1), kQuantizedM);
    }
  }
  EXPECT_EQ(data["radii"].size(), 15U);
  EXPECT_NEAR(data["radii"][0].get<double>(), 0.031, 1e-12);
  EXPECT_EQ(data["obstacles"][0]["radius"], 0.03);
  EXPECT_EQ(data["obstacles"][1]["points"].size(), 4U);
  EXPECT_EQ(data["goal"]["theta"], 1.2);
  EXPECT_EQ(data["setpoints_kpa"].size(), 4U);
  ASSERT_EQ(data["pressures_kpa"].size(), 1U);
  EXPECT_EQ(data["pressures_kpa"][0][2], setpoints[1][2]);
}

TEST(Animation, NamesCannotEndTheScriptAndNothingIsLoadedFromElsewhere) {
  const ArmDescription arm = three_segment_arm();
  Environment environment;
  AnimationTrack track{"</script><b>", "#123456", {start_state(environment, arm).backbone}};
  const std::string page = animation_page(arm, environment, "<i>&", {track}, {}, {});
  EXPECT_THAT(page, Not(HasSubstr("</script><b>")));
  EXPECT_THAT(page, HasSubstr("<title>&lt;i&gt;&amp;</title>"));
  EXPECT_EQ(data_of(page)["tracks"][0]["label"], "</script><b>");
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("src=")));
}

}  // namespace
}  // namespace limber
