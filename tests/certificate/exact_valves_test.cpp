#include "src/certificate/exact_arm.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "limber/arm/valve_model.hpp"
#include "limber/certificate/certificate.hpp"
#include "planning/play_model.hpp"

namespace limber {
namespace {

SegmentValves random_valves(RandomStream& random) {
  const auto direction = [&] {
    return ValveDirection{random.uniform(0.0, 0.5), random.uniform(20.0, 400.0)};
  };
  return {direction(), direction(), random.uniform(0.0, 0.3), random.uniform(0.0, 1.0)};
}

// Two implementations that share nothing but the equations.
TEST(ExactValves, AgreesWithTheFastModelInFloatOverLongWalks) {
  ArmDescription arm = three_segment_arm();
  RandomStream random(9, 0);
  double farthest_kpa = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const ValveParameters parameters{
        trial % 5 != 0, {random_valves(random), random_valves(random), random_valves(random)}};
    arm.command = parameters.has_sides ? Command{} : Command{"angle", "rad"};
    const ValveModel fast(arm, parameters);
    Pressures setpoint = random_pressures(arm, random);
    Eigen::VectorXf state = fast.settled_state(setpoint);
    ExactValves::Configurations setpoints{{setpoint.begin(), setpoint.end()}};
    ExactValves::Configurations pressures{{setpoint.begin(), setpoint.end()}};
    for (int k = 0; k < 300; ++k) {
      if (random.uniform() < 0.3) {
        setpoint = random_pressures(arm, random);
      }
      fast.step(setpoint, state);
      setpoints.emplace_back(setpoint.begin(), setpoint.end());
      pressures.emplace_back(state.begin(), state.begin() + 3);
    }
    const auto exact = ExactValves(arm, parameters).pressures_along(setpoints);
    ASSERT_EQ(exact.size(), pressures.size());
    for (std::size_t k = 0; k < exact.size(); ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        farthest_kpa = std::max(farthest_kpa, std::abs(exact[k][i] - pressures[k][i]));
      }
    }
  }
  EXPECT_LT(farthest_kpa,
            0.5 * Certificate::kPressureDeviationShare * arm.limits_of_channel(0).largest_kpa());
  EXPECT_GT(farthest_kpa, 0.0) << "float and double differ";
}

// A motion that is cut anywhere goes on as it would have.
TEST(ExactValves, GoOnFromMidMotionAsTheWholeMotionDoes) {
  constexpr double kRoundingKpa = 1e-9;
  const ArmDescription arm = three_segment_arm();
  RandomStream random(10, 0);
  for (int trial = 0; trial < 20; ++trial) {
    const ValveParameters parameters{
        true, {random_valves(random), random_valves(random), random_valves(random)}};
    const ExactValves valves(arm, parameters);
    ExactValves::Configurations setpoints;
    for (int k = 0; k < 40; ++k) {
      const Pressures setpoint = random_pressures(arm, random);
      setpoints.emplace_back(setpoint.begin(), setpoint.end());
    }
    const auto whole = valves.pressures_along(setpoints);
    for (const std::size_t cut : {1U, 5U, 20U}) {
      const ExactValves::Configurations rest(setpoints.begin() + std::ptrdiff_t(cut),
                                             setpoints.end());
      const ExactValves::Configurations before(setpoints.rend() - std::ptrdiff_t(cut),
                                               setpoints.rend());
      const auto after = valves.pressures_along(rest, whole[cut], before);
      for (std::size_t k = 0; k < after.size(); ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
          ASSERT_NEAR(after[k][i], whole[cut + k][i], kRoundingKpa) << cut << ", frame " << k;
        }
      }
    }
  }
}

TEST(ExactValves, IdealOnesAreTheSetPoints) {
  const ArmDescription arm = three_segment_arm();
  const ExactValves::Configurations setpoints{{0.0, 0.0, 0.0}, {5.0, -5.0, 2.0}, {9.0, -9.0, 3.0}};
  EXPECT_EQ(ExactValves(arm, {}).pressures_along(setpoints), setpoints);
}

// 0.15 s at 20 Hz are three frames, whatever rounding makes of either. Valves that follow at once
// would else jump a frame early.
TEST(ExactValves, ADeadTimeOfWholeFramesEndsWithAFrame) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const ArmDescription arm = three_segment_arm();
  RandomStream random(11, 0);
  for (const double dead_time_s : {0.05, 0.10, 0.15, 0.20, 0.25, 0.30}) {
    const SegmentValves at_once{{0.0, kNoLimit}, {0.0, kNoLimit}, dead_time_s, 0.0};
    const ValveParameters parameters{true, {at_once, at_once, at_once}};
    const ValveModel fast(arm, parameters);
    Pressures setpoint = random_pressures(arm, random);
    Eigen::VectorXf state = fast.settled_state(setpoint);
    ExactValves::Configurations setpoints{{setpoint.begin(), setpoint.end()}};
    ExactValves::Configurations pressures = setpoints;
    for (int k = 0; k < 40; ++k) {
      setpoint = random_pressures(arm, random);
      fast.step(setpoint, state);
      setpoints.emplace_back(setpoint.begin(), setpoint.end());
      pressures.emplace_back(state.begin(), state.begin() + 3);
    }
    EXPECT_EQ(ExactValves(arm, parameters).pressures_along(setpoints), pressures) << dead_time_s;
  }
}

// Closed form: a step of 50 kPa after one frame and a half, then 100 kPa/s.
TEST(ExactValves, WaitsOutADeadTimeThatIsNoWholeFrame) {
  const ArmDescription arm = three_segment_arm();
  const SegmentValves valves{{0.0, 100.0}, {0.0, 100.0}, 0.075, 0.0};
  ExactValves::Configurations setpoints(6, {50.0, 50.0, 50.0});
  setpoints.front() = {0.0, 0.0, 0.0};
  const ValveParameters parameters{true, {valves, valves, valves}};
  const auto pressures = ExactValves(arm, parameters).pressures_along(setpoints);
  constexpr double kExactKpa = 1e-9;
  EXPECT_NEAR(pressures[1][0], 0.0, kExactKpa);
  EXPECT_NEAR(pressures[2][0], 2.5, kExactKpa);
  EXPECT_NEAR(pressures[3][0], 7.5, kExactKpa);
}

}  // namespace
}  // namespace limber
