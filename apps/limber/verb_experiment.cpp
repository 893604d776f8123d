#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/data_folder.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/trial_run.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/sim/disturbance.hpp"
#include "model_flags.hpp"
#include "plan_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// Without what is there twice: it would be the same row.
std::vector<std::string> once_each(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    if (std::ranges::find(result, name) == result.end()) {
      result.push_back(name);
    }
  }
  return result;
}

/// How the plans of an experiment are executed, and what the arm then meets.
class RunFlags {
 public:
  /// --replan, --controller and --disturbance.
  void add_to(CLI::App& app) {
    app.add_flag(
        "--replan", replan_,
        "Execute closed loop: plan again from where the arm is measured, while it moves and "
        "after; as --controller replan");
    app.add_option(
           "--controller", controllers_,
           "What executes the plans: " + controller_names() + "; may be repeated to compare them")
        ->expected(1)
        ->take_all();
    app.add_option("--disturbance", disturbances_,
                   "The virtual arm is not as the model knows it: none, " + disturbance_kinds() +
                       "; several at once with commas between; may be repeated to compare them")
        ->expected(1)
        ->take_all();
  }

  /// In the order given; with --replan, replan is one of them. Open loop if none is given.
  std::vector<std::string> controllers() const {
    std::vector<std::string> names = controllers_;
    if (replan_) {
      names.emplace_back("replan");
    }
    if (names.empty()) {
      names.emplace_back("open");
    }
    return once_each(names);
  }

  /// Several runs may be told the same of closed loop, whatever each runs.
  bool names_controller() const { return replan_ || !controllers_.empty(); }
  bool replans() const { return std::ranges::count(controllers(), "replan") > 0; }

  /// In the order given, empty for none; none alone if nothing is given.
  /// @throws InputError if there is no such kind.
  std::vector<std::string> disturbances() const {
    auto names = mapped<std::string>(disturbances_, [&](const std::string& name) {
      return name == "none" ? "" : to_string(parse_disturbances(name));
    });
    if (names.empty()) {
      names.emplace_back();
    }
    return once_each(names);
  }

 private:
  bool replan_ = false;
  std::vector<std::string> controllers_;
  std::vector<std::string> disturbances_;
};

class ExperimentVerb final : public Verb {
 public:
  ExperimentVerb()
      : Verb(
            "experiment",
            "The paper's Table I: plan with both models in many environments, execute, compare",
            "limber experiment --model model.safetensors --trials 2 --time-limit-s 1 --out table") {
  }

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    app.add_option("--model", settings_.model_file,
                   "Network model to compare with the no-load model")
        ->required();
    app.add_option("--environments", environments_,
                   "Folder of environment files, or one; repeat for more; limber's own eight by "
                   "default")
        ->allow_extra_args(false);
    app.add_option("--join", settings_.parts,
                   "Run nothing: one table of the experiments in these folders, one for each of "
                   "--environments, in their order")
        ->allow_extra_args(false);
    app.add_option("--trials", settings_.trials, "Plans of each model in each environment")
        ->capture_default_str();
    app.add_option("--planner", settings_.planners,
                   "As for limber plan; may be repeated to compare planners")
        ->expected(1)
        ->take_all()
        ->capture_default_str();
    app.add_option("--planner-jobs", settings_.planner_jobs,
                   "Threads of each planner, 0 for one per core; --jobs trials run side by side")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    app.add_flag("--network-only", network_only_, "Leave the no-load model out");
    app.add_option("--time-limit-s", settings_.limits.time_s,
                   fmt::format("For each plan; {} where no limit is given", kDefaultTimeLimitS))
        ->check(more_than_zero());
    app.add_option("--max-iterations", settings_.limits.iterations,
                   "For each plan; with this limit alone the table can be repeated")
        ->check(more_than_zero());
    app.add_option("--max-queries", settings_.limits.queries, "For each plan")
        ->check(more_than_zero());
    app.add_option("--max-memory-mb", settings_.limits.memory_mb, "For each plan")
        ->check(more_than_zero());
    add_cost_threshold(app, settings_.limits.cost_threshold_kpa);
    runs_.add_to(app);
    replan_.add_settings_to(app);
    room_.add_to(app);
    valves_.add_valves_to(app);
    forest_.add_to(app);
    app.add_option("--out", settings_.folder, "Folder for tables, figures, trials and plans")
        ->capture_default_str();
    app.add_flag("--resume", settings_.resume,
                 "Keep the finished trials in --out; you may ask for more --trials");
  }

  int run(const CommonFlags& flags) override {
    forest_.require_use();
    refuse_if(replan_.has_settings() && !runs_.names_controller(),
              "--motion-queries, --adapt and --no-adapt are of closed loop: add --replan, or leave "
              "them out");
    settings_.arm = load_asked_arm(arm_, "limber experiment");
    if (environments_.empty()) {
      environments_.push_back((data_folder() / "environments").string());
    }
    for (const std::string& name : environments_) {
      const std::string place = fs::is_directory(name) ? name : find_environment_file(name);
      std::ranges::move(environments_in(place, settings_.arm),
                        std::back_inserter(settings_.environments));
    }
    settings_.limits = settings_.limits.or_default();
    take_common(flags, settings_);
    settings_.planners = once_each(settings_.planners);
    settings_.controllers = runs_.controllers();
    settings_.disturbances = runs_.disturbances();
    settings_.with_no_load = !network_only_;
    require_writable_folder(settings_.folder);
    const ForwardModel network(settings_.arm,
                               read_model_of_one_arm(settings_.model_file, settings_.arm));
    require_bounded(network.compensation(), settings_.model_file.string());
    const MotionModel model = valves_.motion_model(settings_.arm, network);
    valves_.warn_without_valves(model, flags);
    settings_.valves = model.valves().parameters();
    if (runs_.replans()) {
      replan_.choose_motion_queries(settings_.arm, model, known_motion_queries(settings_), flags);
      settings_.motion_queries = replan_.settings().motion_queries;
      settings_.adapts = replan_.settings().adapts;
    }
    settings_.room = room_.asked();
    (void)room_.room(network, flags);
    if (forest_.is_asked_for()) {
      require_usable(settings_);
      refuse_if(
          std::ranges::none_of(settings_.planners, is_default_planner),
          "--forest and --build-forest: the default planner alone uses a forest; add --planner "
          "default, or leave them out");
      // For all environments: a trial refuses the forest if its environment starts differently.
      const ArmStart start = start_state(settings_.environments.front().environment, settings_.arm);
      settings_.forest =
          forest_.forest(settings_.arm, model, settings_.model_file.string(), start, flags);
      throw_if_interrupted();
    }
    const Json table = run_experiment(settings_);
    print_result(
        flags, {{"table", table}, {"seed", flags.seed}, {"out", settings_.folder}},
        fmt::format("{0}/table.md, {0}/table.json, {0}/report.html", settings_.folder.string()));
    return kExitDone;
  }

 private:
  std::string arm_ = "three_segment";
  std::vector<std::string> environments_;
  bool network_only_ = false;
  ModelFlags valves_;
  RoomFlags room_;
  ReplanFlags replan_;
  RunFlags runs_;
  ForestFlags forest_;
  ExperimentSettings settings_;
};

}  // namespace

std::unique_ptr<Verb> make_experiment_verb() {
  return std::make_unique<ExperimentVerb>();
}

}  // namespace limber
