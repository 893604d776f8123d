#include <poll.h>
#include <unistd.h>
#include <optional>
#include <string>
#include <vector>

#include "driver_flags.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/valve_identification.hpp"
#include "limber/driver/calibrate_driver.hpp"
#include "limber/driver/driver_check.hpp"
#include "limber/report/driver_report.hpp"
#include "verb.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

/// A line from standard input, without its end. Ctrl-C is seen while it waits.
/// @throws Interrupted, also at the end of the input: then nobody is there.
std::string operator_line() {
  constexpr int kPollMs = 100;
  constexpr std::size_t kMaxLine = 1000;
  std::string line;
  while (line.size() < kMaxLine) {
    throw_if_interrupted();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, kPollMs) <= 0) {
      continue;
    }
    char letter = 0;
    if (::read(STDIN_FILENO, &letter, 1) != 1) {
      throw Interrupted(
          "stopped: standard input ended, so nobody confirmed the next step; --yes confirms all");
    }
    if (letter == '\n') {
      return line;
    }
    line += letter;
  }
  return line;
}

void ask(const std::string& question) {
  print_to_stderr(printable(question));
}

/// Enter goes on, anything else ends it.
void wait_for_operator(const std::string& step) {
  ask(step + ". Enter goes on, q ends: ");
  if (!operator_line().empty()) {
    throw Interrupted("stopped on request, between two steps: the arm is vented");
  }
}

Json to_json(const std::optional<TimeInterval>& time) {
  return time ? Json{{"value_s", time->value_s}, {"low_s", time->low_s}, {"high_s", time->high_s}}
              : Json();
}

Json to_json(const std::vector<WireChannel>& channels) {
  return mapped<Json>(channels, [&](const WireChannel& one) {
    return Json{{"channel", one.channel}, {"sign", one.sign > 0.0 ? 1 : -1}};
  });
}

Json to_json(const std::optional<TrackerPlane>& plane) {
  if (!plane) {
    return nullptr;
  }
  const auto list = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  return {{"origin", list(plane->origin)},
          {"x_axis", list(plane->x_axis)},
          {"y_axis", list(plane->y_axis)},
          {"out_of_plane_m", plane->out_of_plane_m},
          {"tilt_rad", plane->tilt_rad}};
}

Json to_json(const WireCalibration& calibration) {
  const TrackerCalibration& tracker = *calibration.tracker;
  return {{"valves", to_json(calibration.valves)},
          {"sensors", to_json(calibration.sensors)},
          {"zero_kpa", calibration.zero_kpa},
          {"noise_kpa", calibration.noise_kpa},
          {"metres_per_unit", tracker.metres_per_unit},
          {"radians_per_unit", tracker.radians_per_unit},
          {"mirrored", tracker.mirrored},
          {"base",
           {{"x_m", tracker.base.x_m},
            {"y_m", tracker.base.y_m},
            {"theta_rad", tracker.base.theta_rad}}},
          {"position_interval_m", tracker.position_interval_m},
          {"heading_interval_rad", tracker.heading_interval_rad},
          {"plane", to_json(tracker.plane)},
          {"driver_clock", to_json(calibration.clocks.driver)},
          {"driver_drift", calibration.clocks.driver_drift},
          {"tracker_clock", to_json(calibration.clocks.tracker)},
          {"shape_delay", to_json(calibration.clocks.shape_delay)}};
}

/// `limber driver calibrate`: its flags, its questions and its file.
class DriverCalibrate {
 public:
  void add_to(CLI::App& app) {
    own_ = {
        app.add_flag("--yes", yes_,
                     "calibrate: confirm every step, for scripts; needs --handedness"),
        app.add_option(
               "--handedness", handedness_,
               "calibrate: of the tracker's frame seen from above, right (y to the left of x) or "
               "left (mirrored); of one that sees in 3D, right where that of its axes which is "
               "steepest points up, left where down; by default you are asked which way the arm "
               "bends")
            ->check(CLI::IsMember({"right", "left"})),
        app.add_option("--base-marker", base_marker_m_,
                       "calibrate: X,Y where the base's marker body sits as built, in metres from "
                       "the base's origin, x along the arm, y to its left; by default unknown")
            ->delimiter(',')
            ->expected(2),
        app.add_option("--tolerance-m", tolerance_.position_m,
                       "calibrate: refuse a base known less well than that")
            ->check(more_than_zero())
            ->capture_default_str(),
        app.add_option("--tolerance-rad", tolerance_.heading_rad,
                       "calibrate: the same of its heading")
            ->check(more_than_zero())
            ->capture_default_str()};
  }

  /// @throws InputError naming a flag of calibrate that was given to check
  void refuse_own_flags() const {
    for (const CLI::Option* option : own_) {
      if (option->count() > 0) {
        throw InputError(fmt::format("{}: of limber driver calibrate; check has no use for it",
                                     option->get_name()));
      }
    }
  }

