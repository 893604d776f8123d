#include "limber/arm/characterisation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "arm/test_arms.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/csv_reader.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "support/exit_interrupted.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

constexpr double kLimit = 100.0;  // [kPa]
constexpr double kRoundingOfFit =
    1e-4;  // of the squared residual; 7 digits and the slope held above them

std::vector<BenchPoint> bench(const std::function<double(double)>& contraction, int steps = 20,
                              double highest_kpa = kLimit) {
  std::vector<BenchPoint> points;
  for (int k = 0; k <= steps; ++k) {
    const double p = highest_kpa * k / steps;
    points.push_back({p, -contraction(p)});
  }
  return points;
}

/// Nothing below 25 kPa, nothing more above 75: a real actuator on a weak pump.
double dead_zone_and_saturation(double p) {
  return 0.2 * std::clamp((p - 25.0) / 50.0, 0.0, 1.0);
}

double sum_of_squares(const StrainPolynomial& c, const std::vector<BenchPoint>& points) {
  double sum = 0.0;
  for (const BenchPoint& point : points) {
    sum += std::pow(strain_at(c, point.pressure_kpa) + point.strain, 2);
  }
  return sum;
}

TEST(StrainFit, FindsTheQuarticThatMadeTheData) {
  const StrainPolynomial truth{1.6e-3, 3.8e-5, -5.2e-7, 1.8e-9};
  const StrainFit fit =
      fit_strain_polynomial(bench([&](double p) { return strain_at(truth, p); }), kLimit);
  EXPECT_FALSE(fit.refitted);
  EXPECT_THAT(fit.warnings, IsEmpty());
  EXPECT_EQ(fit.points, 21);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(fit.polynomial[k] / truth[k], 1.0, 1e-6);
  }
  EXPECT_NEAR(fit.full_strain, strain_at(truth, kLimit), 1e-7);
  EXPECT_LT(fit.max_residual, 1e-5);
}

// The normal equations: at the optimum, residuals are orthogonal to every power of p.
TEST(StrainFit, ResidualsAreOrthogonalToThePowersOfPressure) {
  RandomStream random(41, 0);
  const auto points = bench([&](double p) { return 0.2 * (p / 100.0) + 0.004 * random.normal(); });
  const StrainFit fit = fit_strain_polynomial(points, kLimit);
  ASSERT_FALSE(fit.refitted);
  for (int power = 1; power <= 4; ++power) {
    double product = 0.0;
    for (const BenchPoint& point : points) {
      const double residual = -point.strain - strain_at(fit.polynomial, point.pressure_kpa);
      product += residual * std::pow(point.pressure_kpa / kLimit, power);
    }
    EXPECT_NEAR(product, 0.0, 1e-6) << power;
  }
}

TEST(StrainFit, ReportsResidualsAsFractionsOfFullStrain) {
  // ±0.002 alternating about a straight line: a quartic cannot follow.
  int k = 0;
  const auto points = bench([&](double p) { return 0.002 * p + (k++ % 2 == 0 ? 0.002 : -0.002); });
  const StrainFit fit = fit_strain_polynomial(points, kLimit);
  EXPECT_NEAR(fit.rms_residual, 0.01, 0.001);
  EXPECT_GE(fit.max_residual, fit.rms_residual);
}

TEST(StrainFit, NotesALargeResidualInPercentOfFullStrain) {
  int k = 0;
  const auto points = bench([&](double p) { return 0.002 * p + (k++ % 2 == 0 ? 0.02 : -0.02); });
  const StrainFit fit = fit_strain_polynomial(points, kLimit);
  ASSERT_EQ(fit.warnings.size(), 1U);
  EXPECT_THAT(fit.warnings[0],
              HasSubstr(fmt::format("the residual is {:.1f} %", fit.rms_residual * 1e2)));
}

TEST(StrainFit, CoefficientsHaveSevenDigits) {
  RandomStream random(42, 0);
  const StrainFit fit = fit_strain_polynomial(
      bench([&](double p) { return 0.002 * p + 1e-4 * random.uniform(); }), kLimit);
  for (const double c : fit.polynomial) {
    double rounded = 0.0;
    ASSERT_TRUE(parse_number(fmt::format("{:.6e}", c), rounded));
    EXPECT_EQ(c, rounded);
  }
}

