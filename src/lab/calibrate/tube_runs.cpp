#include "limber/lab/tube_runs.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "binomial_bound.hpp"
#include "demo/demo_recipe.hpp"
#include "kernels/job_arena.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/statistics.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/tube_calibration.hpp"
#include "limber/lab/witnessed_environment.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

namespace {

constexpr int kBlock = 40;           // environments per file
constexpr int kHopeless = 160;       // environments, without runs in a tenth of them
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
  if (run.expected_error_m > 0.0) {
    json["expected_error_m"] = run.expected_error_m;
  }
  for (std::size_t g = 0; run.errors && g < kStartShares.size(); ++g) {
    const MotionErrors& errors = run.errors->of[g];
    json["errors"].push_back({{"start_share", kStartShares[g]},
                              {"plate_m", errors.plate_m},
                              {"end_m", errors.end_m},
                              {"end_heading_rad", errors.end_heading_rad},
                              {"tip_share", run.errors->tip_share[g]}});
  }
  return json;
}

GrowingErrors read_errors(const JsonReader& json, int plates) {
  const std::vector<JsonReader> rows = json.elements("a list of errors");
  json.refuse_if(rows.size() != kStartShares.size(), "{} found; expected {}", rows.size(),
                 kStartShares.size());
  GrowingErrors errors;
  for (std::size_t g = 0; g < rows.size(); ++g) {
    errors.of[g] = {rows[g].at("plate_m").numbers(std::size_t(plates), "distances in metres", 0.0),
                    rows[g].at("end_m").number(0.0), rows[g].at("end_heading_rad").number(0.0)};
    errors.tip_share[g] = rows[g].at("tip_share").number(0.0);
  }
  return errors;
}

/// @param plates  of the arm
TubeRun read_tube_run(const JsonReader& json, int plates) {
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
  if (json.has("expected_error_m")) {
    run.expected_error_m = json.at("expected_error_m").number(0.0);
  }
  if (json.has("errors")) {
    run.errors = read_errors(json.at("errors"), plates);
  }
  return run;
}

/// The model that carries the tube under test, at a level of its own.
/// @param width  of its tube beside the phase's
CompensationModel with_tube(CompensationModel model, const TubePhase& phase, double width) {
  model.tube.reset();
  if (phase.shape != nullptr) {
    model.tube = scaled(*phase.shape, width);
    model.tube->levels = {
        {.level = Tube::kDefaultLevel, .factor = phase.factor, .confidence = 0.5}};
  }
  return model;
}

/// What one run is made with: who plans, and who moves.
struct RunModel {
  RunModel(const ArmDescription& arm, ArmDescription executed, CompensationModel model,
           const ValveParameters& valves)
      : executed_arm(std::move(executed)),
        forward(arm, std::move(model)),
        motion(forward, ValveModel(arm, valves)) {}
  RunModel(const RunModel&) = delete;  // motion refers to forward
  RunModel& operator=(const RunModel&) = delete;

  ArmDescription executed_arm;
  ForwardModel forward;
  MotionModel motion;
  double expected_error_m = 0.0;
};

class PhaseRunner {
 public:
  PhaseRunner(const TubeRunSettings& settings, const TubePhase& phase, OutputFolder* folder)
      : settings_(settings),
        phase_(phase),
        folder_(folder),
        seed_(seed_of(phase.name, settings.seed)),
        block_size_(std::min(kBlock, phase.runs)) {
    trial_.limits = settings.limits;
    if (phase.shape != nullptr) {
      trial_.room.tube_level = Tube::kDefaultLevel;
    }
    if (!settings.unseen) {
      same_for_all_ =
          std::make_unique<RunModel>(settings.arm, settings.executed_arm,
                                     with_tube(settings.model, phase, 1.0), settings.valves);
    }
  }

