#include "jobs.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/report/plan_report.hpp"
#include "limber/run/safety_settings.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxEdges = 5000;
constexpr double kDoubtAfterS = 0.4;  // without a plan: then it is said what may be in the way
constexpr double kDoubtForS = 0.3;

/// One search's events; its callbacks come from the planner's thread, which is the worker's.
class PlanReporter {
 public:
  PlanReporter(const PlanJob& job, const StudioScene& scene, const Environment& environment,
               const std::atomic<bool>& stop, EventQueue& events)
      : job_(job), scene_(scene), environment_(environment), stop_(stop), events_(events) {}

  bool note(const PlannerProgress& progress) {
    if (!progress.best_cost_kpa && !doubted_ && progress.time_s > kDoubtAfterS) {
      doubted_ = true;
      doubt_ = doubt();
    }
    Json json = progress_to_json(progress);
    json["request"] = job_.request;
    json["doubt"] = doubt_;
    events_.push("progress", json.dump());
    return !stop_;
  }

  void send(const Plan& plan) {
    const double time_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    if (plans_++ == 0) {
      first_s_ = time_s;
    }
    Json json = plan_to_json(plan);
    json["request"] = job_.request;
    json["time_s"] = time_s;
    json["first_s"] = first_s_;
    if (!stop_) {
      events_.push("plan", json.dump());
    }
  }

 private:
  /// Whether the goal is only reached in collision, as far as the simple model tells.
  std::string doubt() const {
    const PlanningProblem problem = problem_with_room(scene_.arm(), scene_.motion(), environment_,
                                                      error_room(scene_.motion().forward()));
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kDoubtForS);
    return reached_only_in_collision(problem, checker_of(problem), job_.seed, [&] {
      return stop_ || std::chrono::steady_clock::now() > end;
    });
  }

  const PlanJob& job_;
  const StudioScene& scene_;
  const Environment& environment_;
  const std::atomic<bool>& stop_;
  EventQueue& events_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int plans_ = 0;
  double first_s_ = 0.0;
  bool doubted_ = false;
  std::string doubt_;
};

}  // namespace

void run_plan_job(const PlanJob& job, const StudioScene& scene, const std::atomic<bool>& stop,
                  EventQueue& events, const std::function<void(FoundPlan)>& found) {
  const Environment environment = environment_from_json(job.environment, scene.arm());
  PlanReporter reporter(job, scene, environment, stop, events);
  const auto keep = [&](const Plan& plan) {
    Plan kept = plan;
    kept.model_hash = scene.model_hash();
    found({job.scene, environment, std::move(kept)});
    reporter.send(plan);
  };
  PlanSettings settings;
  settings.callback = [&](const PlannerProgress& progress) { return reporter.note(progress); };
  settings.on_plan = keep;
  settings.within = limits_of(with_scaled_limits(scene.arm(), job.limit_scale));
  PlannerLimits limits;
  limits.time_s = job.time_limit_s;
  const PlanResult result =
      limber::plan(scene.arm(), scene.motion(), environment, limits, job.seed, settings);
  if (stop) {
    return;
  }
  if (result.plan) {
    keep(*result.plan);
  }
  Json json = to_json(result, scene.arm().command, environment.goal, "default",
                      scene.has_network() ? "network" : "no_load", job.seed);
  json["request"] = job.request;
  json["tree"] = job.with_tree ? tree_to_json(result.tree, kMaxEdges) : Json(nullptr);
  events.push("result", json.dump());
}

}  // namespace limber
