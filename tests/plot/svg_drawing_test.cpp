#include "limber/plot/svg_drawing.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/described_xml.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
const WorldBox kBox{-1.0, 1.0, -0.5, 0.5};

std::string parsed(const std::string& svg) {
  const CommandResult result = described_xml(svg);
  EXPECT_EQ(result.code, 0) << result.output;
  return result.output;
}

TEST(SvgDrawing, WithEveryShapeIsWellFormed) {
  SvgDrawing drawing(kBox, 400.0, "all <shapes>");
  const std::vector<WorldPoint> points{{0.0, 0.0}, {0.2, 0.1}, {0.4, 0.3}, {0.5, 0.4}};
  drawing.axes();
  drawing.polyline(points);
  drawing.polygon(points, {.fill = "red"});
  drawing.segments(points);
  drawing.capsule_chain(points, std::vector<double>{0.05, 0.05, 0.02}, {.fill = "blue"});
  drawing.circle({0.1, 0.1}, 0.2);
  drawing.rectangle({0.1, 0.1}, 0.2, 0.1, 0.3);
  drawing.star({0.2, 0.2}, 0.1);
  drawing.arrow({0.0, 0.0}, {0.3, 0.3}, {.opacity = 0.5});
  drawing.text({0.0, 0.0}, "a & b");
  drawing.legend("the <arm>", {.fill = "blue"});
  const std::string found = parsed(drawing.svg());
  EXPECT_THAT(found, HasSubstr("text: all <shapes>"));
  EXPECT_THAT(found, HasSubstr("text: a & b"));
  EXPECT_THAT(found, HasSubstr("text: the <arm>"));
  EXPECT_THAT(found, HasSubstr("text: x [m]"));
  EXPECT_THAT(found, Not(HasSubstr("not drawn")));
}

TEST(SvgDrawing, PointsYUpAndKeepsOneScale) {
  SvgDrawing drawing(kBox, 400.0);  // 200 px a metre
  drawing.circle({-1.0, 0.5}, 0.1);
  EXPECT_THAT(drawing.svg(), HasSubstr("cx=\"0\" cy=\"0\" r=\"20\""));
  drawing.circle({0.5, -0.25}, 0.2);
  EXPECT_THAT(drawing.svg(), HasSubstr("cx=\"300\" cy=\"150\" r=\"40\""));
}

TEST(SvgDrawing, TurnsRectanglesCounterClockwise) {
  SvgDrawing drawing(kBox, 400.0);
  // A quarter turn: along is up, across is to the left.
  drawing.rectangle({0.0, 0.0}, 0.4, 0.2, std::acos(-1.0) / 2.0);
  EXPECT_THAT(drawing.svg(), HasSubstr("M220 140L220 60L180 60L180 140Z"));
}

TEST(SvgDrawing, DrawsCapsulesTwiceTheirRadiusWideAndJoinsEqualOnes) {
  SvgDrawing drawing(kBox, 400.0);
  const std::vector<WorldPoint> points{{0.0, 0.0}, {0.2, 0.0}, {0.4, 0.0}, {0.5, 0.0}};
  drawing.capsule_chain(points, std::vector<double>{0.05, 0.05, 0.02},
                        {.fill = "#0000ff", .stroke = "none"});
  EXPECT_THAT(drawing.svg(), HasSubstr("<path d=\"M200 100L240 100L280 100\" stroke-width=\"20\"/>"
                                       "<path d=\"M280 100L300 100\" stroke-width=\"8\"/>"));
}

TEST(SvgDrawing, LeavesOutAndCountsWhatIsNotFinite) {
  SvgDrawing drawing(kBox);
  const std::vector<WorldPoint> broken{{0.0, 0.0}, {kNan, 0.1}, {0.4, 0.3}, {0.5, 0.3}};
  drawing.polyline(broken);  // drawn in part
  drawing.polygon(broken);
  drawing.circle({0.0, kInfinity}, 0.1);
  drawing.circle({0.0, 0.0}, kNan);
  drawing.rectangle({0.0, 0.0}, 0.1, 0.1, kNan);
  drawing.star({0.0, 0.0}, kInfinity);
  drawing.arrow({0.0, 0.0}, {kNan, 0.0});
  drawing.text({kNan, 0.0}, "lost");
  drawing.segments(broken);
  drawing.capsule_chain(broken, std::vector<double>{0.1, 0.1, 0.1}, {});
  EXPECT_THAT(drawing.svg(), Not(HasSubstr("nan")));
  EXPECT_THAT(drawing.svg(), Not(HasSubstr("inf")));
  EXPECT_THAT(parsed(drawing.svg()), HasSubstr("text: 10 not drawn: not finite"));
}

TEST(SvgDrawing, EmptyIsAPicture) {
  SvgDrawing drawing(kBox);
  drawing.polyline({});
  drawing.polygon({});
  drawing.segments({});
  EXPECT_THAT(parsed(drawing.svg()), HasSubstr("svg 2"));
}

TEST(SvgDrawing, KeepsNumbersShortFarOutside) {
  SvgDrawing drawing(kBox);
  drawing.circle({1e300, 0.0}, 1e300);
  EXPECT_LT(drawing.svg().size(), 1000U);
}

TEST(SvgDrawing, RefusesABoxThatIsNone) {
  EXPECT_THAT(
      [] {
        SvgDrawing({1.0, 0.0, 0.0, 1.0});
      },
      ThrowsMessage<InputError>(HasSubstr("box x 1 … 0 m")));
  EXPECT_THAT(
      [] {
        SvgDrawing({0.0, kInfinity, 0.0, 1.0});
      },
      ThrowsMessage<InputError>(HasSubstr("box x 0 … inf m")));
  EXPECT_THAT([] { SvgDrawing(kBox, 0.0); }, ThrowsMessage<InputError>(HasSubstr("width 0 px")));
}

TEST(SvgDrawing, NamesBothSizesOfAChainThatDoesNotFit) {
  SvgDrawing drawing(kBox);
  const std::vector<WorldPoint> points{{0.0, 0.0}, {0.1, 0.0}};
  EXPECT_THAT([&] { drawing.capsule_chain(points, {}, {}); },
              ThrowsMessage<InputError>(HasSubstr("2 points with 0 radii")));
}

}  // namespace
}  // namespace limber
