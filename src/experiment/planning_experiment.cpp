#include "limber/experiment/planning_experiment.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "common/job_arena.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/version.hpp"
#include "limber/experiment/demo_recipe.hpp"
#include "limber/experiment/final_shapes_picture.hpp"
#include "limber/experiment/output_folder.hpp"
#include "limber/experiment/planner_arena.hpp"
#include "limber/experiment/planning_table.hpp"
#include "limber/experiment/report_page.hpp"
#include "trial_file.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr std::uint64_t kTrialSeed = 128;  // as the demo's plans
constexpr const char* kSettingsFile = "experiment.json";

Json optional_json(const auto& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string forest_hash(const Forest& forest) {
  return content_hash({reinterpret_cast<const char*>(forest.setpoints_kpa.data()),
                       static_cast<std::size_t>(forest.setpoints_kpa.size()) * sizeof(float)});
}

/// What has to be the same for trials of two runs to stand in one table. The number of trials is
/// not among it: more can be added.
Json identity(const ExperimentSettings& settings, const std::string& model_hash) {
  Json json;
  json["schema"] = "limber/experiment/1";
  json["arm"] = {{"name", settings.arm.name}, {"hash", settings.arm.hash()}};
  json["virtual_arm"] = content_hash(arm_to_yaml(settings.arm));
  json["model"] = model_hash;
  json["valves"] = settings.valves.hash();
  json["margin_m"] = settings.margin_m;
  json["seed"] = settings.seed;
  json["time_limit_s"] = optional_json(settings.limits.time_s);
  json["max_iterations"] = optional_json(settings.limits.iterations);
  json["max_queries"] = optional_json(settings.limits.queries);
  json["max_memory_mb"] = optional_json(settings.limits.memory_mb);
  json["cost_threshold_kpa"] = optional_json(settings.limits.cost_threshold_kpa);
  json["forest"] = settings.forest ? Json(forest_hash(*settings.forest)) : Json(nullptr);
  json["planner_jobs"] = settings.planner_jobs;
  json["environments"] = Json::object();
  for (const EnvironmentCase& item : settings.environments) {
    json["environments"][item.id] = environment_hash(item.environment);
  }
  return json;
}

void require_same(const fs::path& file, const Json& wanted) {
  Json found;
  try {
    found = Json::parse(read_file(file));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not valid JSON: {}", file.string(), error.what()));
  }
  for (const auto& [key, value] : wanted.items()) {
    const Json there = found.value(key, Json(nullptr));
    if (there != value) {
      throw InputError(fmt::format(
          "{}: {} = {}; this run has {}: --resume continues the same experiment only; choose "
          "another --out, or drop --resume",
          file.string(), key, there.dump(), value.dump()));
    }
  }
}

/// "ompl:SST,frames=5" → "ompl-SST-frames-5".
std::string as_file_name(std::string text) {
  for (char& c : text) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
  }
  return text;
}

struct Task {
  const EnvironmentCase* environment;
  const MotionModel* model;
  const std::string* planner;
  std::uint64_t seed;
  std::string id;  ///< of its files
};

class Experiment {
 public:
  explicit Experiment(const ExperimentSettings& settings)
      : settings_(settings),
        model_bytes_hash_(content_hash(read_file(settings.model_file))),
        no_load_forward_(settings.arm),
        network_forward_(settings.arm, read_model(settings.model_file)),
        no_load_(no_load_forward_, ValveModel(settings.arm, settings.valves)),
        network_(network_forward_, ValveModel(settings.arm, settings.valves)) {}

  Json run() {
    prepare_folder();
    list_tasks();
    run_tasks();
    throw_if_interrupted();
    return write_results();
  }

 private:
  fs::path file(const std::string& name) const { return settings_.folder / name; }

  void prepare_folder() const {
    const Json wanted = identity(settings_, model_bytes_hash_);
    if (settings_.resume && fs::exists(file(kSettingsFile))) {
      require_same(file(kSettingsFile), wanted);
      return;
    }
    prepare_output_folder(settings_.folder, settings_.force, "experiment");
    Json written = wanted;
    written["program_version"] = version();
    write_file_atomically(file(kSettingsFile), written.dump(1) + "\n");
  }

  void list_tasks() {
    for (const std::string& planner : settings_.planners) {
      for (const EnvironmentCase& item : settings_.environments) {
        add_tasks(planner, item, no_load_);
        add_tasks(planner, item, network_);
      }
    }
  }

  void add_tasks(const std::string& planner, const EnvironmentCase& item,
                 const MotionModel& model) {
    if (!settings_.with_no_load && !model.has_network()) {
      return;
    }
    for (int k = 0; k < settings_.trials; ++k) {
      tasks_.push_back(
          {&item, &model, &planner, derived_seed(settings_.seed, kTrialSeed + std::uint64_t(k)),
           fmt::format("{}_{}_{}_{:03}", item.id, model.has_network() ? "network" : "no_load",
                       as_file_name(planner), k + 1)});
    }
  }

