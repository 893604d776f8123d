#include "track_flags.hpp"

#include "limber/common/error.hpp"

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

}  // namespace limber
