#include <string_view>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/report/execution_picture.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_picture.hpp"
#include "limber/trial/model_arm.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class ExecuteVerb final : public Verb {
 public:
  const char* name() const override { return "execute"; }
  const char* summary() const override { return "Run a plan on an arm, open loop"; }
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
    app.add_option("--driver", driver_,
                   "What moves: virtual, or model:OTHER.safetensors, an arm that is what another "
                   "network says (with the valves that it learnt)")
        ->capture_default_str();
    app.add_option("--hold-s", settings_.hold_s,
                   "Seconds that the last set point is held in all before the goal is judged")
        ->capture_default_str();
    app.add_option("--out", out_, "Recording of the run to write");
    app.add_option("--svg", svg_, "Picture of the run to write, beside the prediction");
    app.add_option("--pressures-svg", pressures_svg_,
                   "Set points, predicted and measured pressures over time");
    app.add_option("--animation", animation_, "The same as a page (HTML) in which the arm moves");
  }

  int run(const CommonFlags& flags) override {
    if (driver_ != "virtual" && !driver_.starts_with(kModelDriver)) {
      throw InputError(
          fmt::format("--driver {}: expected virtual or model:FILE.safetensors", driver_));
    }
    const ArmDescription arm = load_arm(find_arm_file(arm_));
    const Environment environment = load_environment(find_environment_file(environment_), arm);
    const Plan plan = read_plan(plan_);
    require_plan_of(plan, arm, plan_);
    for (const std::string& file : {out_, svg_, pressures_svg_, animation_}) {
      if (!file.empty()) {
        refuse_to_overwrite(file, flags.force);
      }
    }
    const ExecutionResult result = run_on_driver(arm, environment, plan);
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
  static constexpr std::string_view kModelDriver = "model:";

  ExecutionResult run_on_driver(const ArmDescription& arm, const Environment& environment,
                                const Plan& plan) const {
    if (driver_.starts_with(kModelDriver)) {
      CompensationModel network = read_model(driver_.substr(kModelDriver.size()));
      const ValveParameters valves = network.valves.value_or(ValveParameters{});
      ModelArm driver(arm, std::move(network), valves);
      return execute(arm, environment, plan, driver, settings_);
    }
    VirtualArm driver(arm);
    return execute(arm, environment, plan, driver, settings_);
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
    Recording recording =
        make_recording(arm, driver_ == "virtual" ? std::string("virtual arm") : driver_, plan.seed);
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
};

}  // namespace

std::unique_ptr<Verb> make_execute_verb() {
  return std::make_unique<ExecuteVerb>();
}

}  // namespace limber