  /// @param driver  without a calibration
  /// @param out     the calibration's file
  int run(const ArmDescription& arm, const ProcessDriverSettings& driver, const std::string& out,
          const CommonFlags& flags) const {
    refuse_if(
        yes_ && handedness_.empty(),
        "--yes: needs --handedness right or left. A mirrored tracker with left and right swapped "
        "reads like one that is right, so only who sees the arm can tell");
    refuse_to_overwrite(out, flags.force);
    CalibrateDriverSettings settings;
    settings.driver = driver;
    settings.driver.log = free_name(out + ".driver", ".", ".jsonl");
    settings.driver.say = tell_of_arm(false);
    settings.tolerance = tolerance_;
    settings.confirm = [&](const std::string& step) {
      if (yes_) {
        say(flags, "{}", step);
      } else {
        wait_for_operator(step);
      }
    };
    settings.answer = [&](int channel) { return answer(channel); };
    const DriverCalibration done = calibrate_driver(arm, settings);
    Json json = {{"status", done.estimate.refusal.empty() ? "ok" : "refused"},
                 {"reason", done.estimate.refusal},
                 {"driver", done.hello.driver},
                 {"device", done.hello.device},
                 {"frames", done.log.frames.size()}};
    if (!done.estimate.refusal.empty()) {
      print_result(flags, json, "");
      print_error("refused: " + done.estimate.refusal);
      return kExitNoSolution;
    }
    write_file_atomically(out, to_yaml(done.estimate.calibration));
    json["calibration"] = to_json(done.estimate.calibration);
    print_result(flags, json,
                 fmt::format("{}\n{}: give it to every verb that moves the arm, --calibration {}",
                             in_words(done.estimate.calibration), out, out));
    return kExitDone;
  }

 private:
  OperatorAnswer answer(int channel) const {
    OperatorAnswer result;
    if (!base_marker_m_.empty()) {
      result.base_marker_m = Eigen::Vector2d(base_marker_m_[0], base_marker_m_[1]);
    }
    if (!handedness_.empty()) {
      result.mirrored = handedness_ == "left";
      return result;
    }
    while (true) {
      ask(fmt::format(
          "Seen from above, along the arm from its base: which way did it bend as channel "
          "{} went up? r (right) or l (left): ",
          channel));
      const std::string said = operator_line();
      if (said == "r" || said == "l") {
        result.bends_right = said == "r";
        return result;
      }
    }
  }

  bool yes_ = false;
  std::string handedness_;
  std::vector<double> base_marker_m_;
  CalibrationTolerance tolerance_;
  std::vector<const CLI::Option*> own_;
};

class DriverVerb final : public Verb {
 public:
  DriverVerb()
      : Verb("driver", "Check a driver (timing, units, valves, deadmen), or calibrate it",
             "limber driver check --driver \"exec:limber virtual-arm --serve\" --out checked\n"
             "  limber driver calibrate --driver \"exec:limber virtual-arm --serve "
             "--fast --misassembled 1\" --simulated --yes --handedness right --out "
             "calibration.yaml") {}

  void add_flags(CLI::App& app) override {
    app.add_option("action", action_, "check or calibrate")
        ->option_text("check|calibrate")
        ->required();
    add_arm_flag(app, arm_);
    app.add_option("--driver", driver_, "exec:COMMAND, the program (docs/driver.md)")->required();
    check_only_ = app.add_option("--limit-scale", limit_scale_,
                                 "check: pressure limits are this times the arm's, over 0 and at "
                                 "most 1; calibrate always moves within a tenth")
                      ->capture_default_str();
    app.add_option("--out", out_,
                   "check: folder for check.json, report.html, valves.yaml and the driver's log; "
                   "calibrate: the calibration's file")
        ->required();
    wire_.add_to(app);
    calibrate_.add_to(app);
  }

  int run(const CommonFlags& flags) override {
    refuse_if(action_ != "check" && action_ != "calibrate",
              "limber driver {}: expected 'limber driver check' or 'limber driver calibrate'",
              action_);
    const std::string arm_file = find_arm_file(arm_);
    const ArmDescription arm = load_any_arm(arm_file, PolynomialsOf::characterisation);
    if (action_ == "calibrate") {
      require_planar(arm, "limber driver calibrate");
      refuse_if(wire_.is_calibrated(), "--calibration: calibrate finds one; it goes with check");
      refuse_if(check_only_->count() > 0,
                "--limit-scale: calibrate always moves within a tenth; it goes with check");
      return calibrate_.run(arm, wire_.settings(driver_, arm, arm_file), out_, flags);
    }
    calibrate_.refuse_own_flags();
    require_limit_scale(limit_scale_);
    const fs::path folder = out_;
    require_writable_folder(folder);
    for (const char* file : {"check.json", "report.html", "valves.yaml"}) {
      refuse_to_overwrite(folder / file, flags.force);
    }
    ProcessDriverSettings settings = wire_.settings(driver_, arm, arm_file);
    fs::create_directories(folder);
    settings.limit_scale = limit_scale_;
    settings.log = free_name((folder / "check.driver").string(), ".", ".jsonl");
    settings.say = tell_of_arm(!flags.quiet);
    say(flags, "checking the driver: the arm moves for about a minute");
    const DriverCheck check = check_driver(arm, settings);
    return report(arm, check, flags);
  }

 private:
  int report(const ArmDescription& arm, const DriverCheck& check, const CommonFlags& flags) const {
    const fs::path folder = out_;
    const IdentifiedValves valves = identify_valves({check.episode}, arm, "driver check");
    const Json json = to_json(check, valves);
    write_file_atomically(folder / "check.json", json.dump(2) + "\n");
    write_file_atomically(folder / "report.html", driver_check_to_html(check, arm, valves));
    if (!valves.parameters.is_ideal()) {
      write_valves(folder / "valves.yaml", valves);
    } else {
      fs::remove(folder / "valves.yaml");  // of the check before, after --force
    }
    print_result(flags, json,
                 to_text(check) + "\n  " + to_text(valves, arm.command.unit, arm.dimension) +
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
  const CLI::Option* check_only_ = nullptr;
  double limit_scale_ = 1.0;
};

}  // namespace

std::unique_ptr<Verb> make_driver_verb() {
  return std::make_unique<DriverVerb>();
}

}  // namespace limber
