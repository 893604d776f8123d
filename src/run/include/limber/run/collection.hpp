#pragma once
// For those who move an arm, real or virtual.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "limber/arm/arm_description.hpp"
#include "limber/common/progress.hpp"
#include "limber/data/recording.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/schedule.hpp"

namespace limber {

/// In a recording's `source`, before who started the driver. Where a collection goes on, it may be
/// somebody else: what lies before it has to be the same.
inline constexpr std::string_view kStartedBy = ", started by ";

/// A fresh arm at rest for episode `index`. Its random numbers depend on the index alone, never on
/// the caller or the time. Called from several threads at once.
using DriverFactory = std::function<std::unique_ptr<ArmDriver>(int index)>;

struct CollectionSettings {
  ScheduleSettings schedule;
  /// Made elsewhere, in place of what `schedule` would make of its kind and counts: what it is, in
  /// words, as in `Recording::settings`. Empty: it is made here.
  std::vector<EpisodeSchedule> episodes = {};
  std::string episodes_are = {};
  std::uint64_t seed = 1;
  std::string source = "virtual arm";
  std::string driver;  ///< everything else that decides the data (noise, parameters), in words
  double hold_limit_s = 15.0;  ///< a set point not reached by then is a fault; ≥ hold_s
  int jobs = 0;                ///< threads, 0: one per core; never changes a result
  bool resume = false;         ///< go on from the parts of an interrupted run
  bool force = false;          ///< replace the file, and (unless `resume`) the parts
  /// Where the arm fails or the run is stopped, this recording gets the finished episodes and the
  /// frames of the unfinished one. Empty: they are not kept. Asks for `jobs` = 1.
  std::filesystem::path partial;
  /// What Episode::physics is to say of episode `index`. Empty: nothing.
  std::function<std::string(int index)> physics = {};
  Progress::Mode progress = Progress::Mode::automatic;
  /// Asked before every set point, from several threads at once; true stops the collection as
  /// Ctrl-C does. Empty: never.
  std::function<bool()> should_stop = {};
};

struct CollectionResult {
  Recording recording;
  int kept_episodes = 0;          ///< found finished by `resume`
  std::size_t foreign_files = 0;  ///< left in `path`.parts, because collect did not make them
  double wall_time_s = 0.0;       ///< of this run
};

/// One unbroken run: leads the arm to the schedule's first configuration (unrecorded), then records
/// from there. Frame 0 is the arm before the first motion, at the set point that it was led to.
/// @throws SystemFault if a set point is not reached within `hold_limit_s`, or the arm fails.
/// The arm is vented in every case.
Episode record_episode(const ArmDescription& arm, ArmDriver& driver,
                       const EpisodeSchedule& schedule, const CollectionSettings& settings,
                       const std::function<void()>& motion_done = {});

/// Runs a whole schedule and writes it to `path`. Each finished episode is kept in
/// `path`.parts/NNNNNN.h5 until all are joined and the file was read back; then they are removed.
/// With `resume`, a file that is whole already is returned, and parts that equal it are removed.
/// @throws Interrupted after Ctrl-C, saying how to go on; the parts are valid.
/// @throws InputError if `path` exists, or parts of an earlier run are there and neither
/// `resume` nor `force` is set, or they are of other settings (which is named).
CollectionResult collect(const ArmDescription& arm, const CollectionSettings& settings,
                         const DriverFactory& make_driver, const std::filesystem::path& path);

}  // namespace limber
