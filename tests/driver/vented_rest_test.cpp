#include "limber/driver/vented_rest.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "support/fake_arm.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// An arm whose tip swings to and fro by less and less.
class Swinging {
 public:
  Swinging(const ArmDescription& arm, double half_life_s)
      : period_s_(arm.frame_period_s()), half_life_s_(half_life_s) {
    state_.backbone = Backbone::Zero(arm.point_count(), 3);
  }

  const ArmState& look() {
    const double time_s = period_s_ * frames_++;
    (*state_.backbone)(state_.backbone->rows() - 1, 1) =
        static_cast<float>(0.05 * std::exp2(-time_s / half_life_s_) * std::cos(6.0 * time_s));
    return state_;
  }

  double time_s() const { return period_s_ * (frames_ - 1); }

 private:
  double period_s_;
  double half_life_s_;
  int frames_ = 0;
  ArmState state_;
};

ArmStart rest_of(Swinging& arm) {
  return vented_rest(small_arm(), [&]() -> const ArmState& { return arm.look(); });
}

TEST(VentedRest, WaitsUntilTheArmHasStoppedSwinging) {
  Swinging arm(small_arm(), 0.3);
  const ArmStart rest = rest_of(arm);
  EXPECT_GT(arm.time_s(), 0.7);
  EXPECT_LT(arm.time_s(), 3.0);
  EXPECT_LT(std::abs(rest.backbone(rest.backbone.rows() - 1, 1)), 0.01F);
  EXPECT_EQ(rest.pressures_kpa, Pressures::Zero(2));
}

TEST(VentedRest, ArmThatLiesStillIsSeenAtOnce) {
  Swinging arm(small_arm(), 1e-3);
  (void)arm.look();
  (void)rest_of(arm);
  EXPECT_NEAR(arm.time_s(), 0.55, 0.051) << "half a second is looked at";
}

TEST(VentedRest, GivesUpOnAnArmThatNeverRests) {
  Swinging arm(small_arm(), std::numeric_limits<double>::infinity());
  EXPECT_THAT([&] { (void)rest_of(arm); },
              ThrowsMessage<SystemFault>(HasSubstr("does not lie still")));
  EXPECT_NEAR(arm.time_s(), 10.0, 0.1);
}

TEST(VentedRest, RefusesAnArmThatNothingTracks) {
  const ArmState blind;
  EXPECT_THAT([&] { (void)vented_rest(small_arm(), [&]() -> const ArmState& { return blind; }); },
              ThrowsMessage<SystemFault>(HasSubstr("nothing tracks the arm")));
}

TEST(VentedRest, PassesOverFramesThatAreNotTracked) {
  Swinging arm(small_arm(), 0.3);
  const ArmState blind;
  int frame = 0;
  const ArmStart rest = vented_rest(small_arm(), [&]() -> const ArmState& {
    const ArmState& seen = arm.look();
    return frame++ % 3 == 0 ? blind : seen;
  });
  EXPECT_LT(std::abs(rest.backbone(rest.backbone.rows() - 1, 1)), 0.01F);
}

TEST(VentedRest, SaysThatAnArmWasLost) {
  Swinging arm(small_arm(), 0.3);
  const ArmState blind;
  int frame = 0;
  EXPECT_THAT(
      [&] {
        (void)vented_rest(small_arm(),
                          [&]() -> const ArmState& { return frame++ < 3 ? arm.look() : blind; });
      },
      ThrowsMessage<SystemFault>(HasSubstr("was lost")));
}

}  // namespace
}  // namespace limber
