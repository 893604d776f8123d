#include "limber/run/track_run.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

constexpr double kTimeRounding_s = 1e-9;  // of differences between times of a long run

std::optional<TrackError> error_of(const std::vector<double>& distances_m) {
  if (distances_m.empty()) {
    return std::nullopt;
  }
  const double squares =
      std::inner_product(distances_m.begin(), distances_m.end(), distances_m.begin(), 0.0);
  const auto frames = int(distances_m.size());
  return TrackError{std::sqrt(squares / frames), std::ranges::max(distances_m), frames};
}

/// Empty if it was seen to its end, and struck nothing.
std::string why_not_followed(const ExecutionResult& result) {
  if (result.collided) {
    return "the arm collided on the way";
  }
  return result.final_backbone ? "" : "the arm was not seen at the end: collisions are unknown";
}

/// Distances between set points are counted in the limits' width.
void require_width(const ArmDescription& arm) {
  for (int i = 0; i < arm.channel_count(); ++i) {
    const PressureLimits& limits = arm.limits_of_channel(i);
    if (!(limits.half_width_kpa() > 0.0)) {
      throw InputError(
          fmt::format("{} has the limits {} {} in force, so nothing can move it; a path over time "
                      "needs every segment. The driver's hello may say more (limit_kpa)",
                      channel_name(arm, i), to_string(limits), arm.command.unit));
    }
  }
}

}  // namespace

TrackErrors track_errors(const TipPath& path, const Episode& episode, int start_frame) {
  std::vector<double> first_m;
  std::vector<double> later_m;
  for (int t = start_frame; t < episode.frame_count(); ++t) {
    const double since_s = episode.time_s[t] - episode.time_s[start_frame];
    if (!episode.was_tracked(t)) {
      continue;
    }
    const Eigen::Vector2d tip_m = tip_position_m(backbone_at(episode.backbone, t));
    const double distance_m = (tip_m - path.at(since_s)).norm();
    (since_s <= path.lap_s() + kTimeRounding_s ? first_m : later_m).push_back(distance_m);
  }
  return {error_of(first_m), error_of(later_m)};
}

TipTracker tracker_for(const ArmDescription& arm, const MotionModel& model, const TipPath& path,
                       const std::string& source, const TipTrackerSettings& settings,
                       std::uint64_t seed) {
  constexpr double kStartWithinM = 0.02;
  require_width(arm);
  const TrackStart start = find_track_start(arm, model, path, seed);
  if (start.distance_m > kStartWithinM) {
    throw InputError(
        path.source_of(source, 0) +
        fmt::format(
            ": the path starts at ({:.3f}, {:.3f}) m; the nearest that the model brings the "
            "tip is {:.1f} cm from there, at most {:.0f} cm are allowed. Move the path, or "
            "give the model it was made for",
            path.point_m.front().x(), path.point_m.front().y(), kCmPerM * start.distance_m,
            kCmPerM * kStartWithinM));
  }
  return {arm, model, path, start, settings, seed};
}

Plan stay_at_rest(const ArmDescription& arm, const Environment& environment) {
  const ArmStart rest = start_state(Environment{}, arm);
  Plan plan;
  plan.arm_name = arm.name;
  plan.arm_hash = arm.hash();
  plan.command = arm.command;
  plan.environment_name = environment.name;
  plan.environment_hash = environment_hash(environment);
  plan.frame_rate_hz = arm.frame_rate_hz;
  plan.waypoints_kpa = {rest.pressures_kpa};
  plan.frames = {{rest.pressures_kpa, rest.pressures_kpa, rest.backbone}};
  return plan;
}

TrackRun track_run(const TipPath& path, const TipTracker& tracker, ExecutionResult result) {
  TrackRun run;
  run.path = path;
  run.result = std::move(result);
  run.start_frame = tracker.path_start_frame();
  run.queries = tracker.queries();
  run.errors = track_errors(path, run.result.episode, run.start_frame + run.result.lag_frames);
  if (run.result.status == ExecutionStatus::done) {
    const std::string why = why_not_followed(run.result);  // there is no goal to miss
    run.result.message = why.empty() ? "" : why + run.result.hint;
  }
  return run;
}

}  // namespace limber