  TubeRuns run() {
    Progress progress("calibrate, " + phase_.name, "runs", std::uint64_t(phase_.runs),
                      settings_.progress);
    TubeRuns result;
    for (int block = 0; result.executed() < phase_.runs; ++block) {
      if (is_hopeless(block, result.executed())) {
        require_may_fall_short(block, result.executed());
        return result;
      }
      const std::vector<TubeRun> more = runs_of(block);
      result.all.insert(result.all.end(), more.begin(), more.end());
      progress.update(std::uint64_t(std::min(result.executed(), phase_.runs)));
    }
    progress.finish();
    while (result.executed() > phase_.runs || !result.all.back().executed) {
      result.all.pop_back();
    }
    return result;
  }

 private:
  bool is_hopeless(int blocks, int executed) const {
    constexpr int kOneIn = 10;
    return blocks * block_size_ >= kHopeless && executed * kOneIn < blocks * block_size_;
  }

  void require_may_fall_short(int blocks, int executed) const {
    if (!phase_.may_fall_short) {
      throw TooFewPlans(fmt::format(
          "phase '{}': {} runs of {} environments; too few have a plan to calibrate anything. A "
          "tube of factor {:.3g} may be too wide for them, or the budget too small",
          phase_.name, executed, blocks * block_size_, phase_.factor));
    }
  }

  std::vector<TubeRun> runs_of(int block) {
    const std::string name = fmt::format("runs/{}.{:04}.json", phase_.name, block);
    if (folder_ != nullptr && fs::exists(folder_->path() / name)) {
      return read_block(folder_->path() / name);
    }
    std::vector<TubeRun> runs(block_size_);
    JobArena arena(settings_.jobs);
    arena.for_each(runs.size(), [&](std::size_t i) {
      if (!interrupt_requested()) {
        runs[i] = make_run(std::uint64_t(block) * runs.size() + i);
      }
    });
    throw_if_interrupted();
    if (folder_ != nullptr) {
      const auto list = mapped<Json>(runs, [&](const TubeRun& run) { return to_json(run); });
      folder_->write(name, Json{{"phase", phase_.name}, {"runs", list}}.dump() + "\n");
    }
    return runs;
  }

  std::vector<TubeRun> read_block(const fs::path& path) const {
    const nlohmann::json root = read_json_object(path);
    const JsonReader json(root, path.string());
    auto runs =
        mapped<TubeRun>(json.at("runs").elements("a list of runs"), [&](const JsonReader& run) {
          TubeRun found = read_tube_run(run, settings_.arm.point_count());
          run.refuse_if(found.executed && phase_.shape == nullptr && !found.errors,
                        "executed, without errors; expected those that give the tube its shape");
          return found;
        });
    if (json.at("phase").text() != phase_.name || runs.size() != std::size_t(block_size_)) {
      json.at("runs").refuse(
          fmt::format("{} runs found; expected {} of phase '{}': remove the file to run them again",
                      runs.size(), block_size_, phase_.name));
    }
    return runs;
  }

  std::unique_ptr<RunModel> adapted(std::uint64_t number) const {
    const bool keeps_measured_error = phase_.shape == nullptr;  // its plans keep that instead
    UnseenArm unseen = unseen_arm(settings_.arm, settings_.model, *settings_.unseen, seed_, number,
                                  keeps_measured_error);
    const double expected_m = unseen.adaptation.expected_error_m;
    const double width = phase_.expected_error_m > 0.0 ? expected_m / phase_.expected_error_m : 1.0;
    const CompensationModel& model = unseen.adaptation.model;
    auto result = std::make_unique<RunModel>(settings_.arm, std::move(unseen.arm),
                                             with_tube(model, phase_, width),
                                             model.identified_valves().parameters);
    result->expected_error_m = expected_m;
    return result;
  }

  TubeRun make_run(std::uint64_t number) const {
    return make_run(same_for_all_ ? *same_for_all_ : *adapted(number), number);
  }

