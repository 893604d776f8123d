#include "limber/lab/planning_experiment.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "demo/demo_recipe.hpp"
#include "experiment_results.hpp"
#include "kernels/job_arena.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/version.hpp"
#include "limber/lab/output_folder.hpp"
#include "limber/lab/trial_run.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "trial_file.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kTrialSeed = 128;  // as the demo's plans
constexpr const char* kExperimentFile = "experiment.json";

/// "ompl:SST,frames=5" → "ompl-SST-frames-5".
std::string as_file_name(std::string text) {
  for (char& c : text) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
  }
  return text;
}

/// Planner, controller and disturbance in a file's name; the usual ones are left out.
std::string way_of(const TrialKey& key) {
  std::string name = as_file_name(key.planner);
  if (key.controller != "open") {
    name += "_" + as_file_name(key.controller);
  }
  return key.disturbance.empty() ? name : name + "_" + as_file_name(key.disturbance);
}

struct Task {
  const EnvironmentCase* environment;
  const MotionModel* model;
  TrialKey key;
};

class Experiment {
 public:
  explicit Experiment(const ExperimentSettings& settings)
      : settings_(settings),
        model_bytes_hash_(file_hash(settings.model_file)),
        no_load_forward_(settings.arm),
        network_forward_(settings.arm, read_model_of_one_arm(settings.model_file, settings.arm)),
        no_load_(no_load_forward_, ValveModel(settings.arm, settings.valves)),
        network_(network_forward_, ValveModel(settings.arm, settings.valves)),
        identity_(experiment_identity(settings, model_bytes_hash_)),
        part_identity_(identity_) {
    part_identity_["environments"] = Json::object();
  }

  Json run() {
    prepare_folder();
    if (settings_.parts.empty()) {
      run_tasks();
    }
    if (interrupt_requested()) {
      throw Interrupted("stopped on request; the same command with --resume runs what is missing");
    }
    return write_results();
  }

 private:
  fs::path file(const std::string& name) const { return settings_.folder / name; }

  void prepare_folder() {
    const bool resumes = settings_.resume && fs::exists(file(kExperimentFile));
    if (resumes) {
      Json wanted = identity_;
      if (replans() && known_motion_queries(settings_)) {
        wanted["motion_queries"] = settings_.motion_queries;
      }
      require_same_experiment(file(kExperimentFile), wanted);
    }
    output_.emplace(settings_.folder, "experiment", OutputFolder::start(resumes, settings_.force),
                    std::vector<fs::path>{settings_.model_file});
    if (!output_->left().empty()) {
      settings_.say(output_->about_left());
    }
    output_->require_free(names_to_write());
    if (!resumes || adds_replanning()) {
      Json written = identity_;
      if (replans()) {
        written["motion_queries"] = settings_.motion_queries;
      }
      written["program_version"] = version();
      output_->write(kExperimentFile, written.dump(1) + "\n");
    }
  }

  bool replans() const {
    return std::ranges::find(settings_.controllers, "replan") != settings_.controllers.end();
  }
  /// Whether the experiment that is resumed had no closed loop so far.
  bool adds_replanning() const { return replans() && !known_motion_queries(settings_); }

  /// What a trial is one of: trials in closed loop depend on its budget too. Those of a part are of
  /// an experiment in their environment alone.
  std::string hash_for(const std::string& controller, const EnvironmentCase& item) const {
    Json identity = settings_.parts.empty() ? identity_ : part_identity_;
    if (!settings_.parts.empty()) {
      identity["environments"][item.id] = environment_hash(item.environment);
    }
    return content_hash(controller == "replan"
                            ? fmt::format("{} {}", identity.dump(), settings_.motion_queries)
                            : identity.dump());
  }

  /// Where the trials of an environment lie.
  const fs::path& folder_of(const EnvironmentCase& item) const {
    return settings_.parts.empty() ? settings_.folder
                                   : settings_.parts[&item - settings_.environments.data()];
  }

  /// Finished trials are only read.
  std::vector<std::string> names_to_write() const {
    std::vector<std::string> names{"table.json", "table.md", "runs.json", "report.html"};
    for (const EnvironmentCase& item : settings_.environments) {
      const ResultNames own = result_names(settings_, item);
      names.insert(names.end(), {own.one_plan, own.all_plans, own.log});
    }
    for (const Task& task : open_tasks()) {
      const std::vector<std::string> files = trial_files(task.key.id);
      names.insert(names.end(), files.begin(), files.end());
    }
    return names;
  }

