#include "driver_calibrate.hpp"

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "operator_line.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

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
  if (!time) {
    return nullptr;
  }
  return {{"value_s", time->value_s}, {"low_s", time->low_s}, {"high_s", time->high_s}};
}

Json to_json(const std::vector<WireChannel>& channels) {
  Json json = Json::array();
  for (const WireChannel& one : channels) {
    json.push_back({{"channel", one.channel}, {"sign", one.sign > 0.0 ? 1 : -1}});
  }
  return json;
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

}  // namespace

void DriverCalibrate::add_to(CLI::App& app) {
  app.add_flag("--yes", yes_, "calibrate: confirm every step, for scripts; needs --handedness");
  app.add_option("--handedness", handedness_,
                 "calibrate: of the tracker's frame seen from above, right (y to the left of x) or "
                 "left (mirrored); of one that sees in 3D, right where that of its axes which is "
                 "steepest points up, left where down; by default you are asked which way the arm "
                 "bends")
      ->check(CLI::IsMember({"right", "left"}));
  app.add_option("--base-marker", base_marker_m_,
                 "calibrate: X,Y where the base's marker body sits as built, in metres from the "
                 "base's origin, x along the arm, y to its left; by default unknown")
      ->delimiter(',')
      ->expected(2);
  app.add_option("--tolerance-m", tolerance_.position_m,
                 "calibrate: refuse a base known less well than that")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--tolerance-rad", tolerance_.heading_rad, "calibrate: the same of its heading")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

OperatorAnswer DriverCalibrate::answer(int channel) const {
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

int DriverCalibrate::run(const ArmDescription& arm, const ProcessDriverSettings& driver,
                         const std::string& out, const CommonFlags& flags) const {
  if (yes_ && handedness_.empty()) {
    throw InputError(
        "--yes: needs --handedness right or left. A mirrored tracker with left and right swapped "
        "reads like one that is right, so only who sees the arm can tell");
  }
  const std::string log = out + ".driver.jsonl";
  for (const std::string& file : {out, log}) {
    refuse_to_overwrite(file, flags.force);
  }
  CalibrateDriverSettings settings;
  settings.driver = driver;
  settings.driver.log = log;
  settings.driver.say = [&](const std::string& message) {
    if (message.starts_with("VENT")) {
      print_to_stderr(printable(message) + "\n");
    }
  };
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

}  // namespace limber
