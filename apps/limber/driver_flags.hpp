#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "limber/common/json.hpp"
#include "limber/driver/driver_run.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/driver/wire_calibration.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "verb.hpp"

namespace limber {

/// What --driver and its like begin with, before the driver's own command.
inline constexpr std::string_view kExec = "exec:";

/// @throws InputError unless 0 < scale <= 1
void require_limit_scale(double scale);

/// What limber has to know of a driver that it starts, in every verb that does: --calibration FILE,
/// what `limber driver calibrate` found lies between it and its arm, and --simulated.
class WireFlags {
 public:
  void add_to(CLI::App& app);
  bool is_calibrated() const { return !calibration_.empty(); }
  /// None without --calibration. @throws InputError if it is another arm's.
  std::optional<WireCalibration> calibration(const ArmDescription& arm) const;
  bool may_be_simulated() const { return simulated_; }

  /// For the program of `exec:COMMAND`. @param driver  that whole text
  /// @param arm_file  its mapping `safety` says what is watched
  /// @throws InputError where the text is another, or the calibration is another arm's.
  ProcessDriverSettings settings(const std::string& driver, const ArmDescription& arm,
                                 const std::string& arm_file) const;

 private:
  std::string calibration_;
  bool simulated_ = false;
};

/// Prints what a driver says of its arm; that it was vented only if `all`.
std::function<void(const std::string&)> tell_of_arm(bool all);

/// What moves the arm, and how far: flags of every verb that moves one.
class DriverFlags {
 public:
  /// @param may_be_model  whether --driver model:FILE is understood too
  void add_to(CLI::App& app, bool may_be_model = false);

  /// @param unused  the verb's own flags that --dry-run has no use for
  /// @throws InputError if --driver is none of those, or a flag does not fit.
  void check(std::initializer_list<const char*> unused = {}) const;
  bool is_virtual() const { return driver_ == "virtual"; }
  bool is_model() const;
  /// @pre is_model()
  std::string model_file() const;
  bool is_program() const { return !is_virtual() && !is_model(); }
  bool is_dry_run() const { return dry_run_; }
  double limit_scale() const { return limit_scale_; }

  /// Where a run on a driver is recorded if --out is not given: named by the time, and said.
  std::string recording_or_default(const std::string& out, const CommonFlags& flags) const;

  /// Starts the program of exec:COMMAND. Its log lies beside the recording `out`.
  /// @param arm_file    its mapping `safety` says what is watched
  /// @param check_rate  as in ProcessDriverSettings
  std::unique_ptr<ProcessDriver> start(const ArmDescription& arm, const std::string& arm_file,
                                       const std::string& out, bool check_rate,
                                       const CommonFlags& flags) const;

  /// Prints every line that `move` would send, through --calibration if there is one.
  int print_dry_run(const ArmDescription& arm, const CommonFlags& flags,
                    const std::function<void(ArmDriver&)>& move) const;

 private:
  const CLI::App* command_ = nullptr;
  std::string driver_ = "virtual";
  WireFlags wire_;
  std::string log_;
  double limit_scale_ = 1.0;
  bool dry_run_ = false;
  bool may_be_model_ = false;
};

/// @throws InputError naming frame and segment where the plan goes beyond `limits_kpa`.
void require_within(const Plan& plan, const std::vector<PressureLimits>& limits_kpa,
                    const std::string& file, const std::string& whose);

/// @throws InputError where motions within the arm's limits, scaled, go beyond those of the driver.
void require_reach(const ArmDescription& arm, double limit_scale, const ProcessDriver& driver);

/// Where the vented arm lies: one look through the driver of `exec:COMMAND`.
/// @throws SystemFault where nothing tracks the arm.
ArmStart measured_start(const ArmDescription& arm, const std::string& arm_file,
                        const std::string& driver, const WireFlags& wire);

/// How the driver kept to the frames, and its last vent.
Json to_json(const ProcessDriver& driver);

}  // namespace limber
