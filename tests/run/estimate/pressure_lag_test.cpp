#include "src/run/estimate/pressure_loss.hpp"

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

const ArmDescription kArm = small_arm();
const ValveModel kValves(kArm,
                         {true,
                          std::vector<SegmentValves>(2, {{0.1, 100.0}, {0.1, 100.0}, 0.1, 0.05})});

Pressures setpoint(int frame) {
  return Pressures::Constant(2, frame < 10 ? 2.0F * float(frame) : 20.0F);
}

/// What is found out in 30 frames about states that are so many frames old.
int found_lag(int lag, double noise_kpa) {
  PressureLag found(kValves);
  RandomStream random(7, static_cast<std::uint64_t>(lag));
  Eigen::VectorXf state = kValves.settled_state(setpoint(0));
  std::deque<Pressures> shown(static_cast<std::size_t>(lag), setpoint(0));
  int result = 0;
  for (int frame = 0; frame < 30; ++frame) {
    if (frame > 0) {
      kValves.step(setpoint(frame), state);
    }
    shown.emplace_back(state.head(2));
    Pressures measured = shown.front();
    shown.pop_front();
    for (float& kpa : measured) {
      kpa += float(noise_kpa * random.normal());
    }
    result = found.note(setpoint(frame), measured);
  }
  return result;
}

TEST(PressureLag, IsHowOldTheStatesAre) {
  for (int lag = 0; lag <= PressureLag::kMaxFrames; ++lag) {
    EXPECT_EQ(found_lag(lag, 0.0), lag);
    EXPECT_EQ(found_lag(lag, 0.5), lag) << "with noise";
  }
}

TEST(PressureLag, NoiseAtRestIsNone) {
  PressureLag found(kValves);
  RandomStream random(9, 0);
  for (int frame = 0; frame < 2000; ++frame) {
    Pressures measured = Pressures::Zero(2);
    for (float& kpa : measured) {
      kpa += float(random.normal());
    }
    ASSERT_EQ(found.note(Pressures::Zero(2), measured), 0) << frame;
  }
}

TEST(PressureLag, IdealValvesTellNothing) {
  const ValveModel ideal = ValveModel::ideal(2);
  PressureLag found(ideal);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_EQ(found.note(setpoint(frame), setpoint(std::max(0, frame - 2))), 0);
  }
}

}  // namespace
}  // namespace limber
