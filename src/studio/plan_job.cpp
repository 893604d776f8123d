#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/json.hpp"
#include "limber/common/seconds_since.hpp"
#include "limber/common/units.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/report/plan_report.hpp"
#include "limber/run/safety_settings.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

constexpr std::size_t kMaxEdges = 5000;
constexpr double kDoubtAfterS = 0.4;  // without a plan: then it is said what may be in the way
constexpr double kBetweenPlansS = 0.25;
constexpr double kBetweenWordsS = 0.5;  // without a plan: each costs the search the browser's time
constexpr double kBetweenTreesS = 0.4;  // 5000 edges are 130 kB of text
constexpr double kDoubtForS = 0.3;

/// One search's events; its callbacks come from the planner's thread, which is the worker's.
class PlanReporter {
 public:
  PlanReporter(const PlanJob& job, const StudioScene& scene, const Environment& environment,
               const std::atomic<bool>& stop, EventQueue& events,
               const std::function<void(FoundPlan)>& found)
      : job_(job),
        scene_(scene),
        environment_(environment),
        stop_(stop),
        events_(events),
        found_(found) {}

  bool note(const PlannerProgress& progress) {
    bool is_due = progress.best_cost_kpa || now_s() > words_sent_s_ + kBetweenWordsS;
    if (!progress.best_cost_kpa && !doubted_ && progress.time_s > kDoubtAfterS) {
      doubted_ = is_due = true;
      doubt_ = doubt();
    }
    if (is_due) {
      send_words(progress);
    }
    if (job_.with_tree && now_s() > tree_sent_s_ + kBetweenTreesS) {
      tree_sent_s_ = now_s();
      events_.push("tree", Json{{"request", job_.request},
                                {"tree", tree_to_json(progress.tree(), kMaxEdges)}}
                               .dump());
    }
    if (better_ && now_s() > sent_s_ + kBetweenPlansS) {
      send(*std::exchange(better_, std::nullopt));
    }
    return !stop_;
  }

  /// The first one is shown at once. Searches find many better ones at first: then no more than an
  /// eye follows.
  void take(const Plan& plan) {
    if (plans_++ == 0) {
      first_s_ = now_s();
      send(plan);
    } else {
      better_ = plan;
    }
  }
  /// What is shown is what is kept.
  void send(const Plan& plan) {
    if (stop_) {
      return;
    }
    const double time_s = now_s();
    sent_s_ = time_s;
    Plan kept = plan;
    kept.model_hash = scene_.model_hash();
    found_({job_.request, job_.scene, environment_, std::move(kept)});
    Json json = plan_to_json(plan);
    json["request"] = job_.request;
    json["time_s"] = time_s;
    json["first_s"] = first_s_;
    events_.push("plan", json.dump());
  }

 private:
  void send_words(const PlannerProgress& progress) {
    words_sent_s_ = now_s();
    Json json = progress_to_json(progress);
    json["request"] = job_.request;
    json["doubt"] = doubt_;
    events_.push("progress", json.dump());
  }
  double now_s() const { return seconds_since(begin_); }
  /// What may be in the way, as far as the simple model tells; else what has not been found yet.
  std::string doubt() const {
    AskedRoom asked;
    asked.margin_m = job_.margin_m;
    const ErrorRoom room = error_room(scene_.motion().forward(), asked);
    const PlanningProblem problem =
        problem_with_room(scene_.arm(), scene_.motion(), environment_, room);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kDoubtForS);
    const std::string in_the_way =
        reached_only_in_collision(problem, checker_of(problem), job_.seed,
                                  [&] { return stop_ || std::chrono::steady_clock::now() > end; });
    return !in_the_way.empty()
               ? in_the_way
               : fmt::format(
                     "So far no motion that keeps {:.1f} cm clear ends in the goal; the "
                     "search goes on.",
                     kCmPerM * room.margin_m);
  }

  const PlanJob& job_;
  const StudioScene& scene_;
  const Environment& environment_;
  const std::atomic<bool>& stop_;
  EventQueue& events_;
  const std::function<void(FoundPlan)>& found_;
  std::optional<Plan> better_;  // than what was sent
  double sent_s_ = 0.0;
  double words_sent_s_ = 0.0;
  double tree_sent_s_ = 0.0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int plans_ = 0;
  double first_s_ = 0.0;
  bool doubted_ = false;
  std::string doubt_;
};

}  // namespace

void run_plan_job(const PlanJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                  EventQueue& events, const std::function<void(FoundPlan)>& found) {
  scene.require_one_arm();
  const Environment environment = environment_from_json(job.environment, scene.arm());
  PlanReporter reporter(job, scene, environment, stop, events, found);
  PlanSettings settings;
  settings.callback = [&](const PlannerProgress& progress) { return reporter.note(progress); };
  settings.on_plan = [&](const Plan& plan) { reporter.take(plan); };
  settings.room.margin_m = job.margin_m;
  settings.within = limits_of(with_scaled_limits(scene.arm(), job.limit_scale));
  PlannerLimits limits;
  limits.time_s = job.time_limit_s;
  const PlanResult result =
      limber::plan(scene.arm(), scene.motion(), environment, limits, job.seed, settings);
  if (stop) {
    return;
  }
  if (result.plan) {
    reporter.send(*result.plan);
  }
  Json json = to_json(result, scene.arm().command, environment.goal, "default",
                      scene.has_network() ? "network" : "no_load", job.seed);
  json["request"] = job.request;
  json["tree"] = job.with_tree ? tree_to_json(result.tree, kMaxEdges) : Json(nullptr);
  events.push("result", json.dump());
}

}  // namespace limber
