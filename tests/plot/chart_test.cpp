#include "limber/plot/chart.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/described_xml.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string parsed(const std::string& svg) {
  const CommandResult result = described_xml(svg);
  EXPECT_EQ(result.code, 0) << result.output;
  return result.output;
}

void expect_only_finite_numbers(const std::string& svg) {
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(Chart, WithEveryKindOfSeriesIsWellFormed) {
  const std::vector<double> x{0.0, 1.0, 2.0};
  Chart lines("lines & <bands>");
  lines.x_axis("time [s]").y_axis("error [cm]").note("a note");
  lines.line("l", x, {1.0, 2.0, 3.0}).points("p", x, x).band("b", x, x, {1.0, 2.0, 3.0});
  lines.mean_band("m", x, x, {0.1, 0.1, 0.1}).horizontal_line("h", 2.5).vertical_line("v", 1.5);
  Chart bars("bars");
  bars.bars({"a", "b"}, "first", {1.0, 2.0}).bars({"a", "b"}, "second", {3.0, -4.0}, {1.0, 0.5});
  Chart spread("spread");
  spread.distribution("left", {1.0, 2.0, 2.5, 9.0}).distribution("right", {4.0});
  Chart counts("counts");
  counts.histogram("one", x).histogram("two", {5.0});
  ChartGrid grid(2, "all");
  grid.add(lines).add(bars).add(spread).add(counts);
  const std::string found = parsed(grid.svg());
  for (const char* text : {"text: lines & <bands>", "text: time [s]", "text: error [cm]",
                           "text: a note", "text: second", "text: right", "text: two"}) {
    EXPECT_THAT(found, HasSubstr(text));
  }
  expect_only_finite_numbers(grid.svg());
  for (const Chart* chart : {&lines, &bars, &spread, &counts}) {
    parsed(chart->svg());
  }
}

TEST(Chart, WithoutDataSaysSo) {
  EXPECT_THAT(parsed(Chart("empty").svg()), HasSubstr("text: no data"));
  EXPECT_THAT(parsed(Chart("empty").line("l", {}, {}).svg()), HasSubstr("text: no data"));
  EXPECT_THAT(parsed(Chart("empty").logarithmic_y().svg()), HasSubstr("text: no data"));
  EXPECT_THAT(parsed(Chart("empty").histogram("h", {}).svg()), HasSubstr("text: no data"));
  EXPECT_THAT(parsed(Chart("empty").distribution("d", {}).svg()), HasSubstr("text: no data"));
  parsed(ChartGrid(3).svg());
}

TEST(Chart, LeavesOutAndCountsWhatIsNotFinite) {
  Chart chart("gaps");
  chart.line("l", {0.0, 1.0, 2.0, 3.0, kNan}, {1.0, kNan, kInfinity, 2.0, 1.0});
  chart.points("p", {1.0}, {-kInfinity}).histogram("h", {kNan, 1.0});
  chart.horizontal_line("r", kNan);
  expect_only_finite_numbers(chart.svg());
  EXPECT_THAT(parsed(chart.svg()), HasSubstr("text: 6 values not drawn: not finite"));
}

TEST(Chart, BreaksALineWhereValuesAreMissing) {
  Chart chart("gap");
  chart.line("l", {0.0, 1.0, 2.0, 3.0, 4.0}, {1.0, 1.0, kNan, 1.0, 1.0}, {.color = "#123456"});
  const std::string svg = chart.svg();
  const std::size_t end = svg.find("\" fill=\"none\" stroke=\"#123456\"");
  ASSERT_NE(end, std::string::npos);
  const std::string data = svg.substr(svg.rfind("d=\"", end), end - svg.rfind("d=\"", end));
  EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2) << data;
}

TEST(Chart, OnALogarithmicAxisLeavesOutWhatIsNotPositive) {
  Chart chart("log");
  chart.logarithmic_y().line("l", {0.0, 1.0, 2.0, 3.0}, {1.0, 0.0, -3.0, 100.0});
  EXPECT_THAT(parsed(chart.svg()), HasSubstr("2 values not drawn: not finite or not positive"));
  EXPECT_THAT(parsed(chart.svg()), HasSubstr("text: 100"));
}