  void run_tasks() {
    std::vector<const Task*> open;
    for (const Task& task : tasks_) {
      if (!has_trial(settings_.folder, task.id)) {
        open.push_back(&task);
      }
    }
    if (open.size() < tasks_.size()) {
      settings_.say(fmt::format("{} of {} trials were finished before", tasks_.size() - open.size(),
                                tasks_.size()));
    }
    PlanTrialSettings trial;
    trial.limits = settings_.limits;
    trial.margin_m = settings_.margin_m;
    trial.planner_jobs = settings_.planner_jobs;
    trial.model_hash = model_bytes_hash_;
    Progress progress("experiment", "trials", open.size(), settings_.progress);
    JobArena arena(settings_.jobs);
    arena.execute([&] {
      tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t i) {
        if (!interrupt_requested()) {
          run_task(*open[i], trial);
          progress.advance();
        }
      });
    });
    progress.finish();
  }

  void run_task(const Task& task, PlanTrialSettings settings) const {
    settings.planner = *task.planner;
    if (settings_.forest && task.model->has_network() && is_default_planner(*task.planner)) {
      settings.forest = &*settings_.forest;
    }
    const Environment& environment = task.environment->environment;
    PlanTrial trial =
        plan_trial(settings_.arm, *task.model, *task.environment, settings, task.seed);
    execute_trial(settings_.arm, environment, trial);
    if (!interrupt_requested()) {
      write_trial(settings_.folder, task.id, trial, environment);
    }
  }

  Json write_results() const {
    std::vector<PlanTrial> trials;
    for (const Task& task : tasks_) {
      trials.push_back(read_trial(settings_.folder, task.id, task.environment->environment));
    }
    const std::vector<PlanningRow> rows = planning_rows(trials);
    const Json table = planning_table_to_json(rows);
    write_file_atomically(file("table.json"), table.dump(1) + "\n");
    const std::string title =
        fmt::format("Planning and execution, arm {}, {} trials a cell, seed {}", settings_.arm.name,
                    settings_.trials, settings_.seed);
    const std::vector<ReportTable> tables = planning_tables(rows);
    write_file_atomically(file("table.md"), tables_to_markdown(title, tables));
    write_report(title, tables, rows, trials);
    for (const EnvironmentCase& item : settings_.environments) {
      write_file_atomically(file("planner_arena/" + item.id + ".log"),
                            planner_arena_log(item.id, trials, settings_.limits, settings_.seed));
    }
    return table;
  }

  void write_report(const std::string& title, const std::vector<ReportTable>& tables,
                    const std::vector<PlanningRow>& rows,
                    const std::vector<PlanTrial>& trials) const {
    ReportPage page("limber experiment", title);
    page.heading("Tables");
    for (const ReportTable& table : tables) {
      page.table(table);
    }
    page.heading("Final shapes")
        .paragraph(
            "As in the paper's Fig. 5: where the arm ended after executing one plan of each model, "
            "and "
            "after all of them. Runs that collided are dashed.");
    for (const EnvironmentCase& item : settings_.environments) {
      std::vector<PlanTrial> one;
      for (const PlanningRow& row : rows) {
        if (row.environment == item.id && row.planner == rows.front().planner &&
            row.one_plan != nullptr) {
          one.push_back(*row.one_plan);
        }
      }
      const std::string single = final_shapes_picture(settings_.arm, item, one);
      const std::string all = final_shapes_picture(settings_.arm, item, trials);
      write_file_atomically(file("figures/" + item.id + ".svg"), single);
      write_file_atomically(file("figures/" + item.id + "_all.svg"), all);
      page.figures(
          {{single, item.id + ": one plan of each model"}, {all, item.id + ": all plans"}});
    }
    write_file_atomically(file("report.html"), page.html());
  }

  const ExperimentSettings& settings_;
  std::string model_bytes_hash_;
  ForwardModel no_load_forward_;
  ForwardModel network_forward_;
  MotionModel no_load_;
  MotionModel network_;
  std::vector<Task> tasks_;
};

}  // namespace

void require_usable(const ExperimentSettings& settings) {
  if (settings.trials < 1 || settings.trials > 100'000) {
    throw InputError(fmt::format("--trials {}: expected 1 to 100000", settings.trials));
  }
  if (settings.planners.empty()) {
    throw InputError("no planner given");
  }
  for (const std::string& planner : settings.planners) {
    (void)make_planner(planner);  // refuses an unknown one before any work
  }
  if (settings.environments.empty()) {
    throw InputError("no environments to plan in");
  }
  if (fs::exists(settings.folder / kSettingsFile) && !settings.resume && !settings.force) {
    throw InputError(
        fmt::format("{}: holds an experiment already: --resume continues it, --force replaces it",
                    settings.folder.string()));
  }
  for (const EnvironmentCase& item : settings.environments) {
    if (settings.forest) {
      require_forest_of(*settings.forest, settings.arm, settings.valves,
                        start_state(item.environment, settings.arm));
    }
  }
}

Json run_experiment(const ExperimentSettings& settings) {
  require_usable(settings);
  return Experiment(settings).run();
}

}  // namespace limber
