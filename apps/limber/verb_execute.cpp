#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/report/execution_picture.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/trial/replanner.hpp"
#include "model_flags.hpp"
#include "room_flags.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class ExecuteVerb final : public Verb {
 public:
  const char* name() const override { return "execute"; }
  const char* summary() const override { return "Run a plan on an arm, open or closed loop"; }
  const char* example() const override {
    return "limber execute --plan plan.json --environment environments/01_pillar.yaml --out run.h5";
  }

  void add_flags(CLI::App& app) override {
    app.add_option("--plan", plan_, "Plan to run, as `limber plan` wrote it")->required();
    app.add_option("--arm", arm_, "Arm file, or the name of one of limber's own")
        ->capture_default_str();
    app.add_option("--environment", environment_,
                   "Environment that the plan was made for; or the name of one of limber's own")
        ->required();
    app.add_option("--driver", driver_, "The arm that moves: virtual")->capture_default_str();
    app.add_option("--hold-s", settings_.hold_s,
                   "Seconds in all that the last set point is held before the goal is judged")
        ->capture_default_str();
    app.add_flag("--replan", replan_,
                 "Closed loop: plan again, with --model, from where the arm is measured, until it "
                 "comes no nearer to the goal's centre");
    app.add_option("--max-replans", replanning_.max_replans, "With --replan")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--replan-queries", replanning_.queries, "Model queries of each search")
        ->check(CLI::Range(std::uint64_t{100}, std::uint64_t{1'000'000'000}))
        ->capture_default_str();
    model_.add_to(app, " that the plan was made with; for --replan");
    room_.add_to(app);
    app.add_option("--out", out_, "Recording of the run to write");
    app.add_option("--svg", svg_, "Picture to write: the run and its prediction");
    app.add_option("--pressures-svg", pressures_svg_,
                   "Picture to write: set points, predicted and measured pressures over time");
    app.add_option("--animation", animation_, "Page (HTML) to write, in which the arm moves");
  }

  int run(const CommonFlags& flags) override {
    if (driver_ != "virtual") {
      throw InputError(fmt::format("--driver {}: expected virtual", driver_));
    }
    const ArmDescription arm = load_asked_arm(arm_);
    const Environment environment = load_environment(find_environment_file(environment_), arm);
    const Plan plan = read_plan(plan_);
    require_plan_of(plan, arm, plan_);
    for (const std::string& file : {out_, svg_, pressures_svg_, animation_}) {
      if (!file.empty()) {
        refuse_to_overwrite(file, flags.force);
      }
    }
    VirtualArm driver(arm);
    const ExecutionResult result = run_plan(arm, environment, plan, driver, flags);
    write_run(arm, plan, result);
    if (!svg_.empty()) {
      write_file_atomically(svg_, execution_picture(arm, environment, plan, result));
    }
    if (!pressures_svg_.empty()) {
      write_file_atomically(pressures_svg_, pressure_picture(arm, plan, measured_in(result)));
    }
    if (!animation_.empty()) {
      write_file_atomically(animation_, execution_animation(arm, environment, plan, result));
    }
    print_result(flags, execution_to_json(result, environment),
                 execution_to_text(result, environment));
    switch (result.status) {
      case ExecutionStatus::done:
        return kExitDone;
      case ExecutionStatus::fault:
        return kExitFault;
      default:
        return kExitNoSolution;
    }
  }

 private:
  template <class Driver>
  ExecutionResult run_plan(const ArmDescription& arm, const Environment& environment,
                           const Plan& plan, Driver& driver, const CommonFlags& flags) const {
    if (!replan_) {
      return execute(arm, environment, plan, driver, settings_);
    }
    const ForwardModel forward = model_.forward_model(arm);
    const MotionModel model = model_.motion_model(arm, forward);
    model_.warn_without_valves(model, flags);
    Replanner replanner(arm, model, environment, room_.room(forward, flags), replanning_,
                        flags.seed);
    ExecutionSettings closed_loop = settings_;
    closed_loop.replanner = &replanner;
    return execute(arm, environment, plan, driver, closed_loop);
  }

  static std::vector<Pressures> measured_in(const ExecutionResult& result) {
    std::vector<Pressures> rows;
    for (int t = 0; t < result.episode.frame_count(); ++t) {
      rows.emplace_back(result.episode.pressure_kpa.row(t).transpose());
    }
    return rows;
  }

  void write_run(const ArmDescription& arm, const Plan& plan, const ExecutionResult& result) const {
    if (out_.empty() || result.episode.frame_count() == 0) {
      return;
    }
    Recording recording = make_recording(arm, "virtual arm", plan.seed);
    recording.settings =
        fmt::format("executed plan, environment '{}', model {}, planner {}, {}",
                    plan.environment_name, plan.model, plan.planner, to_string(result.status));
    recording.episodes = {result.episode};
    write_recording(out_, recording);
  }

  std::string plan_;
  std::string arm_ = "three_segment";
  std::string environment_;
  std::string driver_ = "virtual";
  std::string out_;
  std::string svg_;
  std::string pressures_svg_;
  std::string animation_;
  ExecutionSettings settings_;
  bool replan_ = false;
  ModelFlags model_;
  RoomFlags room_;
  ReplannerSettings replanning_;
};

}  // namespace

std::unique_ptr<Verb> make_execute_verb() {
  return std::make_unique<ExecuteVerb>();
}

}  // namespace limber
