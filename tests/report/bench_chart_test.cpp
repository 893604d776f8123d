#include "limber/report/valve_plot.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <variant>

#include <gmock/gmock.h>

#include "limber/sim/virtual_arm.hpp"

namespace limber {
namespace {

// Of full strain: another machine's rounding in the simulator, and the 7 digits of the file.
constexpr double kStrainTolerance = 1e-4;

class OwnArm : public ::testing::TestWithParam<const char*> {
 protected:
  const ArmDescription arm_ = load_arm(std::filesystem::path(LIMBER_SOURCE_DIR) / "arms" /
                                       (GetParam() + std::string(".yaml")));
};

// Whoever changes the virtual arm must run `limber characterize --arm F --out F --force` on all.
TEST_P(OwnArm, HoldsThePolynomialsOfItsBenchTest) {
  const CharacterisedArm fresh = characterise(arm_, bench_test_all(arm_));
  for (std::size_t i = 0; i < arm_.segments.size(); ++i) {
    const double full = fresh.fits[i].full_strain;
    for (double p = 5.0; p <= arm_.segments[i].pressure_limit_kpa.upper_kpa; p += 5.0) {
      EXPECT_NEAR(strain_at(arm_.segments[i].strain_polynomial, p),
                  strain_at(fresh.fits[i].polynomial, p), kStrainTolerance * full)
          << "segment " << i << " at " << p << " kPa";
    }
    EXPECT_FALSE(fresh.fits[i].refitted);
    EXPECT_LT(fresh.fits[i].max_residual, 0.01);  // of full strain
  }
}

INSTANTIATE_TEST_SUITE_P(Arms, OwnArm,
                         ::testing::Values("two_segment", "three_segment", "five_segment"));

TEST(BenchChart, DrawsPointsAndCurveOfEverySegmentInPercentOfContraction) {
  CharacterisedArm result;
  result.arm.name = "sample";
  for (const double slope : {0.002, 0.001}) {
    StrainFit fit;
    fit.polynomial = {slope, 0.0, 0.0, 0.0};
    fit.pressure_limit_kpa = 80.0;
    result.fits.push_back(fit);
  }
  const Chart chart = bench_chart(result, {{{0.0, 0.0}, {50.0, -0.11}}, {{40.0, -0.04}}});
  ASSERT_EQ(chart.series().size(), 4u);
  const auto& line = std::get<LineSeries>(chart.series()[0]);
  EXPECT_DOUBLE_EQ(line.x.back(), 80.0);
  EXPECT_DOUBLE_EQ(line.y.back(), 16.0);
  const auto& points = std::get<PointSeries>(chart.series()[1]);
  EXPECT_EQ(points.x, (std::vector<double>{0.0, 50.0}));
  EXPECT_DOUBLE_EQ(points.y[1], 11.0);
  EXPECT_EQ(points.style.color, line.style.color);
}

}  // namespace
}  // namespace limber