  std::vector<Task> tasks_in(const EnvironmentCase& item) const {
    std::vector<Task> tasks;
    for (const std::string& disturbance : settings_.disturbances) {
      for (const std::string& controller : settings_.controllers) {
        for (const std::string& planner : settings_.planners) {
          TrialKey key;
          key.planner = planner;
          key.controller = controller;
          key.disturbance = disturbance;
          add_tasks(key, item, no_load_, tasks);
          add_tasks(key, item, network_, tasks);
        }
      }
    }
    return tasks;
  }

  /// Of all environments; folders with their trials stay as they are.
  std::vector<Task> open_tasks() const {
    std::vector<Task> open;
    for (const EnvironmentCase& item : settings_.environments) {
      std::ranges::copy_if(tasks_in(item), std::back_inserter(open), [&](const Task& task) {
        return !has_trial(folder_of(item), task.key.id);
      });
    }
    return open;
  }

  void add_tasks(TrialKey key, const EnvironmentCase& item, const MotionModel& model,
                 std::vector<Task>& tasks) const {
    const bool is_closed = key.controller == "replan";  // which needs a network
    if (!model.has_network() && (!settings_.with_no_load || is_closed)) {
      return;
    }
    key.experiment = hash_for(key.controller, item);
    key.environment = item.id;
    key.environment_hash = environment_hash(item.environment);
    key.model = model.has_network() ? "network" : "no_load";
    key.model_hash = model.has_network() ? model_bytes_hash_ : "";
    for (int k = 0; k < settings_.trials; ++k) {
      key.seed = derived_seed(settings_.seed, kTrialSeed + std::uint64_t(k));
      key.id = fmt::format("{}_{}_{}_{:03}", item.id, key.model, way_of(key), k + 1);
      tasks.push_back({&item, &model, key});
    }
  }

  /// Of each plan, the tasks that execute it.
  static std::vector<std::vector<Task>> by_plan(const std::vector<Task>& tasks) {
    using PlanKey = std::tuple<const EnvironmentCase*, std::string, std::string, std::uint64_t>;
    std::map<PlanKey, std::vector<Task>> plans;
    for (const Task& task : tasks) {
      plans[{task.environment, task.key.model, task.key.planner, task.key.seed}].push_back(task);
    }
    std::vector<std::vector<Task>> lists;
    for (const auto& [key, of_plan] : plans) {
      lists.push_back(of_plan);
    }
    return lists;
  }

  void run_tasks() {
    const std::vector<Task> open = open_tasks();
    int finished = 0;
    for (const EnvironmentCase& item : settings_.environments) {
      for (const Task& task : tasks_in(item)) {
        if (has_trial(settings_.folder, task.key.id)) {
          ++finished;
          (void)read(task);  // a damaged one is found now, not after hours of running the others
        }
      }
    }
    if (finished > 0) {
      settings_.say(fmt::format("{} of {} trials were already finished", finished,
                                finished + int(open.size())));
    }
    PlanTrialSettings trial;
    trial.limits = settings_.limits;
    trial.room = settings_.room;
    trial.planner_jobs = settings_.planner_jobs;
    trial.model_hash = model_bytes_hash_;
    trial.motion_queries = settings_.motion_queries;
    trial.adapts = settings_.adapts;
    Progress progress("experiment", "trials", open.size(), settings_.progress);
    JobArena arena(settings_.jobs);
    const std::vector<std::vector<Task>> plans = by_plan(open);
    arena.for_each(plans.size(), [&](std::size_t i) {
      if (interrupt_requested()) {
        return;
      }
      const PlanTrial planned = plan_for(plans[i].front(), trial);
      // A thread that waits here takes no other plan meanwhile: all of them would be held at once.
      tbb::this_task_arena::isolate([&] {
        arena.for_each(plans[i].size(), [&](std::size_t k) {
          if (!interrupt_requested()) {
            run_task(plans[i][k], trial, planned);
            progress.advance();
          }
        });
      });
    });
    progress.finish();
  }

