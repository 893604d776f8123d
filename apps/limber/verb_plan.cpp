#include <algorithm>
#include <iterator>
#include <string_view>

#include "driver_flags.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/report/plan_report.hpp"
#include "model_flags.hpp"
#include "plan_flags.hpp"
#include "spread_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

int exit_code(PlanStatus status) {
  switch (status) {
    case PlanStatus::solved:
      return kExitDone;
    case PlanStatus::limit:
    case PlanStatus::not_certified:
      return kExitNoSolution;
    default:
      return kExitBadInput;
  }
}

/// What growing a forest alone asks for.
constexpr std::string_view kFlagsOfForests[] = {"--arm",          "--model",       "--no-load",
                                                "--valves",       "--no-valves",   "--forest",
                                                "--build-forest", "--forest-nodes"};

/// Progress over the time limit if there is one, else over the iterations or queries.
class PlanProgress {
 public:
  PlanProgress(const PlannerLimits& limits, const std::string& command_unit, Progress::Mode mode)
      : limits_(limits),
        command_unit_(command_unit),
        progress_("plan", unit(limits), total(limits), mode) {}

  void update(const PlannerProgress& now) {
    const std::string cost = now.best_cost_kpa
                                 ? fmt::format("best {:.1f} {}", *now.best_cost_kpa, command_unit_)
                                 : "no plan yet";
    const double rate = now.time_s > 0.0 ? double(now.queries) / now.time_s : 0.0;
    const std::uint64_t done = limits_.time_s       ? std::uint64_t(now.time_s * 1000.0)
                               : limits_.iterations ? now.iterations
                                                    : now.queries;
    progress_.update(done, fmt::format("{} nodes, {}, {:.0f} queries/s", now.nodes, cost, rate));
  }

  void finish(const PlanResult& result) {
    const PlannerStatistics& all = result.statistics;
    update({all.time_s, all.iterations, all.nodes, all.queries,
            result.plan ? std::optional(result.plan->cost_kpa) : std::nullopt});
    progress_.finish();
  }

 private:
  static std::string unit(const PlannerLimits& limits) {
    return limits.time_s ? "ms" : limits.iterations ? "iterations" : "queries";
  }
  static std::uint64_t total(const PlannerLimits& limits) {
    return limits.time_s       ? std::uint64_t(*limits.time_s * 1000.0)
           : limits.iterations ? *limits.iterations
                               : limits.queries.value_or(0);
  }

  PlannerLimits limits_;
  std::string command_unit_;
  Progress progress_;
};

class PlanVerb final : public Verb {
 public:
  PlanVerb()
      : Verb("plan", "Plan a motion in pressure space that reaches a goal without collision",
             "limber plan --arm three_segment --no-load --environment 01_pillar --time-limit-s 5 "
             "--out plan.json --svg plan.svg") {}

