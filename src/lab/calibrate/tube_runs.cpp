#include "limber/lab/tube_runs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "binomial_bound.hpp"
#include "demo/demo_recipe.hpp"
#include "kernels/job_arena.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/random_environment.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kBlock = 40;           // environments per file
constexpr int kHopelessBlocks = 4;   // without runs in a tenth of their environments
constexpr double kInterval = 0.975;  // one side of a 95 % interval

/// The same name has the same seed, whatever the order of the phases.
std::uint64_t seed_of(const std::string& phase, std::uint64_t seed) {
  std::uint64_t index = 1469598103934665603ULL;  // FNV-1a
  for (const char c : phase) {
    index = (index ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return derived_seed(seed, index);
}

Json to_json(const TubeRun& run) {
  Json json = {{"number", run.number},     {"status", run.status},
               {"executed", run.executed}, {"score", run.score},
               {"cost", run.cost_kpa},     {"first_solution_s", run.first_solution_s},
               {"tip_m", run.tip_m},       {"tip_radius_m", run.tip_radius_m},
               {"collided", run.collided}, {"reached", run.reached}};
  if (run.errors) {
    json["plate_m"] = run.errors->plate_m;
    json["end_m"] = run.errors->end_m;
    json["end_heading_rad"] = run.errors->end_heading_rad;
  }
  return json;
}

TubeRun read_tube_run(const JsonReader& json) {
  TubeRun run;
  run.number = json.at("number").count(std::uint64_t{1} << 53U);
  run.status = json.at("status").text();
  run.executed = json.at("executed").boolean();
  run.score = json.at("score").number(0.0);
  run.cost_kpa = json.at("cost").number(0.0);
  run.first_solution_s = json.at("first_solution_s").number(0.0);
  run.tip_m = json.at("tip_m").number(0.0);
  run.tip_radius_m = json.at("tip_radius_m").number(0.0);
  run.collided = json.at("collided").boolean();
  run.reached = json.at("reached").boolean();
  if (json.has("plate_m")) {
    constexpr std::size_t kAny = std::string::npos;
    run.errors = MotionErrors{json.at("plate_m").numbers(kAny, "distances in metres", 0.0),
                              json.at("end_m").number(0.0), json.at("end_heading_rad").number(0.0)};
  }
  return run;
}

/// The model that carries the tube under test, at a level of its own.
CompensationModel with_tube(CompensationModel model, const TubePhase& phase) {
  model.tube.reset();
  if (phase.shape != nullptr) {
    model.tube = *phase.shape;
    TubeLevel level;
    level.level = Tube::kDefaultLevel;
    level.factor = phase.factor;
    level.confidence = 0.5;
    model.tube->levels = {level};
  }
  return model;
}

class PhaseRunner {
 public:
  PhaseRunner(const TubeRunSettings& settings, const TubePhase& phase, OutputFolder* folder)
      : settings_(settings),
        phase_(phase),
        folder_(folder),
        forward_(settings.arm, with_tube(settings.model, phase)),
        model_(forward_, ValveModel(settings.arm, settings.valves)),
        seed_(seed_of(phase.name, settings.seed)),
        block_size_(std::min(kBlock, phase.runs)) {
    trial_.limits = settings.limits;
    if (phase.shape != nullptr) {
      trial_.room.tube_level = Tube::kDefaultLevel;
    }
  }

  TubeRuns run() {
    Progress progress("calibrate, " + phase_.name, "runs", static_cast<std::uint64_t>(phase_.runs),
                      settings_.progress);
    TubeRuns result;
    for (int block = 0; result.executed() < phase_.runs; ++block) {
      if (is_hopeless(block, result.executed())) {
        require_may_fall_short(block, result.executed());
        return result;
      }
      const std::vector<TubeRun> more = runs_of(block);
      result.all.insert(result.all.end(), more.begin(), more.end());
      progress.update(static_cast<std::uint64_t>(std::min(result.executed(), phase_.runs)));
    }
    progress.finish();
    while (result.executed() > phase_.runs || !result.all.back().executed) {
      result.all.pop_back();
    }
    return result;
  }

 private:
  std::string file_of(int block) const {
    return fmt::format("runs/{}.{:04}.json", phase_.name, block);
  }

  bool is_hopeless(int blocks, int executed) const {
    constexpr int kOneIn = 10;
    return blocks >= kHopelessBlocks && executed * kOneIn < blocks * block_size_;
  }

  void require_may_fall_short(int blocks, int executed) const {
    if (!phase_.may_fall_short) {
      throw InputError(fmt::format(
          "phase '{}': {} runs of {} environments; too few have a plan to calibrate anything. A "
          "tube of factor {:.3g} may be too wide for them, or the budget too small",
          phase_.name, executed, blocks * block_size_, phase_.factor));
    }
  }

  std::vector<TubeRun> runs_of(int block) {
    const std::string name = file_of(block);
    if (folder_ != nullptr && std::filesystem::exists(folder_->path() / name)) {
      return read_block(folder_->path() / name);
    }
    std::vector<TubeRun> runs(static_cast<std::size_t>(block_size_));
    JobArena arena(settings_.jobs);
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
        if (!interrupt_requested()) {
          runs[i] = make_run(static_cast<std::uint64_t>(block) * runs.size() + i);
        }
      });
    });
    throw_if_interrupted();
    if (folder_ != nullptr) {
      Json list = Json::array();
      for (const TubeRun& run : runs) {
        list.push_back(to_json(run));
      }
      folder_->write(name, Json{{"phase", phase_.name}, {"runs", list}}.dump() + "\n");
    }
    return runs;
  }

  std::vector<TubeRun> read_block(const std::filesystem::path& path) const {
    const nlohmann::json root = read_json_object(path);
    const JsonReader json(root, path.string());
    std::vector<TubeRun> runs;
    for (const JsonReader& run : json.at("runs").elements("a list of runs")) {
      runs.push_back(read_tube_run(run));
    }
    if (json.at("phase").text() != phase_.name ||
        runs.size() != static_cast<std::size_t>(block_size_)) {
      json.at("runs").refuse(
          fmt::format("{} runs found; expected {} of phase '{}': remove the "
                      "file to run them again",
                      runs.size(), block_size_, phase_.name));
    }
    return runs;
  }

  TubeRun make_run(std::uint64_t number) const {
    TubeRun run;
    run.number = number;
    const std::optional<RandomEnvironment> sampled =
        random_environment(settings_.arm, model_, seed_, number);
    if (!sampled) {
      run.status = "no_environment";
      return run;
    }
    const EnvironmentCase item{std::to_string(number), sampled->environment};
    PlanTrial trial = plan_trial(settings_.arm, model_, item, trial_, seed_ + number);
    run.status = to_string(trial.planning.status);
    if (trial.solved()) {
      execute_trial(settings_.executed_arm, item.environment, trial);
      note_execution(trial, run);
    }
    return run;
  }

  /// A run that collides goes on to its end: the virtual arm feels no obstacle.
  void note_execution(const PlanTrial& trial, TubeRun& run) const {
    const Plan& plan = *trial.planning.plan;
    const ExecutionResult& execution = *trial.execution;
    run.cost_kpa = plan.cost_kpa;
    run.first_solution_s = trial.planning.first_solution->time_s;
    if (execution.status != ExecutionStatus::done) {
      return;
    }
    run.executed = true;
    run.collided = execution.collided;
    run.reached = has_arrived(execution);
    run.tip_m = motion_errors(plan, execution.episode).plate_m.back();
    if (phase_.shape != nullptr) {
      run.score = tube_score(plan, execution.episode, *phase_.shape);
      const Tube& tube = *forward_.compensation().tube;
      run.tip_radius_m = mean_tip_radius_m(plan, tube, tube.levels.front());
    } else {
      run.errors = motion_errors(plan, execution.episode, usual_growth(settings_.arm.length_m()));
    }
  }

  const TubeRunSettings& settings_;
  const TubePhase& phase_;
  OutputFolder* folder_;
  ForwardModel forward_;
  MotionModel model_;
  std::uint64_t seed_;
  int block_size_;
  PlanTrialSettings trial_;
};

