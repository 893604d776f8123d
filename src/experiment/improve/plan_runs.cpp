#include "plan_runs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "kernels/job_arena.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/trial/plan_trial.hpp"
#include "limber/trial/random_environment.hpp"
#include "plan_run_file.hpp"

namespace limber {

namespace fs = std::filesystem;

namespace {

constexpr int kSideBySide = 8;   // at once on a virtual arm; fixed, so that jobs decide nothing
constexpr int kMaxInVain = 100;  // environments in a row without an executed plan

class Batch {
 public:
  Batch(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
        const PlanRunsModels& models, const PlanRunsSettings& asked)
      : settings_(settings),
        on_(on),
        output_(output),
        models_(models),
        asked_(asked),
        progress_(
            asked.what, asked.environments ? "environments" : "s of arm time",
            std::uint64_t(asked.environments ? *asked.environments : std::lround(asked.arm_time_s)),
            settings.progress) {}

  PlanRuns run() {
    JobArena arena(settings_.jobs);
    while (!is_enough()) {
      throw_if_interrupted();
      const int first = static_cast<int>(result_.runs.size());
      const int together = at_once(first);
      std::vector<PlanRunPart> parts(static_cast<std::size_t>(together));
      arena.execute([&] {
        tbb::parallel_for(0, together, [&](int k) {
          if (!interrupt_requested()) {
            parts[static_cast<std::size_t>(k)] = part(first + k);
          }
        });
      });
      throw_if_interrupted();
      for (PlanRunPart& one : parts) {
        if (!is_enough()) {
          take(std::move(one));
        }
      }
      require_some_solved();
    }
    progress_.finish();
    join();
    return std::move(result_);
  }

 private:
  std::string part_name(int number) const { return limber::part_name(asked_.name, number); }

  bool is_enough() const {
    return asked_.environments ? static_cast<int>(result_.runs.size()) >= *asked_.environments
                               : result_.arm_time_s >= asked_.arm_time_s;
  }

  int at_once(int done) const {
    if (!on_.side_by_side) {
      return 1;
    }
    return asked_.environments ? std::min(kSideBySide, *asked_.environments - done) : kSideBySide;
  }

  /// The run in environment `number`: from disk, or now.
  PlanRunPart part(int number) const {
    if (std::optional<PlanRunPart> found = read_part(output_.path(), part_name(number), number)) {
      found->is_on_disk = true;
      return std::move(*found);
    }
    return plan_and_execute(number);
  }

  PlanRunPart plan_and_execute(int number) const {
    PlanRunPart part;
    part.run.environment = number;
    std::optional<RandomEnvironment> sampled = random_environment(
        settings_.arm, models_.sampling, asked_.seed, static_cast<std::uint64_t>(number));
    if (!sampled) {
      part.run.status = "no_environment";
      return part;
    }
    EnvironmentCase item{fmt::format("{}_{}", asked_.seed, number),
                         std::move(sampled->environment)};
    if (on_.start) {
      item.environment.start = on_.start();
    }
    PlanTrialSettings planning;
    planning.limits.queries = settings_.queries;
    planning.within = on_.limits;
    planning.room = settings_.room;
    planning.model_hash = models_.planning_hash;
    const PlanTrial trial = plan_trial(settings_.arm, models_.planning, item, planning,
                                       asked_.seed + static_cast<std::uint64_t>(number));
    part.run.status = to_string(trial.planning.status);
    if (!trial.planning.plan || interrupt_requested()) {
      return part;
    }
    const ExecutionResult run = on_.execute(item.environment, *trial.planning.plan);
    note(run, part);
    return part;
  }

  void note(const ExecutionResult& run, PlanRunPart& part) const {
    part.run.executed = run.status == ExecutionStatus::done;
    part.run.collided = run.collided;
    part.run.arrived = run.goal_reached && !run.collided;
    part.run.duration_s = run.frames * settings_.arm.frame_period_s();
    if (part.run.executed && run.final_backbone) {
      part.run.distance_m = run.goal_error.position_m;
    }
    if (run.episode.frame_count() > 0) {
      part.episode = run.episode;
    }
    if (run.status == ExecutionStatus::done) {
      return;
    }
    keep_unfinished(part);
    if (run.status == ExecutionStatus::fault) {
      throw SystemFault(
          fmt::format("{}, environment {}: {}. Finished runs are kept; the same "
                      "command with --resume goes on from there",
                      asked_.what, part.run.environment, run.message));
    }
    throw Interrupted(
        fmt::format("{}, environment {}: {}; finished runs are kept, and the same "
                    "command with --resume goes on from there",
                    asked_.what, part.run.environment, run.message));
  }

  /// A run that the arm or Ctrl-C ended is no result, but what was recorded stays.
  void keep_unfinished(const PlanRunPart& part) const {
    if (part.episode) {
      const std::string name =
          fmt::format("{}.unfinished_{:04}.h5", asked_.name, part.run.environment);
      write_episodes(settings_, on_, output_, name, {*part.episode}, asked_.seed);
    }
  }

  void take(PlanRunPart part) {
    if (!part.is_on_disk) {
      write_part(settings_, on_, output_, part_name(part.run.environment), part, asked_.seed);
    }
    result_.arm_time_s += part.run.duration_s;
    in_vain_ = part.run.executed ? 0 : in_vain_ + 1;
    result_.runs.push_back(part.run);
    if (part.run.executed && part.episode) {
      result_.episodes.push_back(std::move(*part.episode));
    }
    progress_.update(asked_.environments ? result_.runs.size() : std::uint64_t(result_.arm_time_s));
  }

  void require_some_solved() const {
    if (in_vain_ >= kMaxInVain) {
      throw InputError(
          fmt::format("{}: {} environments in a row gave no plan that could be executed (the "
                      "last: {}). The model's error leaves no room beside obstacles: --margin-m "
                      "0.01 --goal-margin-m 0.01 asks for less, --max-queries for a longer search",
                      asked_.what, in_vain_, result_.runs.back().status));
    }
  }

  void join() const {
    write_joined(settings_, on_, output_, asked_.name, result_, asked_.seed);
    remove_parts(output_, asked_.name, result_);
  }

  const ImproveSettings& settings_;
  const ImproveArm& on_;
  OutputFolder& output_;
  const PlanRunsModels& models_;
  const PlanRunsSettings& asked_;
  Progress progress_;
  PlanRuns result_;
  int in_vain_ = 0;
};

}  // namespace

PlanRuns run_plans(const ImproveSettings& settings, const ImproveArm& on, OutputFolder& output,
                   const PlanRunsModels& models, const PlanRunsSettings& asked) {
  if (fs::exists(output.path() / (asked.name + ".json"))) {
    list_joined(output, asked.name);
    PlanRuns runs = read_plan_runs(output, asked.name);
    remove_parts(output, asked.name, runs);  // left where a run was killed right after joining
    return runs;
  }
  return Batch(settings, on, output, models, asked).run();
}

}  // namespace limber
