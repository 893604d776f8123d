#include "driver_flags.hpp"

#include <cstdint>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/driver/driver_protocol.hpp"
#include "limber/driver/vented_rest.hpp"
#include "limber/report/driver_report.hpp"
#include "limber/run/arm_driver.hpp"

namespace limber {

namespace {

/// Stands in for a driver in a dry run: hands every line that would be sent to `print`, as the wire
/// has it, and is where it was told to be.
class DryRunDriver final : public ArmDriver {
 public:
  DryRunDriver(const ArmDescription& arm, std::optional<WireCalibration> calibration,
               std::function<void(const std::string& line)> print)
      : period_s_(arm.frame_period_s()),
        calibration_(std::move(calibration)),
        print_(std::move(print)) {
    state_.pressure_kpa = Pressures::Zero(arm.channel_count());
    if (arm.is_spatial()) {
      state_.space_backbone = SpaceBackbone::Zero(arm.point_count(), kSpacePoseSize);
      state_.space_backbone->rightCols<1>().setOnes();  // seen, wherever; headings of no turn
    } else {
      Backbone straight(arm.point_count(), kPoseSize);
      NoLoadModel(arm).backbone(Eigen::Ref<const Eigen::VectorXf>(state_.pressure_kpa),
                                Eigen::Ref<Backbone>(straight));
      state_.backbone = straight;
    }
    HostHello hello = host_hello(arm);
    if (calibration_) {
      hello.limit_kpa = calibration_->to_wire(hello.limit_kpa);
    }
    print_(to_line(hello));
  }

  ~DryRunDriver() override { print_(bye_line()); }

  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override {
    state_.time_s = double(seq_) * period_s_;
    state_.pressure_kpa = setpoint_kpa;
    print_(set_line(seq_, state_.time_s,
                    calibration_ ? calibration_->to_wire(setpoint_kpa) : state_.pressure_kpa));
    ++seq_;
    resting_ = false;
    return state_;
  }

  void vent() noexcept override {
    if (!resting_) {
      print_(vent_line(seq_, double(seq_) * period_s_));
      ++seq_;
      resting_ = true;
    }
  }