TEST(Chart, DrawsValuesNearTheEndsOfDoubles) {
  Chart chart("huge");
  chart.line("l", {-1e149, 1e149}, {-1e149, 1e149}).points("overflow", {0.0}, {1e308});
  EXPECT_THAT(parsed(chart.svg()), HasSubstr("text: 1 value not drawn: not finite"));
  expect_only_finite_numbers(chart.svg());
  Chart tiny("tiny");
  tiny.line("l", {0.0, 5e-324}, {0.0, 1e-300});
  expect_only_finite_numbers(tiny.svg());
}

TEST(Chart, OfALongSeriesStaysSmall) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 1000000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(i * 0.7) * i);
  }
  EXPECT_LT(Chart("long").line("l", x, y).svg().size(), 60000U);
}

TEST(Chart, IsTheSameForTheSameData) {
  Chart chart("same");
  chart.distribution("d", {1.0, 2.0, 4.0});
  EXPECT_EQ(chart.svg(), chart.svg());
}

TEST(Chart, WithEqualAspectScalesBothAxesAlike) {
  Chart chart("square");
  chart.equal_aspect().x_range(0.0, 1.0).y_range(0.0, 1.0).line("", {0.0, 1.0}, {0.0, 1.0},
                                                                {.color = "#abcdef"});
  const std::string svg = chart.svg();
  const std::size_t end = svg.find("\" fill=\"none\" stroke=\"#abcdef\"");
  ASSERT_NE(end, std::string::npos);
  double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
  ASSERT_EQ(
      std::sscanf(svg.c_str() + svg.rfind("d=\"", end), "d=\"M%lf %lfL%lf %lf", &x1, &y1, &x2, &y2),
      4);
  constexpr double kRoundingPx = 0.021;  // two coordinates, each rounded to 0.01 px
  EXPECT_NEAR(x2 - x1, y1 - y2, kRoundingPx);
}

TEST(Chart, NamesBothSizesWhereSeriesDoNotFit) {
  Chart chart("c");
  EXPECT_THAT(([&] {
                chart.line("l", {1.0, 2.0}, {1.0});
              }),
              ThrowsMessage<InputError>(HasSubstr("chart 'c': series 'l' has 2 x and 1 y")));
  EXPECT_THAT(([&] {
                chart.bars({"a"}, "b", {1.0, 2.0});
              }),
              ThrowsMessage<InputError>(HasSubstr("1 categories and 2 values")));
  EXPECT_THAT(([&] { chart.mean_band("m", {1.0}, {1.0}, {}); }),
              ThrowsMessage<InputError>(HasSubstr("0 deviations")));
  chart.bars({"a", "b"}, "first", {1.0, 2.0});
  EXPECT_THAT(([&] {
                chart.bars({"a", "c"}, "second", {1.0, 2.0});
              }),
              ThrowsMessage<InputError>(HasSubstr("name other categories")));
  EXPECT_THAT(([&] { chart.distribution("d", {1.0}); }),
              ThrowsMessage<InputError>(HasSubstr("in a chart of bars")));
}

TEST(Chart, RefusesRangesThatAreNone) {
  Chart chart("c");
  EXPECT_THAT(([&] { chart.x_range(1.0, 1.0); }),
              ThrowsMessage<InputError>(HasSubstr("x range 1 … 1; expected finite limits")));
  EXPECT_THAT(([&] { chart.y_range(0.0, kNan); }), ThrowsMessage<InputError>(HasSubstr("y range")));
  EXPECT_THAT(([&] { chart.size_px(10, 10); }), ThrowsMessage<InputError>(HasSubstr("10 × 10")));
  EXPECT_THAT([] { ChartGrid grid(0); }, ThrowsMessage<InputError>(HasSubstr("0 columns")));
}

TEST(Palette, StartsAgainAfterItsLastColour) {
  EXPECT_EQ(palette_color(0), palette_color(8));
  EXPECT_NE(palette_color(kNoLoadColor), palette_color(kNetworkColor));
  EXPECT_NE(palette_color(kTrueArmColor), palette_color(kNetworkColor));
}

}  // namespace
}  // namespace limber
