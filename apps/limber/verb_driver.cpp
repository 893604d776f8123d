#include "driver_calibrate.hpp"
#include "driver_flags.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_findings.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/driver/driver_check.hpp"
#include "limber/report/driver_report.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

namespace fs = std::filesystem;

class DriverVerb final : public Verb {
 public:
  const char* name() const override { return "driver"; }
  const char* summary() const override {
    return "Check a driver (timing, units, valves, deadmen), or calibrate it";
  }
  const char* example() const override {
    return "limber driver check --driver \"exec:limber virtual-arm --serve\" --out checked\n"
           "  limber driver calibrate --driver \"exec:limber virtual-arm --serve "
           "--fast --misassembled 1\" --simulated --yes --handedness left --out calibration.yaml";
  }

  void add_flags(CLI::App& app) override {
    app.add_option("action", action_, "check or calibrate")
        ->option_text("check|calibrate")
        ->required();
    add_arm_flag(app, arm_);
    app.add_option("--driver", driver_, "exec:COMMAND, the program (docs/driver.md)")->required();
    app.add_option(
           "--limit-scale", limit_scale_,
           "check: pressure limits are this times the arm's, over 0 and at most 1; calibrate "
           "always moves within a tenth")
        ->capture_default_str();
    app.add_option("--out", out_,
                   "check: folder for check.json, report.html, valves.yaml and the driver's log; "
                   "calibrate: the calibration's file")
        ->required();
    wire_.add_to(app);
    calibrate_.add_to(app);
  }

  int run(const CommonFlags& flags) override {
    if (action_ != "check" && action_ != "calibrate") {
      throw InputError(fmt::format(
          "limber driver {}: expected 'limber driver check' or 'limber driver calibrate'",
          action_));
    }
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_any_arm(arm_file, PolynomialsOf::characterisation);
    if (action_ == "calibrate") {
      require_planar(arm, "limber driver calibrate");
      if (wire_.is_calibrated()) {
        throw InputError("--calibration: calibrate finds one; it goes with check");
      }
      return calibrate_.run(arm, wire_.settings(driver_, arm, arm_file), out_, flags);
    }
    const fs::path folder = out_;
    require_writable_folder(folder);
    for (const char* file : {"check.json", "report.html", "valves.yaml", "check.driver.jsonl"}) {
      refuse_to_overwrite(folder / file, flags.force);
    }
    ProcessDriverSettings settings = wire_.settings(driver_, arm, arm_file);
    fs::create_directories(folder);
    settings.limit_scale = limit_scale_;
    settings.log = folder / "check.driver.jsonl";
    settings.say = [&](const std::string& message) { print_to_stderr(printable(message) + "\n"); };
    say(flags, "checking the driver: the arm moves for about a minute");
    const DriverCheck check = check_driver(arm, settings);
    return report(arm, check, flags);
  }

 private:
  int report(const ArmDescription& arm, const DriverCheck& check, const CommonFlags& flags) const {
    const fs::path folder = out_;
    const IdentifiedValves valves = identify_valves({check.episode}, arm, "driver check");
    const nlohmann::ordered_json json = to_json(check, valves);
    write_file_atomically(folder / "check.json", json.dump(2) + "\n");
    write_file_atomically(folder / "report.html", driver_check_to_html(check, valves));
    if (!valves.parameters.is_ideal()) {
      write_valves(folder / "valves.yaml", valves);
    }
    print_result(flags, json,
                 to_text(check) + "\n  " + to_text(valves) +
                     fmt::format("\n{}: report.html{}", out_,
                                 valves.parameters.is_ideal()
                                     ? ""
                                     : ", and valves.yaml for `limber plan --valves`"));
    if (!check.complaints.empty()) {
      print_error(check.complaints.front());
      return kExitNoSolution;
    }
    return kExitDone;
  }

  std::string action_;
  std::string arm_ = "three_segment";
  std::string driver_;
  std::string out_;
  WireFlags wire_;
  DriverCalibrate calibrate_;
  double limit_scale_ = 1.0;
};

}  // namespace

std::unique_ptr<Verb> make_driver_verb() {
  return std::make_unique<DriverVerb>();
}

}  // namespace limber
