#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/report/motion_track.hpp"
#include "limber/report/scene_json.hpp"
#include "limber/run/track_run.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

std::string outcome_of(const TrackRun& run) {
  const std::optional<TrackError>& error = run.errors.first_lap;
  const std::string off = error ? fmt::format("off the path by {:.2f} cm (RMS), at most {:.2f} cm",
                                              kCmPerM * error->rms_m, kCmPerM * error->max_m)
                                : "was not seen on the path";
  return run.result.message.empty() ? off : off + "; " + run.result.message;
}

/// Where the tip is to be in each frame: first at the path's start.
Json wanted_tips(const TrackRun& run, double frame_rate_hz) {
  Json json = Json::array();
  for (int k = 0; k < run.result.episode.frame_count(); ++k) {
    const Eigen::Vector2d point = run.path.at((k - run.start_frame) / frame_rate_hz);
    json.push_back({length_to_json(point.x()), length_to_json(point.y())});
  }
  return json;
}

}  // namespace

TipPath tip_path_in(const JsonReader& body) {
  constexpr std::size_t kMaxPoints = 2000;
  constexpr std::size_t kNumbers = 3;  // of a point: time_s, x_m, y_m
  constexpr double kLongestS = 120.0;
  constexpr double kFarthestM = 100.0;  // require_within() is about the arm
  const std::vector<double> numbers =
      body.at("path").numbers(std::string::npos, "s, m, m", -kFarthestM, kLongestS);
  const std::size_t points = numbers.size() / kNumbers;
  refuse_if(numbers.size() % kNumbers != 0 || points < 2 || points > kMaxPoints,
            "path: {} numbers; expected time_s, x_m and y_m of 2 to {} points", numbers.size(),
            kMaxPoints);
  TipPath path;
  for (std::size_t i = 0; i < points; ++i) {
    const double* point = &numbers[kNumbers * i];
    if (i == 0 ? point[0] != 0.0 : !(point[0] > path.time_s.back())) {
      throw InputError(fmt::format(
          "path: point {} has time_s = {}; expected 0 for the first, and later for each next one",
          i, point[0]));
    }
    path.time_s.push_back(point[0]);
    path.point_m.emplace_back(point[1], point[2]);
    path.line.push_back(i);
  }
  return path;
}

void run_follow_job(const FollowJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                    EventQueue& events) {
  scene.require_one_arm();
  refuse_if(!scene.has_virtual_arm(),
            "paths are followed by the virtual arm, which there is for arms driven by "
            "pressures alone");
  const ArmDescription& arm = scene.arm();
  const Environment environment = environment_from_json(job.environment, arm);
  job.path.require_within(arm.length_m(), "path");
  ExecutionSettings execution;
  execution.should_stop = [&stop] { return stop.load(); };
  VirtualArm driver(arm);
  const TrackRun run = follow_path(arm, scene.motion(), job.path, "path", environment, driver,
                                   TipTrackerSettings{}, execution, 1);
  MotionTrack track = executed_track("virtual_arm", arm, environment, run.result);
  track.set_outcome(outcome_of(run));
  const Json json = {{"request", job.request},
                     {"frame_rate_hz", arm.frame_rate_hz},
                     {"appeared", nullptr},
                     {"setpoints_kpa", rows_to_json(run.result.episode.setpoint_kpa)},
                     {"wanted_m", wanted_tips(run, arm.frame_rate_hz)},
                     {"path_starts_s", run.start_frame / arm.frame_rate_hz},
                     {"tracks", {track.json()}}};
  if (!stop) {
    events.push("followed", json.dump());
  }
}

}  // namespace limber