  void add_flags(CLI::App& app) override {
    const std::size_t of_all_verbs = app.get_options().size();
    add_arm_flag(app, arm_);
    model_.add_to(app, " to plan with");
    app.add_option("--environment", environment_,
                   "Environment file, or the name of one of "
                   "limber's own; not needed to --build-forest alone");
    app.add_option(
           "--planner", planner_,
           "default: keeps several backbones for similar pressures, then improves plans; paper: "
           "RRT* in pressure space; ompl:NAME: one of OMPL's. Settings follow the name: "
           "ompl:SST,pruning_radius=0.1 or default,goal_steering_share=0.2")
        ->capture_default_str();
    app.add_option(
           "--time-limit-s", limits_.time_s,
           fmt::format("Stop after so many seconds; {} if no limit is given", kDefaultTimeLimitS))
        ->check(more_than_zero());
    app.add_option("--max-iterations", limits_.iterations,
                   "Stop after so many samples; with only this limit, a run can be repeated")
        ->check(more_than_zero());
    app.add_option("--max-queries", limits_.queries,
                   "Stop after so many queries of the model by the search. 'queries' of --json are "
                   "more: they count the plan's last simulation and an ensemble's other networks")
        ->check(more_than_zero());
    app.add_option("--max-memory-mb", limits_.memory_mb,
                   "Stop when the tree takes so many megabytes")
        ->check(more_than_zero());
    add_cost_threshold(app, limits_.cost_threshold_kpa);
    narrower_.add_to(app);
    room_.add_to(app);
    app.add_flag(
        "--stay-recorded", stay_recorded_,
        "Plan only with set points, rates and shapes like those in the model's recordings");
    forest_.add_to(app);
    app.add_option("--start-from-driver", start_driver_,
                   "exec:COMMAND: start where its driver sees the vented arm. The environment with "
                   "that start is written beside --out, for verify and execute");
    wire_.add_to(app);
    app.add_option("--out", out_, "Write the plan here (JSON); not written without a solution");
    app.add_option("--csv", csv_, "Write the plan's set points here, for a valve controller");
    app.add_option("--svg", svg_, "Draw arm, plan, tree and obstacles here");
    app.add_option("--pressures-svg", pressures_svg_,
                   "Draw the plan's set points and predicted pressures over time here");
    app.add_option("--animation", animation_, "Write a page (HTML) here in which the arm moves");
    for (const char* name : {"--calibration", "--simulated"}) {
      app.get_option(name)->needs("--start-from-driver");
    }
    const std::vector<CLI::Option*> options = app.get_options();
    std::copy_if(options.begin() + std::ptrdiff_t(of_all_verbs), options.end(),
                 std::back_inserter(of_plans_), [](const CLI::Option* option) {
                   return std::ranges::find(kFlagsOfForests, option->get_name()) ==
                          std::end(kFlagsOfForests);
                 });
  }

  int run(const CommonFlags& flags) override {
    forest_.require_use();
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_asked_arm(arm_file, "limber plan");
    const ForwardModel forward = model_.planning_model(arm);
    const MotionModel model = model_.motion_model(arm, forward);
    model_.warn_without_valves(model, flags);
    if (environment_.empty()) {
      return build_forest_alone(arm, model, flags);
    }
    refuse_to_overwrite_given({out_, csv_, svg_, pressures_svg_, animation_}, flags);
    const Environment environment = environment_from(arm, arm_file, flags);
    room_.require_use(environment);
    PlanResult result = search(arm, model, environment, flags);
    for (const std::string& warning : result.warnings) {
      say(flags, "warning: {}", warning);
    }
    if (result.plan && model_.names_model()) {
      result.plan->model_hash = file_hash(model_.model_file());
    }
    write(result, arm, environment);
    const std::string model_name = model.has_network() ? "network" : "no_load";
    Json json = to_json(result, arm.command, environment.goal, planner_, model_name, flags.seed);
    std::string text = result.plan ? to_text(result, arm.command) : "";
    add_spread(forward, arm, environment, result, json, text);
    print_result(flags, json, text);
    if (!result.plan) {
      print_error(to_text(result, arm.command));
    }
    return exit_code(result.status);
  }

 private:
  /// Of an ensemble: what each of its networks makes of the plan.
  static void add_spread(const ForwardModel& forward, const ArmDescription& arm,
                         const Environment& environment, const PlanResult& result, Json& json,
                         std::string& text) {
    if (!forward.has_network() || forward.compensation().member_count() == 1) {
      return;
    }
    json["spread"] = nullptr;
    if (!result.plan) {
      return;
    }
    if (const auto spread = plan_spread(*result.plan, arm, forward.compensation(), environment)) {
      json["spread"] = to_json(*spread);
      text += "\n" + to_text(*spread, "this model", arm, environment);
    }
  }

  /// As the file has it, or with the arm's measured shape as its start.
  Environment environment_from(const ArmDescription& arm, const std::string& arm_file,
                               const CommonFlags& flags) const {
    Environment environment = load_environment(find_environment_file(environment_), arm);
    if (start_driver_.empty()) {
      return environment;
    }
    refuse_if(out_.empty(),
              "--start-from-driver: needs --out, beside which the environment is written");
    const auto file = fs::path(out_).replace_extension(".environment.yaml");
    refuse_to_overwrite(file, flags.force);
    environment.start = measured_start(arm, arm_file, start_driver_, wire_);
    const std::string yaml = environment_to_yaml(environment);
    (void)read_environment(YamlReader::from_text(yaml, "the measured start"), arm);
    write_file_atomically(file, yaml);
    say(flags, "{}: the environment, starting where the arm lies", file.string());
    return environment;
  }

