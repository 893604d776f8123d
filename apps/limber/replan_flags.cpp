#include "replan_flags.hpp"

#include "limber/common/error.hpp"

namespace limber {

void ReplanFlags::add_settings_to(CLI::App& app) {
  app.add_option(
         "--motion-queries", motion_queries_,
         fmt::format("With --replan: model queries of a search while the arm moves; 0: none "
                     "then. By default what {:.0f} ms take on this machine, and the results "
                     "say how many that were: pass it on to repeat a run",
                     1e3 * kMotionSearchS))
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1'000'000}));
  app.add_flag(
      "--adapt,!--no-adapt", settings_.adapts,
      "With --replan and a model that limber adapt made: which arm this is, is fitted again "
      "while it moves (by default) or left as it is");
}

void ReplanFlags::add_to(CLI::App& app) {
  app.add_flag("--replan", replan_,
               "Closed loop: plan again, with --model, from where the arm is measured, while it "
               "moves and after, until it is near the goal's centre or comes no nearer");
  add_settings_to(app);
  app.add_option("--max-replans", settings_.corrections.max_replans,
                 "With --replan: plans from rest, after the first")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--replan-queries", settings_.corrections.queries,
                 "Model queries of each search while the arm stands still")
      ->check(CLI::Range(std::uint64_t{100}, std::uint64_t{1'000'000'000}))
      ->capture_default_str();
  app.add_option("--blind-s", settings_.blind_s,
                 "With --replan: a moving arm that is not tracked for longer than that is stopped")
      ->check(CLI::Range(0.0, 60.0))
      ->capture_default_str();
}

void ReplanFlags::choose_motion_queries(const ArmDescription& arm, const MotionModel& model,
                                        std::optional<std::uint64_t> known,
                                        const CommonFlags& flags) {
  if (motion_queries_ || known) {
    settings_.motion_queries = motion_queries_ ? *motion_queries_ : *known;
    return;
  }
  settings_.motion_queries = queries_within(kMotionSearchS, arm, model);
  say(flags, "{:.0f} ms take {} queries here (--motion-queries)", 1e3 * kMotionSearchS,
      settings_.motion_queries);
}

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
