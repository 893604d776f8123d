#include "driver_flags.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/hardware/virtual_arm.hpp"
#include "limber/report/execution_picture.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/report/plan_picture.hpp"
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
    driver_.add_to(app);
    app.add_option("--hold-s", settings_.hold_s,
                   "Seconds that the last set point is held in all before the goal is judged")
        ->capture_default_str();
    app.add_option("--max-start-error-m", max_start_error_m_,
                   "Largest distance of a plate from where the plan starts, with exec: only; by "
                   "default the plan's margin, which is what its model errs by, or 1 cm")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--out", out_, "Recording of the run to write");
    app.add_option("--svg", svg_, "Picture of the run to write, beside the prediction");
    app.add_option("--pressures-svg", pressures_svg_,
                   "Set points, predicted and measured pressures over time");
    app.add_option("--animation", animation_, "The same as a page (HTML) in which the arm moves");
  }

  int run(const CommonFlags& flags) override {
    driver_.check();
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_arm(arm_file);
    const Environment environment = load_environment(find_environment_file(environment_), arm);
    const Plan plan = read_plan(plan_);
    require_plan_of(plan, arm, plan_);
    require_within(plan, host_hello(with_scaled_limits(arm, driver_.limit_scale())).limit_kpa,
                   plan_, fmt::format("--limit-scale {}", driver_.limit_scale()));
    if (driver_.is_dry_run()) {
      return DriverFlags::print_dry_run(arm, flags, [&](ArmDriver& driver) {
        (void)execute(arm, environment, plan, driver, settings_);
      });
    }
    out_ = driver_.recording_or_default(out_, flags);
    for (const std::string& file : {out_, svg_, pressures_svg_, animation_}) {
      if (!file.empty()) {
        refuse_to_overwrite(file, flags.force);
      }
    }
    if (!driver_.is_virtual()) {
      const std::unique_ptr<ProcessDriver> driver = driver_.start(arm, arm_file, out_, true, flags);
      require_within(plan, driver->limits_kpa(), plan_, "the driver");
      constexpr double kMeasured_m = 0.01;  // what trackers and a base's frame are off by
      settings_.max_start_error_m =
          max_start_error_m_.value_or(std::max(plan.margin_m, kMeasured_m));
      const ExecutionResult result = execute(arm, environment, plan, *driver, settings_);
      return finish(arm, environment, plan, result, driver.get(), flags);
    }
    VirtualArm driver(arm);
    const ExecutionResult result = execute(arm, environment, plan, driver, settings_);
    return finish(arm, environment, plan, result, nullptr, flags);
  }

 private:
  /// Writes what was asked for and says what came of it. @param driver  null on the virtual arm.
  int finish(const ArmDescription& arm, const Environment& environment, const Plan& plan,
             const ExecutionResult& result, const ProcessDriver* driver,
             const CommonFlags& flags) const {
    write_run(arm, plan, result, driver);
    if (!svg_.empty()) {
      write_file_atomically(svg_, execution_picture(arm, environment, plan, result));
    }
    if (!pressures_svg_.empty()) {
      write_file_atomically(pressures_svg_, pressure_picture(arm, plan, measured_in(result)));
    }
    if (!animation_.empty()) {
      write_file_atomically(animation_, execution_animation(arm, environment, plan, result));
    }
    nlohmann::ordered_json json = execution_to_json(result, environment);
    if (driver != nullptr) {
      json["driver"] = to_json(*driver);
      if (result.status == ExecutionStatus::fault) {
        print_error(result.message);
      }
    }
    print_result(flags, json, execution_to_text(result, environment));
    if (driver != nullptr && !driver->last_vent().confirmed) {
      return kExitFault;
    }
    switch (result.status) {
      case ExecutionStatus::done:
        return kExitDone;
      case ExecutionStatus::fault:
        return kExitFault;
      default:
        return kExitNoSolution;
    }
  }

  static std::vector<Pressures> measured_in(const ExecutionResult& result) {
    std::vector<Pressures> rows;
    for (int t = 0; t < result.episode.frame_count(); ++t) {
      rows.emplace_back(result.episode.pressure_kpa.row(t).transpose());
    }
    return rows;
  }

  void write_run(const ArmDescription& arm, const Plan& plan, const ExecutionResult& result,
                 const ProcessDriver* driver) const {
    if (out_.empty() || result.episode.frame_count() == 0) {
      return;
    }
    Recording recording =
        make_recording(arm, driver != nullptr ? describe(*driver) : "virtual arm", plan.seed);
    recording.settings =
        fmt::format("executed plan, environment '{}', model {}, planner {}, {}",
                    plan.environment_name, plan.model, plan.planner, to_string(result.status));
    recording.episodes = {result.episode};
    write_recording(out_, recording);
  }

  std::string plan_;
  std::string arm_ = "three_segment";
  std::string environment_;
  DriverFlags driver_;
  std::string out_;
  std::string svg_;
  std::string pressures_svg_;
  std::string animation_;
  std::optional<double> max_start_error_m_;
  ExecutionSettings settings_;
};

}  // namespace

std::unique_ptr<Verb> make_execute_verb() {
  return std::make_unique<ExecuteVerb>();
}

}  // namespace limber
