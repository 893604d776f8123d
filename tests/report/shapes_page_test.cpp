#include "limber/report/shapes_page.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "planning/random_shapes.hpp"
#include "support/space_arm.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::Not;

Episode straight_arm(const ArmDescription& arm, int frames) {
  Episode episode;
  episode.dimension = Dimension::space;
  episode.time_s = Eigen::VectorXd::LinSpaced(frames, 0.0, (frames - 1) * arm.frame_period_s());
  episode.backbone.setZero(frames, kSpacePoseSize * arm.point_count());
  for (int plate = 0; plate < arm.point_count(); ++plate) {
    episode.backbone.col(kSpacePoseSize * plate).setConstant(0.01F * float(plate));
    episode.backbone.col(kSpacePoseSize * plate + 6).setOnes();
  }
  return episode;
}

TEST(ShapesPage, HoldsAllThatItNeeds) {
  const ArmDescription arm = testing_support::space_arm();
  const Episode episode = straight_arm(arm, 30);
  const std::string page = shapes_page("Arm <1>", arm, episode, {}, "<svg id=\"still\"/>");
  EXPECT_THAT(page, HasSubstr("Arm &lt;1&gt;"));
  EXPECT_THAT(page, HasSubstr("<svg id=\"still\"/>"));
  EXPECT_THAT(page, HasSubstr("\"gravity\":[1.0,0.0,0.0]"));
  EXPECT_THAT(page, HasSubstr("ArrowLeft"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  for (const char* loaded : {"src=", "href=", "@DATA@", "@SCRIPT@", "import "}) {
    EXPECT_THAT(page, Not(HasSubstr(loaded)));
  }
}

// Places in tenths of a millimetre, each as its change: 0.01 m are 100 units, of which web/src/
// packing.ts makes 200 = 8 + 32·6, the digits "oG". Nothing moves: zeros after the first frame.
TEST(ShapesPage, PlacesArePackedAndAPredictionThatIsNoNumberShowsTheShapeBefore) {
  const ArmDescription arm = testing_support::space_arm();
  Episode episode = straight_arm(arm, 3);
  episode.tracked = {1, 0, 1};
  FrameMatrix predicted = episode.backbone;
  predicted.row(0).setConstant(std::numeric_limits<float>::quiet_NaN());  // where it starts
  predicted(2, 0) = std::numeric_limits<float>::infinity();
  predicted(1, kSpacePoseSize) += 0.0001F;
  const std::string page =
      shapes_page("a", arm, episode, {{"network", "--network", &predicted}}, "");
  const std::string still(18, 'A');
  EXPECT_THAT(page, HasSubstr("\"name\":\"recorded\",\"color\":\"--virtual_arm\",\"places\":"
                              "\"AAAoGAAwMAA4SAAgZAAofAA" +
                              still + still + "\",\"unknown\":[1]"));
  EXPECT_THAT(page, HasSubstr("\"places\":\"AAAoGAAwMAA4SAAgZAAofAAAAAC" + std::string(14, 'A') +
                              still + "\",\"unknown\":[0,2]"));
  EXPECT_THAT(page, HasSubstr("The first 0 s of 0 s"));
}

TEST(FinalShapes, TheLegendNamesTheModelsThatAreShown) {
  const ArmDescription arm = three_segment_arm();
  PlanTrial trial;
  trial.environment = "a";
  trial.model = "network";
  trial.execution.emplace();
  trial.execution->final_backbone = start_state(Environment(), arm).backbone;
  const std::string svg = final_shapes_picture(arm, {"a", Environment()}, {trial});
  EXPECT_THAT(svg, HasSubstr("network plans"));
  EXPECT_THAT(svg, Not(HasSubstr("no-load plans")));
}

}  // namespace
}  // namespace limber