std::vector<double> of_executed(const std::vector<TubeRun>& runs, double TubeRun::*member) {
  std::vector<double> values;
  for (const TubeRun& run : runs) {
    if (run.executed) {
      values.push_back(run.*member);
    }
  }
  return values;
}

double mean_of(const std::vector<TubeRun>& runs, double TubeRun::*member) {
  const std::vector<double> values = of_executed(runs, member);
  return values.empty() ? 0.0 : mean(values);
}

int count_of(const std::vector<TubeRun>& runs, bool TubeRun::*member) {
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [&](const TubeRun& run) { return run.*member; }));
}

}  // namespace

int TubeRuns::executed() const {
  return count_of(all, &TubeRun::executed);
}

int TubeRuns::solved() const {
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const TubeRun& run) {
    return run.status == to_string(PlanStatus::solved);
  }));
}

int TubeRuns::outside(double factor) const {
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const TubeRun& run) {
    return run.executed && !(run.score <= factor);
  }));
}

std::vector<MotionErrors> TubeRuns::errors() const {
  std::vector<MotionErrors> result;
  for (const TubeRun& run : all) {
    if (run.errors) {
      result.push_back(*run.errors);
    }
  }
  return result;
}

TubeRuns run_tube_phase(const TubeRunSettings& settings, const TubePhase& phase,
                        OutputFolder* folder) {
  return PhaseRunner(settings, phase, folder).run();
}

Json to_json(const TubeRuns& runs, double factor) {
  const int executed = runs.executed();
  const int outside = runs.outside(factor);
  const auto environments = std::count_if(runs.all.begin(), runs.all.end(), [](const TubeRun& run) {
    return run.status != "no_environment";
  });
  Json json = {{"environments", environments},
               {"solved", runs.solved()},
               {"runs", executed},
               {"outside", outside}};
  json["coverage"] = {{"share", executed > 0 ? 1.0 - double(outside) / executed : 0.0},
                      {"low", 1.0 - share_at_most(outside, executed, kInterval)},
                      {"high", 1.0 - share_at_least(outside, executed, kInterval)}};
  json["cost"] = mean_of(runs.all, &TubeRun::cost_kpa);
  const std::vector<double> first_s = of_executed(runs.all, &TubeRun::first_solution_s);
  json["first_solution_s_median"] = first_s.empty() ? 0.0 : median(first_s);
  json["mean_tip_radius_cm"] = kCmPerM * mean_of(runs.all, &TubeRun::tip_radius_m);
  json["mean_largest_tip_error_cm"] = kCmPerM * mean_of(runs.all, &TubeRun::tip_m);
  json["collided"] = count_of(runs.all, &TubeRun::collided);
  json["reached"] = count_of(runs.all, &TubeRun::reached);
  return json;
}

}  // namespace limber
