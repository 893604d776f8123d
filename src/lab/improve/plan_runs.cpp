#include "plan_runs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "kernels/job_arena.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/random_environment.hpp"
#include "plan_chain.hpp"
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
    for (int first = 0; !is_enough();) {
      throw_if_interrupted();
      std::vector<Part> parts(static_cast<std::size_t>(at_once(first)));
      arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) {
          if (!interrupt_requested()) {
            parts[k] = part(first + static_cast<int>(k) * asked_.chain);
          }
        });
      });
      throw_if_interrupted();
      for (Part& one : parts) {
        if (!is_enough()) {
          take(std::move(one), first);
        }
        first += asked_.chain;
      }
      require_some_solved();
    }
    progress_.finish();
    join();
    return std::move(result_);
  }

 private:
  struct Part {
    PlanRuns runs;
    bool is_on_disk = false;
  };

  bool is_enough() const {
    return asked_.environments ? static_cast<int>(result_.runs.size()) >= *asked_.environments
                               : result_.arm_time_s >= asked_.arm_time_s;
  }

  double seconds_left() const {
    return asked_.environments ? std::numeric_limits<double>::infinity()
                               : asked_.arm_time_s - result_.arm_time_s;
  }

  int at_once(int done) const {
    if (!on_.side_by_side) {
      return 1;
    }
    return asked_.environments ? std::min(kSideBySide, *asked_.environments - done) : kSideBySide;
  }

  /// The chain whose environments begin with `first`: from disk, or now.
  Part part(int first) const {
    if (std::optional<PlanRuns> found = read_part(output_, asked_.name, first)) {
      return {std::move(*found), true};
    }
    return {plan_and_execute(first), false};
  }

  PlanRuns plan_and_execute(int first) const {
    PlanChain chain(settings_.arm, first, asked_.chain, seconds_left(),
                    [this](int number, const std::optional<ArmStart>& start) {
                      return planned(number, start);
                    });
    const PlannedRun* begun = chain.first_plan();
    if (begun == nullptr || interrupt_requested()) {
      return chain.ended({});
    }
    const ExecutionResult run =
        on_.execute(begun->environment, *begun->plan, asked_.chain > 1 ? &chain : nullptr);
    require_done(run, first);
    return chain.ended(run);
  }

  PlannedRun planned(int number, const std::optional<ArmStart>& start) const {
    PlannedRun result;
    result.run.environment = number;
    RandomEnvironmentSettings sampling;
    sampling.start = start;
    std::optional<RandomEnvironment> sampled = random_environment(
        settings_.arm, models_.sampling, asked_.seed, static_cast<std::uint64_t>(number), sampling);
    if (!sampled) {
      result.run.status = "no_environment";
      return result;
    }
    EnvironmentCase item{fmt::format("{}_{}", asked_.seed, number),
                         std::move(sampled->environment)};
    if (!start && on_.start) {
      item.environment.start = on_.start();  // not sampled with it: the same whatever it is
    }
    PlanTrialSettings planning;
    planning.limits.queries = settings_.queries;
    planning.within = on_.limits;
    planning.room = settings_.room;
    planning.model_hash = models_.planning_hash;
    PlanTrial trial = plan_trial(settings_.arm, models_.planning, item, planning,
                                 asked_.seed + static_cast<std::uint64_t>(number));
    result.run.status = to_string(trial.planning.status);
    result.environment = item.environment;
    result.plan = std::move(trial.planning.plan);
    return result;
  }

  void require_done(const ExecutionResult& run, int first) const {
    if (run.status == ExecutionStatus::done) {
      return;
    }
    keep_unfinished(run.episode, first);
    const std::string about = fmt::format(
        "{}, from environment {} on: {}; finished chains are kept, and the same command with "
        "--resume goes on from there",
        asked_.what, first, run.message);
    if (run.status == ExecutionStatus::fault) {
      throw SystemFault(about);
    }
    throw Interrupted(about);
  }

  /// A run that the arm or Ctrl-C ended is no result, but what was recorded stays.
  void keep_unfinished(const Episode& episode, int first) const {
    if (episode.frame_count() > 0) {
      std::string name = fmt::format("{}.unfinished_{:04}.h5", asked_.name, first);
      for (int again = 2; fs::exists(output_.path() / name); ++again) {
        name = fmt::format("{}.unfinished_{:04}_{}.h5", asked_.name, first, again);
      }
      write_episodes(settings_, on_, output_, name, {episode}, asked_.seed);
    }
  }

  /// Runs of the part at `first`, as far as they are still needed.
  void take(Part part, int first) {
    if (!part.is_on_disk) {
      write_plan_runs(settings_, on_, output_, part_name(asked_.name, first), part.runs,
                      asked_.seed);
    }
    int frames = 0;
    for (PlanRun& run : part.runs.runs) {
      if (is_enough()) {
        break;
      }
      result_.arm_time_s += run.duration_s;
      in_vain_ = run.executed ? 0 : in_vain_ + 1;
      frames += static_cast<int>(std::lround(run.duration_s / settings_.arm.frame_period_s()));
      result_.runs.push_back(std::move(run));
    }
    for (const Episode& episode : part.runs.episodes) {
      result_.episodes.push_back(slice(episode, 0, frames + 1));
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
    write_plan_runs(settings_, on_, output_, asked_.name, result_, asked_.seed);
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