  TubeRun make_run(const RunModel& with, std::uint64_t number) const {
    TubeRun run;
    run.number = number;
    run.expected_error_m = with.expected_error_m;
    std::optional<WitnessedEnvironment> sampled =
        witnessed_environment(with.executed_arm, virtual_witness(with.executed_arm), seed_, number);
    if (!sampled) {
      run.status = "no_environment";
      return run;
    }
    const EnvironmentCase item{std::to_string(number), std::move(sampled->environment)};
    PlanTrial trial = plan_trial(settings_.arm, with.motion, item, trial_, seed_ + number);
    run.status = to_string(trial.planning.status);
    if (trial.solved()) {
      execute_trial(with.executed_arm, item.environment, trial);
      note_execution(trial, with, run);
    }
    return run;
  }

  /// A run that collides goes on to its end: the virtual arm feels no obstacle.
  void note_execution(const PlanTrial& trial, const RunModel& with, TubeRun& run) const {
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
      const Tube& tube = *with.forward.compensation().tube;
      run.score = tube_score(plan, execution.episode, tube);
      run.tip_radius_m = mean_tip_radius_m(plan, tube, tube.levels.front());
    } else {
      run.errors = growing_errors(plan, execution.episode, settings_.arm.length_m());
    }
  }

  const TubeRunSettings& settings_;
  const TubePhase& phase_;
  OutputFolder* folder_;
  std::uint64_t seed_;
  int block_size_;
  PlanTrialSettings trial_;
  std::unique_ptr<RunModel> same_for_all_;  // null: each has its own
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

/// Of an arm that is expected to be off by `times` as much.
GrowingErrors scaled(GrowingErrors motion, double times) {
  for (MotionErrors& errors : motion.of) {
    for (double& error_m : errors.plate_m) {
      error_m *= times;
    }
    errors.end_m *= times;
    errors.end_heading_rad *= times;
  }
  return motion;
}

int count_of(const std::vector<TubeRun>& runs, bool TubeRun::*member) {
  return int(std::ranges::count(runs, true, member));
}

}  // namespace

int TubeRuns::executed() const {
  return count_of(all, &TubeRun::executed);
}

int TubeRuns::solved() const {
  return int(std::ranges::count(all, to_string(PlanStatus::solved), &TubeRun::status));
}

int TubeRuns::outside(double factor) const {
  return int(std::ranges::count_if(
      all, [&](const TubeRun& run) { return run.executed && !(run.score <= factor); }));
}

std::vector<double> TubeRuns::scores() const {
  return of_executed(all, &TubeRun::score);
}

std::vector<GrowingErrors> TubeRuns::errors() const {
  const double usual_m = expected_error_m();
  std::vector<GrowingErrors> result;
  for (const TubeRun& run : all) {
    if (run.errors) {
      const bool known = usual_m > 0.0 && run.expected_error_m > 0.0;
      result.push_back(scaled(*run.errors, known ? usual_m / run.expected_error_m : 1.0));
    }
  }
  return result;
}

double TubeRuns::expected_error_m() const {
  const std::vector<double> values = of_executed(all, &TubeRun::expected_error_m);
  return values.empty() ? 0.0 : median(values);
}

TubeRuns run_tube_phase(const TubeRunSettings& settings, const TubePhase& phase,
                        OutputFolder* folder) {
  return PhaseRunner(settings, phase, folder).run();
}

Json to_json(const TubeRuns& runs, double factor) {
  const int executed = runs.executed();
  const int outside = runs.outside(factor);
  const auto environments =
      std::ssize(runs.all) - std::ranges::count(runs.all, "no_environment", &TubeRun::status);
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
  if (const double expected_m = runs.expected_error_m(); expected_m > 0.0) {
    json["expected_error_cm_median"] = kCmPerM * expected_m;
  }
  json["mean_largest_tip_error_cm"] = kCmPerM * mean_of(runs.all, &TubeRun::tip_m);
  json["collided"] = count_of(runs.all, &TubeRun::collided);
  json["reached"] = count_of(runs.all, &TubeRun::reached);
  return json;
}

}  // namespace limber