  int build_forest_alone(const ArmDescription& arm, const MotionModel& model,
                         const CommonFlags& flags) const {
    refuse_if(!forest_.builds(),
              "--environment is required: a file, or the name of one of limber's own");
    for (const CLI::Option* option : of_plans_) {
      if (option->count() > 0) {
        throw InputError(
            fmt::format("{}: a forest alone is grown without --environment, and no plan is made",
                        option->get_name()));
      }
    }
    const std::optional<Forest> forest =
        forest_.forest(arm, model, model_.model_file(), start_state(Environment(), arm), flags);
    throw_if_interrupted();
    print_result(flags, {{"forest_nodes", forest->size()}}, "");
    return kExitDone;
  }

  PlanResult search(const ArmDescription& arm, const MotionModel& model,
                    const Environment& environment, const CommonFlags& flags) {
    PlanSettings settings;
    settings.room = room_.asked();
    settings.within = narrower_.limits(arm);
    settings.rate_limit_kpa_per_s = narrower_.rate_limit();
    settings.stay_recorded = stay_recorded_;
    settings.planner = planner_;
    settings.jobs = flags.jobs;
    std::optional<Forest> forest;
    if (forest_.is_asked_for()) {
      refuse_before_growing(model, settings);
      forest =
          forest_.forest(arm, model, model_.model_file(), start_state(environment, arm), flags);
      throw_if_interrupted();
      settings.forest = &*forest;
    }
    const PlannerLimits limits = limits_.or_default();
    PlanProgress progress(limits, arm.command.unit, flags.progress());
    settings.callback = [&](const PlannerProgress& now) {
      progress.update(now);
      return !interrupt_requested();
    };
    PlanResult result = limber::plan(arm, model, environment, limits, flags.seed, settings);
    progress.finish(result);
    return result;
  }

  /// What planning would refuse after minutes of growing a forest.
  static void refuse_before_growing(const MotionModel& model, const PlanSettings& settings) {
    const Forest none;
    (void)make_planner(settings.planner, settings.jobs, &none);
    (void)error_room(model.forward(), settings.room);
    refuse_if(
        settings.rate_limit_kpa_per_s.has_value(),
        "--rate-limit: forests are grown with the arm's own rate; leave out this or the forest");
    refuse_if(settings.stay_recorded && !(model.has_network() && model.compensation().learnt),
              "--stay-recorded: needs a network that stores what its recordings held; limber train "
              "stores it");
  }

  void write(const PlanResult& result, const ArmDescription& arm,
             const Environment& environment) const {
    if (result.plan && !out_.empty()) {
      write_plan(out_, *result.plan);
    }
    if (result.plan && !csv_.empty()) {
      write_setpoints_csv(csv_, *result.plan);
    }
    // If planning can't begin there is nothing to draw here; `environment check --svg` draws the
    // environment.
    if (exit_code(result.status) != kExitBadInput) {
      write_given(svg_, [&] { return plan_picture(arm, environment, result); });
    }
    if (result.plan) {
      write_given(pressures_svg_, [&] { return pressure_picture(arm, *result.plan); });
      write_given(animation_, [&] { return plan_animation(arm, environment, *result.plan); });
    }
  }

  std::string arm_ = "three_segment";
  ModelFlags model_;
  std::string environment_;
  std::string planner_ = "default";
  PlannerLimits limits_;
  ForestFlags forest_;
  RoomFlags room_;
  LimitFlags narrower_;
  bool stay_recorded_ = false;
  std::string start_driver_;
  WireFlags wire_;
  std::string out_;
  std::string csv_;
  std::string svg_;
  std::string pressures_svg_;
  std::string animation_;
  std::vector<const CLI::Option*> of_plans_;
};

}  // namespace

std::unique_ptr<Verb> make_plan_verb() {
  return std::make_unique<PlanVerb>();
}

}  // namespace limber