TEST(MonotoneStrainFit, HoldsTheSlopeWhereThePlainFitFalls) {
  const StrainFit fit = fit_strain_polynomial(bench(dead_zone_and_saturation), kLimit);
  EXPECT_TRUE(fit.refitted);
  EXPECT_GE(min_strain_slope(fit.polynomial, kLimit).slope_per_kpa, 0.0);
  EXPECT_GT(fit.rms_residual, 0.005);
  EXPECT_LT(fit.rms_residual, 0.10);
  ArmDescription arm = arm_of(1);
  arm.segments[0].pressure_limit_kpa = kLimit;
  arm.segments[0].strain_polynomial = fit.polynomial;
  EXPECT_NO_THROW(NoLoadModel{arm});
}

// Optimality among monotone quartics, against a slow independent search: convex, so no feasible
// neighbour in any of many directions may be better.
TEST(MonotoneStrainFit, NoMonotoneQuarticNearbyFitsBetter) {
  const std::function<double(double)> shapes[] = {
      dead_zone_and_saturation,
      [](double p) { return p < 40.0 ? 0.0 : 0.2 * (p - 40.0) / 60.0; },
      [](double p) { return 0.2 * std::min(1.0, p / 30.0); },
      [](double p) { return 0.1 + 0.1 * std::tanh((p - 50.0) / 12.0); },
      [](double p) {
        return 0.2 * std::min(1.0, p / 60.0) - 0.015 * std::max(0.0, p - 80.0) / 20.0;
      },
  };
  for (const auto& shape : shapes) {
    const std::vector<BenchPoint> points = bench(shape);
    const StrainFit fit = fit_strain_polynomial(points, kLimit);
    ASSERT_TRUE(fit.refitted);
    const double best = sum_of_squares(fit.polynomial, points);
    RandomStream random(43, 0);
    int feasible = 0;
    for (int trial = 0; trial < 200000; ++trial) {
      StrainPolynomial near = fit.polynomial;
      const double size = std::pow(10.0, random.uniform(-6.0, -1.0));
      for (int k = 0; k < 4; ++k) {
        near[std::size_t(k)] += size * random.normal() / std::pow(kLimit, k + 1);
      }
      if (min_strain_slope(near, kLimit).slope_per_kpa >= 0.0) {
        ++feasible;
        ASSERT_GT(sum_of_squares(near, points), best * (1.0 - kRoundingOfFit));
      }
    }
    EXPECT_GT(feasible, 100);
  }
}

TEST(MonotoneStrainFit, RefusesDataThatFallTooFar) {
  const auto hump = [](double p) { return 0.2 * std::sin(p / 100.0 * 3.0); };
  EXPECT_THAT([&] { fit_strain_polynomial(bench(hump), kLimit); },
              ThrowsMessage<InputError>(HasSubstr("expected at most 10 %")));
}

TEST(StrainFit, RefusesExtensionWithAHintOnTheSign) {
  const auto points = bench([](double p) { return -0.002 * p; });
  EXPECT_THAT([&] { fit_strain_polynomial(points, kLimit); },
              ThrowsMessage<InputError>(HasSubstr("change their sign")));
}

