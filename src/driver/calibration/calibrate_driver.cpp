#include "limber/driver/calibrate_driver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {

namespace {

constexpr double kCalibrationLimitShare = 0.1;
constexpr double kMaxZeroShare = 0.3;  // of a pulse: what sensors may be off zero by

/// Of the arm before its channels are known: what is compared with a segment's own set point would
/// be compared with another's.
SafetySettings before_calibration(SafetySettings safety, double pulse_kpa) {
  constexpr double kNever = 1e9;
  safety.following_error_kpa = kNever;
  safety.stuck_change_kpa = kNever;
  safety.jump_m = kNever;  // the tracker's unit is not known; JumpWatch watches
  safety.fence.reset();
  safety.vented_kpa = std::max(safety.vented_kpa, kMaxZeroShare * pulse_kpa);
  return safety;
}

/// Jumps of bodies in whatever unit the tracker has: over the arm's own length.
class JumpWatch {
 public:
  JumpWatch(double arm_length_m, double jump_m) : share_(jump_m / arm_length_m) {}

  void watch(const CalibrationFrame& frame) {
    ++frames_;
    const std::optional<Eigen::MatrixX3d> positions = seen_positions(frame);
    if (!positions) {
      return;
    }
    if (before_) {
      const double length = (positions->bottomRows<1>() - positions->topRows<1>()).norm();
      const double moved = (*positions - *before_).rowwise().norm().maxCoeff();
      if (moved > share_ * length * frames_) {
        throw SystemFault(
            fmt::format("a marker body jumped by {:.3g} of the arm's length in {} frame(s); that "
                        "is no motion of an arm",
                        moved / length, frames_));
      }
    }
    before_ = positions;
    frames_ = 0;
  }

  /// The arm moved unseen.
  void forget() { before_.reset(); }

 private:
  double share_;
  std::optional<Eigen::MatrixX3d> before_;
  int frames_ = 0;
};

double smallest_limit_kpa(const ProcessDriver& driver) {
  double smallest = driver.limits_kpa().front().upper_kpa;
  for (const PressureLimits& limits : driver.limits_kpa()) {
    smallest = std::min({smallest, limits.upper_kpa, -limits.lower_kpa});
  }
  return smallest;
}

}  // namespace

DriverCalibration calibrate_driver(const ArmDescription& arm,
                                   const CalibrateDriverSettings& settings) {
  ProcessDriverSettings raw = settings.driver;
  raw.calibration.reset();
  raw.pass_bodies = true;
  raw.limit_scale = kCalibrationLimitShare;
  raw.check_rate = true;
  raw.safety = before_calibration(settings.driver.safety, calibration_pulse_kpa(arm));
  ProcessDriver driver(arm, raw);
  JumpWatch jumps(arm.length_m(), largest_jump_m(settings.driver.safety, arm));

  CalibrationRig rig;
  rig.command = [&](const Pressures& setpoint_kpa) {
    throw_if_interrupted();
    CalibrationFrame frame;
    frame.setpoint_kpa = setpoint_kpa;
    frame.state = driver.command(setpoint_kpa);
    const DriverExchange& exchange = driver.timing().last;
    frame.sent_s = exchange.sent_s;
    frame.received_s = exchange.received_s;
    frame.tracker_s = frame.state.tracker_s;
    frame.bodies = exchange.bodies;
    jumps.watch(frame);
    return frame;
  };
  rig.vent = [&] {
    driver.vent();
    if (!driver.last_vent().confirmed) {
      throw SystemFault("a vent between two steps was not confirmed: nothing more is moved");
    }
    jumps.forget();
  };
  rig.confirm = settings.confirm;

  DriverCalibration result;
  result.hello = driver.hello();
  const double pulse_kpa = smallest_limit_kpa(driver);
  if (!(pulse_kpa > 0.0)) {
    throw InputError(
        "the driver allows nothing on one side of a "
        "channel; a calibration moves each to either side");
  }
  result.log = record_calibration(arm, pulse_kpa, rig);
  result.log.real_time = driver.is_real_time();
  result.vent = driver.last_vent();
  result.estimate = estimate_calibration(
      arm, result.log, settings.answer(result.log.timing.channel), settings.tolerance);
  return result;
}

}  // namespace limber
