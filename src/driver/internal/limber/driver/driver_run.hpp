#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/driver/process_driver.hpp"
#include "limber/run/collection.hpp"
#include "limber/world/plan.hpp"

namespace limber {

/// "driver arduino (device: limber-sketch 2), started by user@host", as recordings say it.
std::string describe(const ProcessDriver& driver);

/// What a collection on it has to have in common with the one that it goes on with.
std::string how_it_is_moved(const ProcessDriver& driver);

/// "run_20260102_030405": by the time of now, UTC.
std::string time_stamped_run_name();
/// stem + suffix; numbered, with the separator before the number, where an earlier run's file has
/// that name.
std::string free_name(const std::string& stem, std::string_view separator, std::string_view suffix);

/// How far a plate may be from where the plan starts: what plans keep free, and at least what
/// trackers and a base's frame are off by.
double allowed_start_error_m(const Plan& plan);

/// Every episode on the same driver, which has to outlive the factory.
DriverFactory on_one_driver(ProcessDriver& driver);

/// A set point that limits do not allow.
struct ForbiddenSetpoint {
  std::size_t frame = 0;
  Eigen::Index segment = 0;
  double value = 0.0;  ///< [kPa], or the command's own unit
  PressureLimits limits;
};

/// The first set point of a plan that is beyond `limits`, by more than float32 rounds.
std::optional<ForbiddenSetpoint> first_beyond(const Plan& plan,
                                              const std::vector<PressureLimits>& limits);

/// Motions go farther in a segment than a driver lets them.
struct ShortReach {
  Eigen::Index segment = 0;
  double wanted_kpa = 0.0;
  double allowed_kpa = 0.0;
};

/// The limits of `arm`, so many times smaller, stay within those of the driver on every side; two
/// decimals, so that it can be typed. None where the driver allows nothing on a side of the arm's.
std::optional<double> scale_within(const ArmDescription& arm,
                                   const std::vector<PressureLimits>& allowed_kpa);

/// What to do about a short reach. @param flag  as "--limit-scale {}", with the scale in its place
std::string advice(const ShortReach& found, const ArmDescription& arm,
                   const std::vector<PressureLimits>& allowed_kpa, const char* flag);

/// Where `limit_scale` times the limits of the arm go beyond those of the driver.
std::optional<ShortReach> first_short_reach(const ArmDescription& arm, double limit_scale,
                                            const std::vector<PressureLimits>& allowed_kpa);

/// What limber and a driver said to each other, one JSON object per line: {"at_s": 1.25,
/// "to_driver": {…}}. The first line says who started the run, and when. Written as it happens, so
/// that it is whole up to a crash; a log that can't be written any more never stops an arm.
class DriverLog {
 public:
  /// @throws SystemFault where `path` can't be opened; does nothing where it is empty.
  DriverLog(const fs::path& path, std::string_view command, bool append);

  void sent(std::string_view line) { write("to_driver", line); }
  void received(std::string_view line) { write("from_driver", line); }
  /// What limber made of it.
  void note(std::string_view text);

 private:
  void write(const char* key, std::string_view line);

  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace limber
