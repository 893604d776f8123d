// What the identification finds on the virtual arm, whose valves are a second-order system with a
// controller, and not the model that is fitted.
#include <cmath>

#include <gmock/gmock.h>

#include "limber/arm/valve_parameters.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"

namespace limber {
namespace {

using testing::IsEmpty;

constexpr double kTimeConstantShare = 0.1;
constexpr double kRateShare = 0.05;
constexpr double kDeadTimeS = 0.005;
constexpr double kMeanShare = 0.01;  // of the limit, on what is held back

/// The valves of an arm file on a short chain, which takes little time to simulate.
ArmDescription with_valves_of(const std::string& file) {
  ArmDescription arm = load_arm(std::string(LIMBER_SOURCE_DIR) + "/" + file);
  arm.segments.resize(2);
  arm.segments[0].gaps = 1;
  arm.segments[1].gaps = 1;
  return arm;
}

/// Random motions: jumps in even episodes, straight lines in odd ones.
IdentifiedValves identify_on(const ArmDescription& arm, double noise_kpa = 0.0) {
  constexpr int kEpisodes = 10;
  std::vector<Episode> episodes;
  for (int e = 0; e < kEpisodes; ++e) {
    ScheduleSettings schedule;
    schedule.kind = ScheduleKind::random;
    schedule.count = 15;
    schedule.episodes = 1;
    schedule.approach = e % 2 == 0 ? Approach::step : Approach::straight;
    schedule.hold_s = 3.0;
    schedule.hold_min_s = 0.2;
    VirtualArmOptions options;
    options.noise_kpa = noise_kpa;
    options.stream = std::uint64_t(e);
    VirtualArm driver(arm, options);
    episodes.push_back(record_episode(
        arm, driver, make_schedule(arm, schedule, 100 + std::uint64_t(e)).front(), {}));
  }
  return identify_valves(episodes, arm, "random");
}

void expect_recovered(const ArmDescription& arm, double noise_kpa = 0.0) {
  const IdentifiedValves found = identify_on(arm, noise_kpa);
  ASSERT_FALSE(found.parameters.is_ideal()) << found.findings.reason;
  SCOPED_TRACE(to_text(found));
  const VirtualArmParameters truth = virtual_arm_parameters(arm);
  const SegmentValves& valves = found.parameters.segments.front();
  EXPECT_NEAR(valves.inflating.time_constant_s, truth.inflate_time_constant_s,
              kTimeConstantShare * truth.inflate_time_constant_s);
  EXPECT_NEAR(valves.venting.time_constant_s, truth.vent_time_constant_s,
              kTimeConstantShare * truth.vent_time_constant_s);
  EXPECT_NEAR(valves.dead_time_s, truth.valve_dead_time_s + truth.valve_lag_s, kDeadTimeS);
  EXPECT_LE(found.findings.held_back.mean_kpa,
            kMeanShare * arm.segments.front().pressure_limit_kpa.largest_kpa());
  EXPECT_THAT(found.findings.warnings, IsEmpty());
}

TEST(ValveRecovery, OfThePapersArm) {
  const ArmDescription arm = with_valves_of("arms/three_segment.yaml");
  expect_recovered(arm);
  const ValveErrors errors = identify_on(arm).findings.held_back;
  EXPECT_LE(errors.mean_kpa, 0.5);
  EXPECT_LE(errors.max_kpa, 3.0);
}

TEST(ValveRecovery, WithSensorNoise) {
  constexpr double kNoiseKpa = 0.5;
  expect_recovered(with_valves_of("arms/three_segment.yaml"), kNoiseKpa);
}

TEST(ValveRecovery, OfSlowValves) {
  expect_recovered(with_valves_of("tests/arms/slow_valves.yaml"));
}

TEST(ValveRecovery, OfLateValves) {
  expect_recovered(with_valves_of("tests/arms/late_valves.yaml"));
}

TEST(ValveRecovery, OfLopsidedValves) {
  const ArmDescription arm = with_valves_of("tests/arms/lopsided_valves.yaml");
  expect_recovered(arm);
  const SegmentValves valves = identify_on(arm).parameters.segments.front();
  EXPECT_NEAR(valves.inflating.rate_limit_kpa_per_s, 60.0, kRateShare * 60.0);
  EXPECT_NEAR(valves.venting.rate_limit_kpa_per_s, 140.0, kRateShare * 140.0);
}

}  // namespace
}  // namespace limber
