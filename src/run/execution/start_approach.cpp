#include "start_approach.hpp"

#include <cmath>

#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

bool has_arrived(const ArmDescription& arm, const ArmDriver& driver,
                 const Pressures& setpoint_kpa) {
  constexpr double kArrived = 0.01;  // of the limit, as planning's hold has it
  for (Eigen::Index i = 0; i < setpoint_kpa.size(); ++i) {
    const double limit = arm.limits_of_channel(int(i)).largest_kpa();
    if (!(std::abs(double(driver.state().pressure_kpa[i]) - double(setpoint_kpa[i])) <=
          kArrived * limit)) {
      return false;
    }
  }
  return true;
}

}  // namespace

void approach_start(const ArmDescription& arm, ArmDriver& driver, const Pressures& start_kpa,
                    const std::function<void()>& before_each) {
  if (start_kpa.isZero()) {
    return;
  }
  constexpr double kSettlingS = 3.0;  // at least: what full reversals take, and shapes to rest
  constexpr double kLongestSettlingS = 60.0;
  const Pressures vented_kpa = Pressures::Zero(arm.channel_count());
  for (const Pressures& setpoint_kpa :
       straight_setpoints(vented_kpa, start_kpa, arm.pressure_step_limit_kpa())) {
    before_each();
    driver.command(setpoint_kpa);
  }
  const int min_frames = arm.frames_in(kSettlingS);
  const int max_frames = arm.frames_in(kLongestSettlingS);
  for (int k = 0; k < min_frames || (k < max_frames && !has_arrived(arm, driver, start_kpa)); ++k) {
    before_each();
    driver.command(start_kpa);
  }
}

}  // namespace limber
