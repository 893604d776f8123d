#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/driver/driver_protocol.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

struct ProcessDriverSettings {
  std::string command;       ///< what follows `exec:`; no shell sees it
  double limit_scale = 1.0;  ///< limits in force are so many times the arm's, in (0, 1]
  bool check_rate = true;    ///< false where a schedule jumps and the valves ramp by themselves
  /// Whether a driver may say that it keeps no frames (`real_time` false), so that it is asked as
  /// fast as it answers. Its word alone is not enough: an arm would be moved at that rate.
  bool simulated = false;
  bool install_signals =
      true;  ///< install_arm_signals; false where the caller stops in its own way
  SafetySettings safety;
  /// Told what becomes of the arm at a vent, "vented: 0.8 kPa after 0.6 s"; may be empty.
  std::function<void(const std::string&)> say;
  /// Looked at every 5 ms, beside the signals, while set points wait for their frame or their
  /// state: once it is true, whatever thread made it so, a `vent` goes out and `command` throws
  /// Interrupted. Empty: never.
  std::function<bool()> vent_asked = {};
  fs::path log;                ///< every line of both sides with its time; empty: none
  bool append_to_log = false;  ///< of a driver that is started again; else a new log is begun
  std::optional<WireCalibration> calibration;  ///< none: the wire is the arm's
  /// For `limber driver calibrate`: bodies in 3D, which no plane is known for, are no fault. They
  /// come with DriverExchange.
  bool pass_bodies = false;
};

/// When the last `set` was sent and its state was there, on limber's clock; and what the tracker
/// saw, where bodies pass.
struct DriverExchange {
  double sent_s = 0.0;
  double received_s = 0.0;
  std::optional<BodyPoses> bodies;
};

/// How well both sides kept to the frames.
struct DriverTiming {
  std::vector<double> late_s;        ///< of every `set`: after its slot
  std::vector<double> round_trip_s;  ///< of every `set`, until its state was there
  int skipped_slots = 0;  ///< frames in which no `set` was sent, as the one before took so long
  int frames_unseen = 0;  ///< states without a backbone, of a driver that tracks
  DriverExchange last;    ///< of the last `set`
};

/// What came of the last vent.
struct VentResult {
  bool confirmed = false;     ///< every measured pressure came down
  double pressure_kpa = 0.0;  ///< the largest, when last measured
  double after_s = 0.0;       ///< the vent
  std::string message;        ///< the same in words; empty before the first vent
};

/// The user's valve controller behind a program of theirs that speaks limber's protocol
/// (docs/driver.md), in a process of its own. One `set` goes out in each frame slot, unless the
/// driver says that it simulates. Every set point and every state passes the SafetyGate.
///
/// Whatever goes wrong: `vent` is sent, and as long as the driver answers it is watched until the
/// arm is vented. Then its input is closed, and after 0.5 s it and its process group are killed.
///
/// Laws: as ArmDriver, and a set point beyond a limit is a SystemFault. After `vent` the next
/// `command` starts a new run of frames. Threads: one at a time.
class ProcessDriver final : public ArmDriver {
 public:
  /// Starts the program, exchanges hellos, and vents.
  /// @throws InputError where the command can't be started; SystemFault where the driver does not
  /// answer, is another arm's, is a simulation that nobody expects, or reads a pressure after
  /// venting; Interrupted.
  ProcessDriver(const ArmDescription& arm, const ProcessDriverSettings& settings);
  /// Vents and says goodbye.
  ~ProcessDriver() override;

  const ArmState& state() const override;
  /// @throws Interrupted where a vent was asked for (ProcessDriverSettings): it is sent, or is the
  /// next thing to send.
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;

  /// Watches the measured pressures until all are down, 5 s at most; says what came of it.
  void vent() noexcept override;
  bool is_real_time() const override;

  /// A fresh state of the vented arm, for whoever begins a run some time after the last one.
  const ArmState& look();

  /// For `limber driver check`: sends nothing for `seconds`, then vents. @return what the driver
  /// then answers first. @throws SystemFault
  ArmState read_after_silence(double seconds);
  /// The same: closes the driver's input without a vent or a word, or kills it before it can vent.
  /// The driver is ended.
  void abandon(bool killed = false);
  /// What the driver answered to its first vent, before that could act.
  const ArmState& first_state() const;

  const DriverHello& hello() const;
  const std::optional<WireCalibration>& calibration() const;
  const DriverTiming& timing() const;
  const VentResult& last_vent() const;
  /// Whether any driver of this process was left with an arm whose last vent is not confirmed,
  /// broke while it vented, or could not be ended; `say` was told.
  static bool was_any_left_unsafe();
  /// The arm's, scaled, or the driver's own where those are lower.
  std::vector<PressureLimits> limits_kpa() const override;

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace limber
