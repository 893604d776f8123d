#include "limber/training/run_errors.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/random_stream.hpp"
#include "limber/training/tip_errors.hpp"

namespace limber {
namespace {

constexpr double kLength_m = 0.7;
constexpr int kPlates = 4;

/// A motion whose plates are off in proportion to their distance from the base.
/// @param at_start  whether it is when they have not moved yet; else when they have all their room
GrowingErrors motion(RandomStream& random, bool at_start) {
  const double size_m = 0.01 * std::exp(0.4 * random.normal());
  GrowingErrors errors;
  for (std::size_t g = 0; g < kStartShares.size(); ++g) {
    for (int plate = 0; plate < kPlates; ++plate) {
      errors.of[g].plate_m.push_back(size_m * plate / (kPlates - 1) *
                                     (at_start ? 1.0 / kStartShares[g] : 1.0));
    }
    errors.of[g].end_m = size_m;
    errors.of[g].end_heading_rad = 3.0 * size_m;
    errors.tip_share[g] = 0.5 * (kStartShares[g] + 1.0);
  }
  return errors;
}

RunErrors errors_of(int count, bool at_start, std::uint64_t seed = 1) {
  RandomStream random(seed, 0);
  RunErrors errors;
  for (int i = 0; i < count; ++i) {
    // Segment 1 errs three times as much above 40 kPa, where one motion in 25 is.
    const bool is_weak = i % 25 == 0;
    errors.add(0.02, is_weak ? 0.03 : 0.01, motion(random, at_start), 40,
               Pressures(Eigen::Vector2f(float(i % 7), is_weak ? 60.0F : float(i % 9) * 3.0F)));
  }
  return errors;
}

TEST(RunErrors, GiveATubeThatHoldsThePlatesOfOtherMotions) {
  const Tube tube = errors_of(1000, false).tube(kLength_m).value();
  RandomStream random(2, 0);
  int inside = 0;
  constexpr int kOthers = 4000;
  for (int i = 0; i < kOthers; ++i) {
    const GrowingErrors other = motion(random, false);
    inside += score_of(other.of[0].plate_m, tube.plate_scale_m) <= tube.levels[0].factor ? 1 : 0;
  }
  constexpr double kFourDeviations = 0.03;  // of the quantile of 500 motions, and of 4000
  EXPECT_NEAR(double(inside) / kOthers, 0.95, kFourDeviations);
  EXPECT_LT(tube.plate_scale_m[1], 0.5 * tube.plate_scale_m[3]);
}

TEST(RunErrors, TheTubeGrowsOnlyWhereErrorsDo) {
  EXPECT_EQ(errors_of(200, false).tube(kLength_m)->growth.start_share, 0.4);
  EXPECT_EQ(errors_of(200, true).tube(kLength_m)->growth.start_share, 1.0);
}

TEST(RunErrors, TheTubesEndIsThatOfThePredictionError) {
  const RunErrors errors = errors_of(200, false);
  const Tube tube = errors.tube(kLength_m).value();
  const PredictionError error = errors.result(0.05).value();
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(tube.levels[0].factor * tube.end_scale_m, error.end_position_m, kRounding);
  EXPECT_NEAR(tube.levels[0].factor * tube.end_heading_scale_rad, *error.end_orientation_rad,
              kRounding);
  EXPECT_NO_THROW(validate(tube, "the tube"));
}

TEST(RunErrors, OneOutlierAmongAFewRunsDoesNotRule) {
  // Off the path: 0.03 m in the first of 25 runs, 0.01 m in all others.
  const auto off_path_m = [](int runs) { return errors_of(runs, false).result(0.05)->off_path_m; };
  EXPECT_DOUBLE_EQ(off_path_m(8), 0.02) << "95 % of a few runs is twice their median";
  EXPECT_DOUBLE_EQ(off_path_m(19), 0.03) << "95 % of 19 is the largest";
}

TEST(RunErrors, SayWhereMoreMotionsWouldHelp) {
  const std::string where = errors_of(600, false).widest_where("kPa");
  EXPECT_THAT(where, testing::HasSubstr("segment 1 at 40 to 60 kPa: 3.0 cm off the path in 24 of"));
  EXPECT_EQ(RunErrors().widest_where("kPa"), "");
}

TEST(RunErrors, TooFewMotionsGiveNoTube) {
  EXPECT_FALSE(errors_of(77, false).tube(kLength_m));
  EXPECT_TRUE(errors_of(78, false).tube(kLength_m));
  EXPECT_FALSE(RunErrors().result(0.05));
}

TEST(TipErrorSeries, MotionsOfSeveralEpisodesAreCountedOn) {
  constexpr int kLast = std::numeric_limits<int>::max();
  TipErrorSeries all;
  for (const std::vector<int>& motions : {std::vector<int>{kLast - 1, kLast, kLast}, {0, 7}}) {
    TipErrorSeries one;
    one.motion = motions;
    append(all, one);
  }
  EXPECT_EQ(all.motion, (std::vector<int>{0, 1, 1, 2, 3}));
}

}  // namespace
}  // namespace limber
