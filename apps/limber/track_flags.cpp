#include "track_flags.hpp"

#include "limber/common/error.hpp"
#include "limber/common/units.hpp"

namespace limber {

void TrackFlags::add_to(CLI::App& app) {
  app.add_option("--track", path_,
                 "In place of --plan: path of the tip over time to follow with --model, a CSV file "
                 "with the columns time_s, x_m and y_m");
  app.add_option("--laps", laps_, "With --track: how often a path that ends at its start is run")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--track-queries", settings_.queries, "With --track: model queries in each frame")
      ->check(CLI::Range(300, 10'000'000))
      ->capture_default_str();
}

void TrackFlags::prepare(const ArmDescription& arm, const ModelFlags& model,
                         const CommonFlags& flags) {
  tip_path_ = read_tip_path(path_);
  tip_path_.require_within(arm.length_m(), path_);
  if (laps_ > 1 && !tip_path_.closes()) {
    throw InputError(
        tip_path_.source_of(path_, tip_path_.point_m.size() - 1) +
        fmt::format(": ends {:.1f} mm from where the path starts; "
                    "--laps {} needs one that ends at its start, to 1 mm",
                    1000.0 * (tip_path_.point_m.back() - tip_path_.point_m.front()).norm(), laps_));
  }
  tip_path_.laps = laps_;
  forward_ = std::make_unique<ForwardModel>(model.planning_model(arm));
  motion_ = std::make_unique<MotionModel>(model.motion_model(arm, *forward_));
  model.warn_without_valves(*motion_, flags);
}

TrackStart TrackFlags::start_on(const ArmDescription& arm, const CommonFlags& flags) const {
  constexpr double kStartWithinM = 0.02;
  TrackStart start = find_track_start(arm, *motion_, tip_path_, flags.seed);
  if (start.distance_m > kStartWithinM) {
    throw InputError(
        tip_path_.source_of(path_, 0) +
        fmt::format(
            ": the path starts at ({:.3f}, {:.3f}) m; the nearest that the model brings the "
            "tip is {:.1f} cm from there, at most {:.0f} cm are allowed. Move the path, or "
            "give the model it was made for",
            tip_path_.point_m.front().x(), tip_path_.point_m.front().y(),
            kCmPerM * start.distance_m, kCmPerM * kStartWithinM));
  }
  return start;
}

std::string TrackFlags::why_not_followed(const ExecutionResult& result) {
  if (result.collided) {
    return "the arm collided on the way";
  }
  return result.final_backbone ? "" : "the arm was not seen at the end: collisions are unknown";
}

Plan TrackFlags::stay_at_rest(const ArmDescription& arm, const Environment& environment) {
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

}  // namespace limber
