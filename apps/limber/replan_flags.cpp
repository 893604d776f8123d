#include "replan_flags.hpp"

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

}  // namespace limber
