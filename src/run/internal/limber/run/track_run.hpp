#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "limber/data/recording.hpp"
#include "limber/run/executor.hpp"
#include "limber/run/tip_path.hpp"
#include "limber/run/tip_tracker.hpp"

namespace limber {

/// How far the tip was from where the path had it at the same time.
struct TrackError {
  double rms_m = 0.0;
  double max_m = 0.0;
  int frames = 0;
};

struct TrackErrors {
  std::optional<TrackError> first_lap;   ///< none if no frame of it was tracked
  std::optional<TrackError> later_laps;  ///< all but the first; none of a single lap
};

/// Of a run whose frame `start_frame` is the path's time 0. Frames that were not tracked do not
/// count.
TrackErrors track_errors(const TipPath& path, const Episode& episode, int start_frame);

/// A tip path that an arm was asked to follow, and what came of it.
struct TrackRun {
  TipPath path;
  ExecutionResult result;
  int start_frame = 0;  ///< of the run, where the path's time is 0
  TrackErrors errors;
  std::uint64_t queries = 0;
};

/// What leads the tip along a path. @param source  of the path, for messages
/// @throws InputError naming the first point, if the model brings the tip nowhere near it, or a
/// segment whose limits leave it nothing.
TipTracker tracker_for(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
                       const std::string& source, const TipTrackerSettings& settings,
                       std::uint64_t seed);
/// A plan of one frame, at rest: a controller decides all others.
Plan stay_at_rest(const ArmDescription& arm, const Environment& environment);
TrackRun track_run(const TipPath& path, const TipTracker& tracker, ExecutionResult result);

/// Brings the tip to the path's start, and follows it from there.
/// @param execution  its controller is replaced
/// @throws InputError as `tracker_for` does.
template <class Driver>
TrackRun follow_path(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
                     const std::string& source, const Environment& environment, Driver& driver,
                     const TipTrackerSettings& settings, ExecutionSettings execution,
                     std::uint64_t seed) {
  TipTracker tracker = tracker_for(arm, model, path, source, settings, seed);
  execution.controller = &tracker;
  if constexpr (requires { driver.look(); }) {
    driver.look();  // since it was started, the way to the path was searched for
  }
  return track_run(path, tracker,
                   execute(arm, environment, stay_at_rest(arm, environment), driver, execution));
}

}  // namespace limber