TEST(StrainFit, RefusesWhatCannotBeFitted) {
  const auto line = [](double p) { return 0.002 * p; };
  const auto refuses = [](const std::vector<BenchPoint>& points, const char* message) {
    EXPECT_THAT([&] { fit_strain_polynomial(points, kLimit); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  refuses({}, "0 bench points at 0 distinct pressures");
  refuses(bench(line, 3),
          "4 bench points at 4 distinct pressures up to 100 kPa; expected at least 5");
  refuses(bench(line, 20, 15.0), "bench pressures end at 15 kPa; expected at least 90 kPa");
  refuses({{0, 0}, {50, -.1}, {60, -.12}, {70, -.14}, {80, -.16}, {100, -.2}},
          "the lowest bench pressure above 0 is 50 kPa");
  auto points = bench(line);
  points[4].strain = std::numeric_limits<double>::quiet_NaN();
  refuses(points, "bench point 4: (20 kPa, strain nan); expected finite numbers");
  points = bench(line);
  points[2].pressure_kpa = -10.0;
  refuses(points, "bench point 2: -10 kPa; expected the gauge pressure of the inflated side");
  refuses(bench([](double p) { return 0.2 * p; }), "per cent: divide by 100");
}

TEST(StrainFit, LeavesOutPointsAboveTheLimitAndSaysSo) {
  const StrainFit fit =
      fit_strain_polynomial(bench([](double p) { return 0.002 * p; }, 24, 120.0), kLimit);
  EXPECT_EQ(fit.points, 22);  // 0 to 105 kPa in steps of 5
  ASSERT_EQ(fit.warnings.size(), 1u);
  EXPECT_THAT(fit.warnings[0], HasSubstr("3 points above 105 kPa"));
}

TEST(StrainFit, WarnsOfBareActuators) {
  const StrainFit fit = fit_strain_polynomial(bench([](double p) { return 0.0027 * p; }), kLimit);
  ASSERT_EQ(fit.warnings.size(), 1u);
  EXPECT_THAT(fit.warnings[0], HasSubstr("Was a bare actuator measured?"));
}

TEST(Characterise, FitsEverySegmentAndNamesTheOneThatFails) {
  const ArmDescription arm = arm_of(2);
  const auto line = [](double p) { return 0.002 * p; };
  const auto steep = [](double p) { return 0.0021 * p; };
  const CharacterisedArm result = characterise(arm, {bench(line), bench(steep)});
  EXPECT_NEAR(result.arm.segments[0].strain_polynomial[0], 0.002, 1e-8);
  EXPECT_NEAR(result.arm.segments[1].strain_polynomial[0], 0.0021, 1e-8);
  EXPECT_EQ(result.fits[1].pressure_limit_kpa, arm.segments[1].pressure_limit_kpa);
  EXPECT_THAT(
      [&] {
        characterise(arm, {bench(line), {}});
      },
      ThrowsMessage<InputError>(HasSubstr("segment 1: 0 bench points")));
  EXPECT_THAT([&] { characterise(arm, {bench(line)}); },
              ThrowsMessage<InputError>(HasSubstr("bench data of 1 segments")));
}

// A bench test repeated on another machine differs in the last digit; the arm is the same.
TEST(Characterise, KeepsTheNumbersOfTheArmFileWhereTheyAgree) {
  constexpr double kElsewhere = 2e-7;  // of strain, as two machines were apart
  const auto line = [](double p) { return 0.002 * p; };
  ArmDescription arm = arm_of(1);
  const StrainPolynomial of_file = {0.002 + kElsewhere / kLimit, 0.0, 0.0, 0.0};
  arm.segments[0].strain_polynomial = of_file;
  const CharacterisedArm same = characterise(arm, {bench(line)});
  EXPECT_TRUE(same.fits[0].kept);
  EXPECT_EQ(same.fits[0].polynomial, of_file);
  EXPECT_EQ(same.arm.hash(), arm.hash());
  arm.segments[0].strain_polynomial[0] += 10.0 * kSameStrain / kLimit;
  const CharacterisedArm other = characterise(arm, {bench(line)});
  EXPECT_FALSE(other.fits[0].kept);
  EXPECT_NEAR(other.arm.segments[0].strain_polynomial[0], 0.002, 1e-8);
  arm.segments[0].strain_polynomial = {};
  EXPECT_FALSE(characterise(arm, {bench(line)}).fits[0].kept);
}

// The least slope, against a dense search.
TEST(LeastStrainSlope, IsTheSmallestOnADenseGrid) {
  RandomStream random(44, 0);
  for (int trial = 0; trial < 300; ++trial) {
    StrainPolynomial c;
    for (double& value : c) {
      value = random.uniform(-1.0, 1.0) * (random.uniform() < 0.2 ? 0.0 : 1.0);
    }
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 20000; ++k) {
      least = std::min(least, strain_slope_at(c, 2.0 * k / 20000.0));
    }
    const LeastSlope found = min_strain_slope(c, 2.0);
    EXPECT_LE(found.slope_per_kpa, least + 1e-12);
    EXPECT_GE(found.slope_per_kpa, least - 1e-6);
    EXPECT_DOUBLE_EQ(strain_slope_at(c, found.pressure_kpa), found.slope_per_kpa);
  }
}

TEST(Characterise, StopsOnCtrlC) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  const BenchData data = {bench([](double p) { return 0.002 * p; })};
  EXPECT_EXIT(exit_interrupted([&] { characterise(arm_of(1), data); }),
              ::testing::ExitedWithCode(0), "stopped on request");
}

TEST(Characterise, RefusesArmsThatHaveNothingToFit) {
  ArmDescription arm = curvature_arm_of(1);
  EXPECT_THAT([&] { require_characterisable(arm); },
              ThrowsMessage<InputError>(HasSubstr("driven by 'motor angle' in rad")));
  arm.command = {};
  EXPECT_THAT([&] { characterise(arm, {}); },
              ThrowsMessage<InputError>(HasSubstr("says 'no_load: curvature'")));
}

}  // namespace
}  // namespace limber
