#include "driver_flags.hpp"
#include "further_plans.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/track_report.hpp"
#include "limber/run/closed_loop.hpp"
#include "limber/run/model_arm.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "model_flags.hpp"
#include "plan_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class ExecuteVerb final : public Verb {
 public:
  ExecuteVerb()
      : Verb("execute", "Run a plan on an arm, open or closed loop, or follow a path with its tip",
             "limber execute --plan plan.json --environment 01_pillar --out run.h5") {}

  void add_flags(CLI::App& app) override {
    app.add_option("--plan", plan_, "Plan to run, as `limber plan` wrote it");
    add_arm_flag(app, arm_);
    app.add_option("--environment", environment_,
                   "Environment that the plan was made for; or the name of one of limber's own");
    track_.add_to(app);
    driver_.add_to(app, true);
    app.add_option("--hold-s", settings_.hold_s,
                   "Seconds in all that the last set point is held before the goal is judged")
        ->capture_default_str()
        ->excludes(app.get_option("--track"));
    app.add_option("--max-start-error-m", max_start_error_m_,
                   "Largest distance of a plate from where the plan starts; by default with exec: "
                   "the plan's margin, which is its model's error, or 1 cm if that is more")
        ->check(at_least_zero())
        ->excludes(app.get_option("--track"));
    replan_.add_to(app);
    app.add_option("--disturbance", disturbance_,
                   "The virtual arm is not as it was: " + disturbance_kinds() +
                       "; several at once with commas between; sampled from --seed. A program "
                       "(exec:) can have the obstacle, which exists for limber alone");
    model_.add_to(app, ": the one that the plan was made with, for --replan; any, for --track");
    app.get_option("--no-load")->description("The no-load model alone, for --track");
    room_.add_to(app);
    for (const char* name : {"--margin-m", "--tube", "--goal-margin-m", "--goal-margin-rad"}) {
      app.get_option(name)->needs(app.get_option("--replan"));
    }
    app.add_option("--out", out_, "Recording of the run to write");
    app.add_option(
        "--adapted-out", adapted_out_,
        "With --replan and a model that limber adapt made: the model to write, with what "
        "the run told about the arm; it has no tube");
    further_plans_.add_to(app);
    app.add_option("--svg", svg_, "Picture to write: the run and its prediction");
    app.add_option("--pressures-svg", pressures_svg_,
                   "Picture to write: set points, predicted and measured pressures over time");
    app.add_option(
        "--times-svg", times_svg_,
        "Picture to write: pressures, tip and clearance over time, predicted and measured");
    app.add_option("--animation", animation_, "Page (HTML) to write, in which the arm moves");
  }

  int run(const CommonFlags& flags) override {
    if (driver_.is_dry_run() && (replan_.is_asked_for() || track_.is_asked())) {
      throw InputError(fmt::format("--dry-run: what {} commands depends on what is measured",
                                   track_.is_asked() ? "--track" : "--replan"));
    }
    driver_.check({"--disturbance", "--model", "--no-load", "--valves", "--no-valves",
                   "--adapted-out", "--plans-out", "--svg", "--pressures-svg", "--times-svg",
                   "--animation"});
    const std::vector<Disturbance> disturbances = parse_disturbances(disturbance_);
    refuse_what_cannot_be_disturbed(disturbances);
    const std::string arm_file = find_arm_file(arm_);
    ArmDescription arm = load_asked_arm(arm_file, "limber execute");
    if (track_.is_asked()) {
      return track(arm, arm_file, disturbances, flags);
    }
    if (plan_.empty() || environment_.empty()) {
      throw InputError(fmt::format("{} is required, unless --track follows a path",
                                   plan_.empty() ? "--plan" : "--environment"));
    }
    refuse_if(replan_.is_asked_for() && !model_.names_model(),
              "--replan: needs a network to plan with; give --model MODEL.safetensors");
    const Environment environment = load_environment(find_environment_file(environment_), arm);
    room_.require_use(environment);
    const Plan plan = read_plan(plan_);
    require_plan_of(plan, arm, plan_);
    arm = at_rate_of(plan.arm(), std::move(arm), plan_);
    require_plan_in(plan, environment, plan_);
    replan_.settings().corrections.limits =
        limits_of(with_scaled_limits(arm, driver_.limit_scale()));
    require_within(plan, replan_.settings().corrections.limits, plan_,
                   fmt::format("--limit-scale {}", driver_.limit_scale()));
    if (driver_.is_dry_run()) {
      return driver_.print_dry_run(arm, flags, [&](ArmDriver& driver) {
        (void)execute(arm, environment, plan, driver, settings_);
      });
    }
    out_ = driver_.recording_or_default(out_, flags);
    refuse_to_overwrite_any(flags);
    further_plans_.prepare({plan_, environment_, model_.model_file()}, flags);
    settings_.max_start_error_m = max_start_error_m_;
    const DisturbedArm met = disturbed(arm, plan, disturbances, flags.seed);
    settings_.obstacle = met.obstacle ? &*met.obstacle : nullptr;
    return with_driver(arm, arm_file, met, flags, [&](auto& driver, const ProcessDriver* program) {
      if (program != nullptr) {
        require_within(plan, program->limits_kpa(), plan_, "the driver");
        settings_.max_start_error_m = max_start_error_m_.value_or(allowed_start_error_m(plan));
      }
      const ExecutionResult result = run_plan(arm, environment, plan, driver, flags);
      return finish(arm, environment, plan, result, program, flags);
    });
  }

 private:
  /// Makes what --driver names. @param use  is given it, and again as a program; null: it is none
  /// @return what `use` does
  template <class Use>
  int with_driver(const ArmDescription& arm, const std::string& arm_file, const DisturbedArm& met,
                  const CommonFlags& flags, const Use& use) const {
    if (driver_.is_program()) {
      const std::unique_ptr<ProcessDriver> driver = driver_.start(arm, arm_file, out_, true, flags);
      return use(*driver, driver.get());
    }
    if (driver_.is_model()) {
      CompensationModel network = read_model_of_one_arm(driver_.model_file(), arm);
      const ValveParameters valves = network.valves.value_or(ValveParameters{});
      ModelArm driver(arm, std::move(network), valves);
      return use(driver, nullptr);
    }
    VirtualArm driver(met.arm, met.options);
    return use(driver, nullptr);
  }

  void refuse_what_cannot_be_disturbed(const std::vector<Disturbance>& disturbances) const {
    const bool is_obstacle =
        disturbances.size() == 1 && has_kind(disturbances, DisturbanceKind::obstacle);
    if (disturbances.empty() || driver_.is_virtual() || (driver_.is_program() && is_obstacle)) {
      return;
    }
    throw InputError(
        "--disturbance: only the virtual arm can be disturbed (--driver virtual, or --driver "
        "\"exec:limber virtual-arm --serve --disturbance …\"); a program (exec:) can have the "
        "obstacle alone");
  }

  void refuse_to_overwrite_any(const CommonFlags& flags) const {
    refuse_to_overwrite_given({out_, adapted_out_, svg_, pressures_svg_, times_svg_, animation_},
                              flags);
    refuse_if(further_plans_.are_asked_for() && !replan_.is_asked_for(),
              "--plans-out: plans after the first are made by --replan; give that too");
    require_something_adapts();
    const bool names_model = model_.names_model() || model_.asks_no_load() || model_.says_valves();
    refuse_if(
        names_model && !replan_.is_asked_for() && !track_.is_asked(),
        "--model, --no-load, --valves and --no-valves: in open loop nothing is predicted; they "
        "go with --track, and all but --no-load with --replan");
  }

  void require_something_adapts() const {
    if (adapted_out_.empty() && !replan_.says_adapt()) {
      return;
    }
    const bool can_adapt = replan_.is_asked_for() &&
                           read_model_of_one_arm(model_.model_file()).member_of_family.has_value();
    if (!can_adapt || (!adapted_out_.empty() && !replan_.settings().adapts)) {
      throw InputError(fmt::format(
          "{}: nothing would be adapted; expected --replan, a model that limber adapt made{}",
          adapted_out_.empty() ? "--adapt" : "--adapted-out",
          adapted_out_.empty() ? "" : ", and no --no-adapt"));
    }
  }

  /// Follows a path with the tip; docs/tracking.md.
  int track(const ArmDescription& arm, const std::string& arm_file,
            const std::vector<Disturbance>& disturbances, const CommonFlags& flags) {
    using Given = std::pair<const char*, bool>;
    for (const auto& [flag, value] :
         {Given{"--plan", !plan_.empty()}, Given{"--adapted-out", !adapted_out_.empty()},
          Given{"--replan", replan_.is_asked_for()},
          Given{"--plans-out", further_plans_.are_asked_for()},
          Given{"--pressures-svg", !pressures_svg_.empty()},
          Given{"--times-svg", !times_svg_.empty()}, Given{"--animation", !animation_.empty()}}) {
      if (value) {
        throw InputError(std::string(flag) + " belongs to a plan; leave it out with --track");
      }
    }
    for (const Disturbance& one : disturbances) {
      if (one.kind == DisturbanceKind::obstacle || one.kind == DisturbanceKind::lost_tracking ||
          one.kind == DisturbanceKind::picked_up || one.kind == DisturbanceKind::leak) {
        throw InputError(fmt::format("--disturbance {}: is sampled for a plan; not with --track",
                                     to_string(one.kind)));
      }
    }
    const Environment environment =
        environment_.empty() ? Environment{}
                             : load_environment(find_environment_file(environment_), arm);
    out_ = driver_.recording_or_default(out_, flags);
    refuse_to_overwrite_any(flags);
    track_.prepare(arm, model_, flags);
    const DisturbedArm met = disturbed(arm, Plan{}, disturbances, flags.seed);
    return with_driver(arm, arm_file, met, flags, [&](auto& driver, const ProcessDriver* program) {
      const std::vector<PressureLimits> limits =
          program != nullptr ? program->limits_kpa()
                             : limits_of(with_scaled_limits(arm, driver_.limit_scale()));
      return finish_track(arm, track_.run(arm, environment, driver, limits, flags), program, flags);
    });
  }

  int finish_track(const ArmDescription& arm, const TrackRun& run, const ProcessDriver* driver,
                   const CommonFlags& flags) const {
    if (is_to_record(run.result)) {
      Recording recording = make_recording(arm, source_of(driver), flags.seed);
      recording.settings = fmt::format("tracked a path with the tip, model {}, {}",
                                       model_.model_file(), to_string(run.result.status));
      recording.episodes = {run.result.episode};
      write_recording(out_, recording);
    }
    write_given(svg_, [&] { return track_picture(run); });
    Json json = to_json(run);
    json["seed"] = flags.seed;
    if (!disturbance_.empty()) {
      json["disturbance"] = disturbance_;
    }
    if (driver != nullptr) {
      json["driver"] = to_json(*driver);
    }
    print_result(flags, json, to_text(run));
    return end(run.result, driver);
  }

  /// The exit code, after the reason of one that is not 0.
  static int end(const ExecutionResult& result, const ProcessDriver* driver) {
    if (!result.message.empty()) {
      print_error(result.message);
    }
    if (result.status == ExecutionStatus::fault ||
        (driver != nullptr && !driver->last_vent().confirmed)) {
      return kExitFault;
    }
    return result.message.empty() ? kExitDone : kExitNoSolution;
  }

  template <class Driver>
  ExecutionResult run_plan(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan, Driver& driver, const CommonFlags& flags) {
    if (!replan_.is_asked_for()) {
      return execute(arm, environment, plan, driver, settings_);
    }
    const ForwardModel forward = model_.planning_model(arm);
    const MotionModel model = model_.motion_model(arm, forward);
    model_.warn_without_valves(model, flags);
    replan_.choose_motion_queries(arm, model, std::nullopt, flags);
    ClosedLoop loop(arm, model, environment, room_.room(forward, flags), replan_.settings(),
                    flags.seed);
    ExecutionSettings closed_loop = settings_;
    closed_loop.controller = &loop;
    closed_loop.on_frame = [&flags](const ExecutedFrame& frame) {
      if (!frame.noticed.empty()) {
        say(flags, "{}", frame.noticed);
      }
    };
    if constexpr (requires { driver.look(); }) {
      driver.look();  // since it was started, a network was read
    }
    ExecutionResult result = execute(arm, environment, plan, driver, closed_loop);
    further_plans_.take(loop);
    return result;
  }

  /// Writes what was asked for and says what came of it. @param driver  null on the virtual arm.
  int finish(const ArmDescription& arm, const Environment& environment, const Plan& plan,
             const ExecutionResult& result, const ProcessDriver* driver, const CommonFlags& flags) {
    write_run(arm, plan, result, driver, flags);
    further_plans_.write(model_.model_file());
    write_adapted(result);
    write_given(svg_, [&] { return execution_picture(arm, environment, plan, result); });
    write_given(pressures_svg_, [&] { return execution_pressures_picture(arm, plan, result); });
    write_given(times_svg_,
                [&] { return execution_times_picture(arm, environment, plan, result); });
    write_given(animation_, [&] { return execution_animation(arm, environment, plan, result); });
    Json json = to_json(result, environment);
    if (replan_.is_asked_for()) {
      json["motion_queries"] = replan_.settings().motion_queries;
    }
    if (!disturbance_.empty()) {
      json["disturbance"] = disturbance_;
    }
    std::string text = to_text(result, environment);
    if (depends_on_seed()) {
      json["seed"] = flags.seed;
      text += fmt::format("; seed {}", flags.seed);
    }
    if (driver != nullptr) {
      json["driver"] = to_json(*driver);
    }
    print_result(flags, json, text);
    return end(result, driver);
  }

  std::string source_of(const ProcessDriver* driver) const {
    if (driver != nullptr) {
      return describe(*driver);
    }
    const std::string arm = disturbance_.empty() ? "virtual arm" : "virtual arm, " + disturbance_;
    return driver_.is_model() ? "model:" + driver_.model_file() : arm;
  }

  /// Whether the run has chance of its own, beside that of the plan.
  bool depends_on_seed() const { return replan_.is_asked_for() || !disturbance_.empty(); }

  /// Of an arm that nobody saw there is no recording, and whoever waits for one is told.
  bool is_to_record(const ExecutionResult& result) const {
    if (out_.empty()) {
      return false;
    }
    const bool is_seen = result.episode.frame_count() > 0;
    if (!is_seen) {
      print_error(out_ + ": not written, as the arm was never seen");
    }
    return is_seen;
  }

  void write_run(const ArmDescription& arm, const Plan& plan, const ExecutionResult& result,
                 const ProcessDriver* driver, const CommonFlags& flags) const {
    if (!is_to_record(result)) {
      return;
    }
    const std::optional<std::uint64_t> motion_queries =
        replan_.is_asked_for() ? std::optional(replan_.settings().motion_queries) : std::nullopt;
    Recording recording = recording_of(arm, source_of(driver), plan, result, motion_queries);
    if (depends_on_seed()) {
      recording.seed = flags.seed;
    }
    write_recording(out_, recording);
  }

  /// For the next day.
  void write_adapted(const ExecutionResult& result) const {
    if (adapted_out_.empty() || !result.arm) {
      return;
    }
    write_model(adapted_out_, model_after_run(read_model(model_.model_file()), *result.arm));
  }

  std::string plan_;
  std::string arm_ = "three_segment";
  std::string environment_;
  DriverFlags driver_;
  std::string disturbance_;
  std::string out_;
  std::string adapted_out_;
  FurtherPlans further_plans_;
  std::string svg_;
  std::string pressures_svg_;
  std::string times_svg_;
  std::string animation_;
  std::optional<double> max_start_error_m_;
  ExecutionSettings settings_;
  ReplanFlags replan_;
  ModelFlags model_;
  RoomFlags room_;
  TrackFlags track_;
};

}  // namespace

std::unique_ptr<Verb> make_execute_verb() {
  return std::make_unique<ExecuteVerb>();
}

}  // namespace limber
