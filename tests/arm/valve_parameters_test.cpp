#include "limber/arm/valve_parameters.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/arm/valve_model.hpp"
#include "limber/common/error.hpp"
#include "random_valves.hpp"
#include "test_arms.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ValveParameters, TheHashChangesWithEveryNumber) {
  const ValveParameters base = same(2, {{0.1, 100.0}, {0.12, 90.0}, 0.01, 0.2});
  std::vector<ValveParameters> others(8, base);
  others[0].has_sides = false;
  others[1].segments[1].inflating.time_constant_s += 1e-12;
  others[2].segments[1].inflating.rate_limit_kpa_per_s = kNoLimit;
  others[3].segments[1].venting.time_constant_s += 1e-12;
  others[4].segments[1].venting.rate_limit_kpa_per_s += 1e-9;
  others[5].segments[1].dead_time_s += 1e-12;
  others[6].segments[1].dead_band_kpa += 1e-12;
  others[7].segments.pop_back();
  std::vector<std::string> hashes{base.hash()};
  for (const ValveParameters& other : others) {
    EXPECT_THAT(hashes, testing::Not(testing::Contains(other.hash())));
    hashes.push_back(other.hash());
  }
  EXPECT_EQ(ValveParameters{}.hash(), "");
}

TEST(ValveParameters, SaysWhichParameterIsOutOfRange) {
  const ArmDescription arm = arm_of(2);
  const auto expect_refused = [&](const ValveParameters& parameters, const std::string& message) {
    EXPECT_THAT([&] { ValveModel(arm, parameters); },
                ThrowsMessage<InputError>(HasSubstr(message)));
  };
  expect_refused(same(3, lag(0.1, 0.1)), "valves: 3 segments found; the arm has 2");
  expect_refused(same(2, lag(0.1, 0.1), false), "has_sides = false; arm 'test_arm_of_2' is driven");
  expect_refused(same(2, lag(-0.1, 0.1)),
                 "segment 0: inflating.time_constant_s = -0.1; expected 0 to 100 s");
  expect_refused(same(2, lag(0.1, kNoLimit)), "segment 0: venting.time_constant_s = inf");
  SegmentValves valves = lag(0.1, 0.1);
  valves.venting.rate_limit_kpa_per_s = 0.0;
  expect_refused(same(2, valves), "segment 0: venting.rate_limit_kpa_per_s = 0; expected a rate");
  valves = lag(0.1, 0.1);
  valves.dead_time_s = std::nan("");
  expect_refused(same(2, valves), "segment 0: dead_time_s = nan; expected 0 to 5 s");
  valves = lag(0.1, 0.1);
  valves.dead_band_kpa = -1.0;
  ValveParameters second = same(2, lag(0.1, 0.1));
  second.segments[1] = valves;
  expect_refused(second, "segment 1: dead_band_kpa = -1; expected a finite number >= 0");
}

}  // namespace
}  // namespace limber