 private:
  double period_s_;
  std::optional<WireCalibration> calibration_;
  std::function<void(const std::string&)> print_;
  ArmState state_;
  std::int64_t seq_ = 0;
  bool resting_ = true;
};

constexpr std::string_view kModel = "model:";

}  // namespace

void WireFlags::add_to(CLI::App& app) {
  app.add_option("--calibration", calibration_,
                 "File of limber driver calibrate: channels, "
                 "signs, zeros and the tracker's frame of a driver");
  app.add_flag("--simulated", simulated_,
               "The driver may be a simulation that runs as fast as it is asked (real_time: false "
               "in its hello); not for an arm");
}

ProcessDriverSettings WireFlags::settings(const std::string& driver, const ArmDescription& arm,
                                          const std::string& arm_file) const {
  const std::string command = driver.starts_with(kExec) ? driver.substr(kExec.size()) : "";
  refuse_if(
      command.find_first_not_of(" \t") == std::string::npos,
      "driver '{}': no command found; expected exec:COMMAND, as in \"exec:python3 my_driver.py\" "
      "(docs/driver.md)",
      driver);
  ProcessDriverSettings settings;
  settings.command = command;
  settings.simulated = simulated_;
  settings.safety = load_safety(arm_file);
  settings.calibration = calibration(arm);
  return settings;
}

std::optional<WireCalibration> WireFlags::calibration(const ArmDescription& arm) const {
  if (!is_calibrated()) {
    return std::nullopt;
  }
  WireCalibration calibration = read_wire_calibration(calibration_);
  require_calibration_of(calibration, arm, calibration_);
  return calibration;
}

std::function<void(const std::string&)> tell_of_arm(bool all) {
  return [all](const std::string& message) {
    if (all || !message.starts_with("vented:")) {
      print_to_stderr(printable(message) + "\n");
    }
  };
}

void DriverFlags::add_to(CLI::App& app, bool may_be_model) {
  command_ = &app;
  may_be_model_ = may_be_model;
  std::string help =
      "What moves: virtual; exec:COMMAND, a program that speaks limber's protocol "
      "(docs/driver.md), started without a shell";
  if (may_be_model) {
    help += "; or model:OTHER.safetensors, an arm that is what another network says";
  }
  app.add_option("--driver", driver_, help)->capture_default_str();
  wire_.add_to(app);
  app.add_option("--limit-scale", limit_scale_,
                 "Factor on the arm's pressure limits, over 0 and at most 1")
      ->capture_default_str();
  app.add_option("--driver-log", log_,
                 "What limber and the driver said to each other, one "
                 "JSON object per line; by default beside the recording");
  app.add_flag("--dry-run", dry_run_, "Print the requests that a driver would get; move nothing");
}

void require_limit_scale(double scale) {
  refuse_if(!(scale > 0.0 && scale <= 1.0), "--limit-scale {}: expected a number over 0, at most 1",
            scale);
}

void DriverFlags::check(std::initializer_list<const char*> unused) const {
  if ((is_program() && !driver_.starts_with(kExec)) || driver_ == kModel) {
    throw InputError(
        fmt::format("--driver {}: expected virtual{} or exec:COMMAND, as in "
                    "--driver \"exec:python3 my_driver.py\"",
                    driver_, may_be_model_ ? ", model:FILE.safetensors" : ""));
  }
  require_limit_scale(limit_scale_);
  refuse_if(!is_program() && wire_.may_be_simulated(),
            "--simulated: goes with --driver exec:COMMAND, which may be a simulation");
  refuse_if(!is_program() && wire_.is_calibrated(),
            "--calibration: goes with --driver exec:COMMAND, which it is of");
  refuse_if(!is_program() && !log_.empty(),
            "--driver-log: the virtual arm has none; it goes with --driver exec:COMMAND");
  std::vector<const char*> without_use(unused);
  without_use.push_back("--driver-log");
  for (const char* flag : without_use) {
    refuse_if(dry_run_ && command_->count(flag) > 0,
              "{}: --dry-run moves nothing, and has no use for it", flag);
  }
}

bool DriverFlags::is_model() const {
  return may_be_model_ && driver_.starts_with(kModel);
}

std::string DriverFlags::model_file() const {
  return driver_.substr(kModel.size());
}

std::string DriverFlags::recording_or_default(const std::string& out,
                                              const CommonFlags& flags) const {
  if (!out.empty() || !is_program() || dry_run_) {
    return out;
  }
  const std::string name = free_name(time_stamped_run_name(), "_", ".h5");
  say(flags, "{}: every run on an arm is recorded; --out names the file", name);
  return name;
}

std::unique_ptr<ProcessDriver> DriverFlags::start(const ArmDescription& arm,
                                                  const std::string& arm_file,
                                                  const std::string& out, bool check_rate,
                                                  const CommonFlags& flags) const {
  ProcessDriverSettings settings = wire_.settings(driver_, arm, arm_file);
  settings.limit_scale = limit_scale_;
  settings.check_rate = check_rate;
  if (log_.empty()) {
    settings.log = free_name(out + ".driver", ".", ".jsonl");
  } else {
    refuse_to_overwrite(log_, flags.force);
    settings.log = log_;
  }
  settings.say = tell_of_arm(!flags.quiet);
  return std::make_unique<ProcessDriver>(arm, settings);
}

int DriverFlags::print_dry_run(const ArmDescription& arm, const CommonFlags& flags,
                               const std::function<void(ArmDriver&)>& move) const {
  std::vector<std::string> lines;
  {
    DryRunDriver driver(arm, wire_.calibration(arm),
                        [&](const std::string& line) { lines.push_back(line); });
    move(driver);
  }
  Json json = {{"dry_run", true}, {"requests", Json::array()}};
  if (flags.json) {
    for (const std::string& line : lines) {
      json["requests"].push_back(Json::parse(line));
    }
  }
  print_result(flags, json, fmt::format("{}", fmt::join(lines, "\n")));
  return kExitDone;
}

void require_within(const Plan& plan, const std::vector<PressureLimits>& limits_kpa,
                    const std::string& file, const std::string& whose) {
  if (const auto found = first_beyond(plan, limits_kpa)) {
    throw InputError(
        fmt::format("{}: {}: set point of {} is {:.1f} {unit}; {} allows {} {unit}. Nothing was "
                    "moved; plan again within that: limber plan --limit {}:{:.6g},{:.6g}",
                    file, frame_name(found->frame), segment_name(found->segment), found->value,
                    whose, to_string(found->limits), found->segment, found->limits.lower_kpa,
                    found->limits.upper_kpa, fmt::arg("unit", plan.command.unit)));
  }
}

void require_reach(const ArmDescription& arm, double limit_scale, const ProcessDriver& driver) {
  if (const auto found = first_short_reach(arm, limit_scale, driver.limits_kpa())) {
    throw InputError(advice(*found, arm, driver.limits_kpa(), "--limit-scale {:g}"));
  }
}

ArmStart measured_start(const ArmDescription& arm, const std::string& arm_file,
                        const std::string& driver, const WireFlags& wire) {
  ProcessDriverSettings settings = wire.settings(driver, arm, arm_file);
  settings.say = tell_of_arm(false);
  ProcessDriver started(arm, settings);
  return vented_rest(arm, started);
}

Json to_json(const ProcessDriver& driver) {
  const VentResult& vent = driver.last_vent();
  const DriverTiming& timing = driver.timing();
  return {{"driver", driver.hello().driver},
          {"device", driver.hello().device},
          {"late_ms", times_in_ms(timing.late_s)},
          {"round_trip_ms", times_in_ms(timing.round_trip_s)},
          {"skipped_slots", timing.skipped_slots},
          {"frames_without_backbone", timing.frames_unseen},
          {"vent",
           {{"confirmed", vent.confirmed},
            {"pressure_kpa", vent.pressure_kpa},
            {"after_s", vent.after_s},
            {"message", vent.message}}}};
}

}  // namespace limber