  PlanTrial read(const Task& task) const {
    PlanTrial trial = read_trial(folder_of(*task.environment), task.key, settings_.arm,
                                 task.environment->environment);
    output_->require_unchanged(trial_files(task.key.id));
    return trial;
  }

  PlanTrial plan_for(const Task& task, PlanTrialSettings settings) const {
    settings.planner = task.key.planner;
    if (settings_.forest && task.model->has_network() && is_default_planner(settings.planner)) {
      settings.forest = &*settings_.forest;
    }
    return plan_trial(settings_.arm, *task.model, *task.environment, settings, task.key.seed);
  }

  /// @param trial  with its plan
  void run_task(const Task& task, PlanTrialSettings settings, PlanTrial trial) {
    settings.controller = task.key.controller;
    settings.disturbance = task.key.disturbance;
    const Environment& environment = task.environment->environment;
    run_trial(settings_.arm, *task.model, environment, settings, trial);
    if (!interrupt_requested()) {
      write_trial(*output_, task.key, trial, environment);
    }
  }

  Json write_results() {
    ExperimentResults results(settings_, *output_);
    for (const EnvironmentCase& item : settings_.environments) {
      throw_if_interrupted();
      const auto trials =
          mapped<PlanTrial>(tasks_in(item), [&](const Task& task) { return read(task); });
      results.add(item, trials);
    }
    return results.write();
  }

  const ExperimentSettings& settings_;
  std::string model_bytes_hash_;
  ForwardModel no_load_forward_;
  ForwardModel network_forward_;
  MotionModel no_load_;
  MotionModel network_;
  Json identity_;
  Json part_identity_;  ///< without environments
  std::optional<OutputFolder> output_;
};

}  // namespace

void require_usable(const ExperimentSettings& settings) {
  refuse_if(settings.trials < 1 || settings.trials > 100'000, "--trials {}: expected 1 to 100000",
            settings.trials);
  require_margin(settings.room.margin_m.value_or(0.0));
  require_goal_margin(
      {settings.room.goal_margin_m.value_or(0.0), settings.room.goal_margin_rad.value_or(0.0)});
  refuse_if(settings.planners.empty(), "no planner given");
  for (const std::string& planner : settings.planners) {
    (void)make_planner(planner);  // refuses an unknown one before any work
  }
  refuse_if(settings.controllers.empty() || settings.disturbances.empty(),
            "no controller or no disturbance given; \"\" is no disturbance");
  for (const std::string& controller : settings.controllers) {
    require_controller(controller);
  }
  for (const std::string& disturbance : settings.disturbances) {
    (void)parse_disturbances(disturbance);
  }
  refuse_if(settings.environments.empty(), "no environments to plan in");
  std::set<std::string> names;
  for (const EnvironmentCase& item : settings.environments) {
    refuse_if(!names.insert(item.id).second, "two environments are called {}; rename a file",
              item.id);
  }
  for (const std::string& name : names) {
    refuse_if(names.contains(name + "_all"),
              "environments {0} and {0}_all: a picture of the first would have the second's name; "
              "rename a file",
              name);
  }
  refuse_if(!settings.parts.empty() && settings.parts.size() != settings.environments.size(),
            "--join: {} folders for {} environments; expected one for each", settings.parts.size(),
            settings.environments.size());
  refuse_if(fs::exists(settings.folder / kExperimentFile) && !settings.resume && !settings.force,
            "{}: holds an experiment already: --resume continues it, --force replaces it",
            settings.folder.string());
  for (const EnvironmentCase& item : settings.environments) {
    if (settings.forest) {
      require_forest_of(*settings.forest, settings.arm, settings.valves,
                        start_state(item.environment, settings.arm));
    }
  }
}

std::optional<std::uint64_t> known_motion_queries(const ExperimentSettings& settings) {
  const fs::path file = settings.folder / kExperimentFile;
  if (!settings.resume || !fs::exists(file)) {
    return std::nullopt;
  }
  const nlohmann::json root = read_json_object(file);
  const auto found = root.find("motion_queries");
  return found != root.end() && found->is_number_unsigned()
             ? std::optional(found->get<std::uint64_t>())
             : std::nullopt;
}

Json run_experiment(const ExperimentSettings& settings) {
  require_usable(settings);
  return Experiment(settings).run();
}

}  // namespace limber
