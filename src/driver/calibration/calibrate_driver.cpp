#include "limber/driver/calibrate_driver.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/driver/calibration_log.hpp"
#include "limber/run/safety_gate.hpp"
#include "limber/run/safety_settings.hpp"
#include "seen_poses.hpp"

namespace limber {

namespace {

constexpr double kCalibrationRestS = 3.0;
constexpr double kBeforePulseS = 0.5;  // of a pulse, at zero
constexpr double kPulseHoldS = 3.0;
constexpr double kAfterPulseS = 3.0;
constexpr double kSlowRampS = 2.0;
constexpr double kFastRampS = 0.4;
constexpr double kRampTurnS = 0.6;  // held at either end of a ramp
constexpr int kSlowCycles = 2;
constexpr int kFastCycles = 5;

class CalibrationRecorder {
 public:
  CalibrationRecorder(const ArmDescription& arm, double pulse_kpa, const CalibrationRig& rig)
      : arm_(arm), pulse_kpa_(pulse_kpa), rig_(rig) {}

  CalibrationLog run() {
    rig_.confirm(
        fmt::format("Lay the arm straight along its base's axis, vented, and "
                    "step back. It is looked at for {:g} s; nothing moves",
                    kCalibrationRestS));
    hold(0, 0.0, kCalibrationRestS);
    log_.rest_end = log_.frames.size();
    rig_.vent();
    for (int channel = 0; channel < arm_.channel_count(); ++channel) {
      for (const double sign : {1.0, -1.0}) {
        pulse(channel, sign * pulse_kpa_);
      }
    }
    time_shapes(channel_that_bends_most());
    return std::move(log_);
  }

 private:
  /// Frames with `channel` alone at `kpa`.
  void hold(int channel, double kpa, double seconds) {
    for (int k = 0; k < arm_.frames_in(seconds); ++k) {
      Pressures setpoint_kpa = Pressures::Zero(arm_.channel_count());
      setpoint_kpa[channel] = float(kpa);
      log_.frames.push_back(rig_.command(setpoint_kpa));
    }
  }

  /// In `seconds`, or longer where the arm's rate limit asks for it; the end is reached.
  void ramp(int channel, double from_kpa, double to_kpa, double seconds) {
    const int count =
        std::max(arm_.frames_in(seconds),
                 int(std::ceil(std::abs(to_kpa - from_kpa) / arm_.pressure_step_limit_kpa())));
    for (int k = 1; k <= count; ++k) {
      hold(channel, from_kpa + (to_kpa - from_kpa) * k / count, arm_.frame_period_s());
    }
  }

  void pulse(int channel, double kpa) {
    rig_.confirm(fmt::format("Channel {} goes to {:.3g} kPa, and back", channel, kpa));
    CalibrationPulse pulse{channel, kpa, log_.frames.size(), 0, 0};
    hold(channel, 0.0, kBeforePulseS);
    ramp(channel, 0.0, kpa, 0.0);
    hold(channel, kpa, kPulseHoldS);
    pulse.hold_end = log_.frames.size();
    ramp(channel, kpa, 0.0, 0.0);
    hold(channel, 0.0, kAfterPulseS);
    pulse.end = log_.frames.size();
    log_.pulses.push_back(pulse);
    rig_.vent();
  }

  /// By how far the body that moved most came while held up.
  int channel_that_bends_most() const {
    int most = 0;
    double largest = -1.0;
    for (const CalibrationPulse& pulse : log_.pulses) {
      const auto before = seen_positions(log_.frames[pulse.first]);
      const auto held = seen_positions(log_.frames[pulse.hold_end - 1]);
      if (!before || !held) {
        continue;
      }
      const double moved = (*held - *before).rowwise().norm().maxCoeff();
      if (moved > largest) {
        largest = moved;
        most = pulse.channel;
      }
    }
    return most;
  }

  void cycle(int channel, double ramp_s) {
    ramp(channel, 0.0, pulse_kpa_, ramp_s);
    if (log_.timing.peak == 0) {
      log_.timing.peak = log_.frames.size();
    }
    hold(channel, pulse_kpa_, kRampTurnS);
    ramp(channel, pulse_kpa_, 0.0, ramp_s);
    hold(channel, 0.0, kRampTurnS);
  }

  void time_shapes(int channel) {
    rig_.confirm(fmt::format(
        "Channel {} goes to {:.3g} kPa and back, {} times slowly and {} times fast. Look which way "
        "the arm bends, seen from above along the arm",
        channel, pulse_kpa_, kSlowCycles, kFastCycles));
    log_.timing = {channel, log_.frames.size(), 0, 0, 0};
    hold(channel, 0.0, kBeforePulseS);
    for (int k = 0; k < kSlowCycles; ++k) {
      cycle(channel, kSlowRampS);
    }
    log_.timing.fast_first = log_.frames.size();
    for (int k = 0; k < kFastCycles; ++k) {
      cycle(channel, kFastRampS);
    }
    log_.timing.end = log_.frames.size();
    rig_.vent();
  }

  const ArmDescription& arm_;
  double pulse_kpa_;
  const CalibrationRig& rig_;
  CalibrationLog log_;
};

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

double smallest_side_kpa(const std::vector<PressureLimits>& limits) {
  double smallest = limits.front().upper_kpa;
  for (const PressureLimits& one : limits) {
    smallest = std::min({smallest, one.upper_kpa, -one.lower_kpa});
  }
  return smallest;
}

}  // namespace

std::optional<Eigen::MatrixX3d> seen_positions(const CalibrationFrame& frame) {
  return frame.bodies ? PlatePositions(frame.bodies->leftCols<3>()) : plate_positions(frame.state);
}

double calibration_pulse_kpa(const ArmDescription& arm) {
  for (int s = 0; s < arm.segment_count(); ++s) {
    const PressureLimits& limits = arm.segments[s].pressure_limit_kpa;
    if (limits.lower_kpa == 0.0 || limits.upper_kpa == 0.0) {
      throw InputError(
          fmt::format("{} has one side only; a calibration moves each "
                      "segment to either side, since channels may be crossed",
                      segment_name(s)));
    }
  }
  return kCalibrationLimitShare * smallest_side_kpa(limits_of(arm));
}

CalibrationLog record_calibration(const ArmDescription& arm, double pulse_kpa,
                                  const CalibrationRig& rig) {
  return CalibrationRecorder(arm, pulse_kpa, rig).run();
}

DriverCalibration calibrate_driver(const ArmDescription& arm,
                                   const CalibrateDriverSettings& settings) {
  require_rate_to_be_seen(arm);
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
    const ArmState& state = driver.command(setpoint_kpa);
    CalibrationFrame frame{driver.timing().last, setpoint_kpa, state};
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
  const double pulse_kpa = smallest_side_kpa(driver.limits_kpa());
  refuse_if(!(pulse_kpa > 0.0),
            "the driver allows nothing on one side of a "
            "channel; a calibration moves each to either side");
  result.log = record_calibration(arm, pulse_kpa, rig);
  result.log.real_time = driver.is_real_time();
  result.estimate = estimate_calibration(
      arm, result.log, settings.answer(result.log.timing.channel), settings.tolerance);
  return result;
}

}  // namespace limber
