#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/tube_calibration.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/sim/virtual_arm_parameters.hpp"
#include "model_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class CalibrateVerb final : public Verb {
 public:
  CalibrateVerb()
      : Verb("calibrate",
             "Measure how far the arm may be from its predictions over whole motions: its tube",
             "limber calibrate --model model.safetensors --out calibrated.safetensors\n"
             "  limber calibrate --model calibrated.safetensors --check 200 --time-limit-s 1") {}

  void add_flags(CLI::App& app) override {
    add_arm_flag(app, arm_);
    app.add_option("--model", model_file_,
                   "Network model to calibrate, or a family: its tube holds for arms adapted to it")
        ->required();
    model_.add_valves_to(app);
    app.add_option("--out", out_, "The model with its tube (safetensors)");
    app.add_option("--levels", settings_.levels, "Shares of runs, rising")->capture_default_str();
    app.add_option("--confidence", settings_.confidence, "How sure each level has to be")
        ->capture_default_str();
    auto* driver = app.add_option("--driver", driver_, "virtual: the virtual arm executes")
                       ->check(CLI::IsMember({"virtual"}))
                       ->capture_default_str();
    auto* recordings =
        app.add_option("--recordings", recordings_,
                       "Instead: what limber execute --out recorded, open loop, on any arm")
            ->excludes(driver);
    app.add_option("--plans", plans_, "Plans that --recordings executed, in their order")
        ->needs(recordings);
    app.add_option("--shape-runs", settings_.scale_runs, "Runs that give the tube its shape")
        ->capture_default_str();
    app.add_option("--screen-runs", settings_.screen_runs, "Runs that say which factors to test")
        ->capture_default_str();
    app.add_option("--test-runs", settings_.test_runs, "Runs that test a level's factor")
        ->capture_default_str();
    app.add_option("--audit-runs", settings_.audit_runs, "Runs that audit it; 0: no audit")
        ->capture_default_str();
    app.add_option("--max-queries", limits_.queries,
                   fmt::format("For each plan; {} where no limit is given", kCalibrationQueries))
        ->check(more_than_zero());
    app.add_option("--time-limit-s", limits_.time_s,
                   "For each plan; with it, runs can't be repeated exactly")
        ->check(more_than_zero());
    app.add_option("--folder", folder_,
                   "Folder of finished runs and evidence; by default OUT.calibration");
    app.add_flag("--resume", settings_.resume, "Go on with the finished runs in --folder");
    add_family_flags(app);
    add_check_flags(app);
    exclude_unused(app);
  }

  int run(const CommonFlags& flags) override {
    const ArmDescription arm = load_asked_arm(arm_, "limber calibrate");
    CompensationModel model = read();
    require_model_of(model, arm, model_file_);
    if (check_runs_ > 0) {
      return check(arm, std::move(model), flags);
    }
    refuse_if(out_.empty(), "--out is required: the model with its tube; or --check RUNS");
    refuse_if(disturbed(), "--friction-factor, --load-kg and --actuator-factor need --check RUNS");
    refuse_to_overwrite(out_, flags.force);
    return recordings_.empty() ? calibrate(arm, std::move(model), flags)
                               : from_recordings(arm, std::move(model), flags);
  }

 private:
  void add_family_flags(CLI::App& app) {
    app.add_option("--vary-physics", variation_,
                   "Of a family: how the arms differ that it is calibrated on; else as those that "
                   "it learnt from");
    app.add_option("--identify-s", seconds_,
                   "Of a family: seconds of motion that each arm is known by; else 60")
        ->check(CLI::Range(2.0, 60.0));
  }

  void add_check_flags(CLI::App& app) {
    app.add_option("--check", check_runs_,
                   "Calibrate nothing: measure the coverage of the model's own tube on so many "
                   "runs in random environments about motions of the virtual arm")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--tube", level_, "Level to check, of those that the model carries");
    app.add_option("--friction-factor", friction_, "With --check: of the table's friction")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option("--load-kg", load_kg_, "With --check: more on every plate")
        ->check(CLI::Range(0.0, 10.0));
    app.add_option("--actuator-factor", strength_, "With --check: of the actuators' strength")
        ->check(CLI::Range(0.1, 10.0));
  }

  /// Flags that would be passed over are refused.
  static void exclude_unused(CLI::App& app) {
    CLI::Option* check = app.get_option("--check");
    CLI::Option* recordings = app.get_option("--recordings");
    app.get_option("--tube")->needs(check);
    check->excludes("--out", "--levels", "--confidence", "--recordings", "--plans");
    recordings->excludes("--max-queries", "--time-limit-s", "--valves", "--no-valves");
    for (CLI::Option* option : {check, recordings}) {
      option->excludes("--shape-runs", "--screen-runs", "--test-runs", "--audit-runs", "--folder",
                       "--resume");
    }
  }

  /// A family is calibrated over arms that it has not seen.
  CompensationModel read() {
    CompensationModel model = read_model(model_file_);
    if (!is_family(model)) {
      refuse_if(variation_ || seconds_,
                "--vary-physics and --identify-s are for families; {} is one arm's", model_file_);
      return model;
    }
    refuse_if(!recordings_.empty() || disturbed(),
              "{}: a family's tube is calibrated on virtual arms that vary; --recordings "
              "and disturbances are for one arm's",
              model_file_);
    refuse_if(model_.says_valves(),
              "{}: a family is calibrated on arms that each have valves of their own; leave "
              "--valves and --no-valves out",
              model_file_);
    const auto learnt = model.training.find("physics");
    settings_.runs.unseen.emplace();
    settings_.runs.unseen->variation = parse_physics_variation(
        variation_.value_or(learnt == model.training.end() ? "wide" : learnt->second));
    settings_.runs.unseen->seconds = seconds_.value_or(settings_.runs.unseen->seconds);
    return model;
  }

  bool disturbed() const { return friction_ != 1.0 || load_kg_ != 0.0 || strength_ != 1.0; }

  TubeRunSettings run_settings(const ArmDescription& arm, CompensationModel model,
                               const CommonFlags& flags) const {
    TubeRunSettings runs;
    runs.unseen = settings_.runs.unseen;
    runs.arm = arm;
    runs.executed_arm = arm;
    if (disturbed()) {
      change_virtual_arm(runs.executed_arm, [&](VirtualArmParameters& parameters) {
        parameters.friction_coefficient *= friction_;
        parameters.plate_payload_kg += load_kg_;
        parameters.actuator_gain *= strength_;
      });
    }
    if (!runs.unseen) {
      runs.valves = model_.valves(arm, &model);
    }
    runs.model = std::move(model);
    runs.limits = limits_;
    if (!limits_.queries && !limits_.time_s) {
      runs.limits.queries = kCalibrationQueries;
    }
    take_common(flags, runs);
    return runs;
  }

  int calibrate(const ArmDescription& arm, CompensationModel model, const CommonFlags& flags) {
    settings_.model_file = model_file_;
    settings_.folder = folder_.empty() ? out_ + ".calibration" : folder_;
    take_common(flags, settings_);
    settings_.runs = run_settings(arm, std::move(model), flags);
    const CalibrationResult result = calibrate_tube(settings_);
    for (const std::string& failure : result.failures) {
      print_error(failure);
    }
    if (result.model.tube) {
      write_model(out_, result.model);
    }
    print_result(flags, result.evidence,
                 result.model.tube
                     ? fmt::format("{}\n  evidence: {}/evidence.html", to_text(*result.model.tube),
                                   settings_.folder.string())
                     : "");
    return result.failures.empty() ? kExitDone : kExitNoSolution;
  }

  int from_recordings(const ArmDescription& arm, CompensationModel model,
                      const CommonFlags& flags) const {
    RecordedCalibration settings;
    settings.arm = arm;
    settings.model = model;
    settings.model_hash = file_hash(model_file_);
    settings.plans.assign(plans_.begin(), plans_.end());
    settings.recordings.assign(recordings_.begin(), recordings_.end());
    settings.levels = settings_.levels;
    settings.confidence = settings_.confidence;
    model.tube = tube_from_recordings(settings);
    validate(model, model_file_);
    write_model(out_, model);
    print_result(flags, {{"tube", to_json(*model.tube)}}, to_text(*model.tube));
    return kExitDone;
  }

  int check(const ArmDescription& arm, CompensationModel model, const CommonFlags& flags) {
    refuse_if(!model.tube, "{}: carries no tube to check: limber calibrate --out measures one",
              model_file_);
    const Tube tube = *model.tube;
    const TubeLevel* level = level_ ? tube.find(*level_) : &tube.default_level();
    if (level == nullptr) {
      throw InputError(
          fmt::format("--tube {}: {} carries {}", *level_, model_file_, names_of_levels(tube)));
    }
    TubeRunSettings settings = run_settings(arm, std::move(model), flags);
    const TubePhase phase{"check", check_runs_, &tube, level->factor,
                          settings.unseen ? expected_error_of_tube_m(settings.model) : 0.0};
    Json json = {{"level", level->level}, {"seed", flags.seed}};
    json.update(to_json(run_tube_phase(settings, phase, nullptr), level->factor));
    const auto& coverage = json["coverage"];
    print_result(
        flags, json,
        fmt::format("level {}: {:.2f} % of {} runs inside ({:.2f} to "
                    "{:.2f} %); {} of {} environments solved, {} arrived, "
                    "{} collided; first certified plan {:.2f} ms (median)",
                    level->level, 100.0 * coverage["share"].get<double>(), json["runs"].get<int>(),
                    100.0 * coverage["low"].get<double>(), 100.0 * coverage["high"].get<double>(),
                    json["solved"].get<int>(), json["environments"].get<int>(),
                    json["reached"].get<int>(), json["collided"].get<int>(),
                    1e3 * json["first_solution_s_median"].get<double>()));
    return kExitDone;
  }

  std::string arm_ = "three_segment";
  std::string model_file_;
  ModelFlags model_;
  std::string out_;
  std::string driver_ = "virtual";
  std::vector<std::string> recordings_;
  std::vector<std::string> plans_;
  std::string folder_;
  PlannerLimits limits_;
  CalibrationSettings settings_;
  int check_runs_ = 0;
  std::optional<double> level_;
  std::optional<std::string> variation_;
  std::optional<double> seconds_;
  double friction_ = 1.0;
  double load_kg_ = 0.0;
  double strength_ = 1.0;
};

}  // namespace

std::unique_ptr<Verb> make_calibrate_verb() {
  return std::make_unique<CalibrateVerb>();
}

}  // namespace limber
