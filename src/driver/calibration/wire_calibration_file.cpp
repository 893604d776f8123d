#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/driver/wire_calibration.hpp"

namespace limber {

namespace {

constexpr double kMaxOrigin = 1e8;  // in the tracker's unit, which may be mm
constexpr double kRounding = 1e-6;  // of a length of 1, or a product of 0

template <class Vector>
std::string numbers(const Vector& vector) {
  return fmt::format("[{}]", fmt::join(vector.begin(), vector.end(), ", "));
}

/// `size` finite numbers.
Eigen::VectorXd read_vector(const YamlReader& node, const char* what, std::size_t size) {
  const std::vector<double> found = node.numbers(what);
  node.refuse_if(found.size() != size, "{} numbers; expected {}", found.size(), size);
  return Eigen::Map<const Eigen::VectorXd>(found.data(), Eigen::Index(size));
}

Eigen::VectorXd read_unit_vector(const YamlReader& node, const char* what, std::size_t size) {
  const Eigen::VectorXd vector = read_vector(node, what, size);
  if (!(std::abs(vector.norm() - 1.0) <= kRounding)) {
    node.refuse(fmt::format("of length {:.7g}; expected 1", vector.norm()));
  }
  return vector.normalized();
}

/// The mapping `plane` of a calibration file's tracker (docs/formats.md), and what of it people
/// want to know.
std::string to_yaml(const TrackerPlane& plane) {
  std::string text = fmt::format(
      "  plane:                  # in the frame and unit of a tracker that sees in 3D\n"
      "    origin: {}\n    x_axis: {}\n    y_axis: {}\n"
      "    out_of_plane_m: {}\n    tilt_rad: {}\n"
      "    body_rotations:       # [qx, qy, qz, qw] of each body at heading 0, in these axes\n",
      numbers(plane.origin), numbers(plane.x_axis), numbers(plane.y_axis), plane.out_of_plane_m,
      plane.tilt_rad);
  for (const Eigen::Quaterniond& rotation : plane.body_rotations) {
    text += "      - " + numbers(rotation.coeffs()) + "\n";
  }
  return text;
}

std::string in_words(const TrackerPlane& plane) {
  const Eigen::Vector3d normal = plane.normal();
  return fmt::format(
      "the tracker sees in 3D: the arm moves in a plane with normal ({:.4f}, {:.4f}, {:.4f}); "
      "bodies left it by at most {:.1f} mm and {:.4f} rad",
      normal.x(), normal.y(), normal.z(), 1e3 * plane.out_of_plane_m, plane.tilt_rad);
}

/// @throws InputError naming line and field where axes are not orthonormal, or there are not as
/// many rotations as `bodies`.
TrackerPlane read_plane(const YamlReader& node, std::size_t bodies) {
  node.refuse_unknown_keys(
      {"origin", "x_axis", "y_axis", "out_of_plane_m", "tilt_rad", "body_rotations"});
  TrackerPlane plane;
  plane.origin = read_vector(node.at("origin"), "x, y and z", 3);
  if (!(plane.origin.cwiseAbs().maxCoeff() <= kMaxOrigin)) {
    node.at("origin").refuse(fmt::format("expected numbers up to {:g}", kMaxOrigin));
  }
  plane.x_axis = read_unit_vector(node.at("x_axis"), "x, y and z", 3);
  plane.y_axis = read_unit_vector(node.at("y_axis"), "x, y and z", 3);
  if (!(std::abs(plane.x_axis.dot(plane.y_axis)) <= kRounding)) {
    node.at("y_axis").refuse("not perpendicular to x_axis");
  }
  plane.out_of_plane_m = node.at("out_of_plane_m").number("a length in metres", 0.0);
  plane.tilt_rad = node.at("tilt_rad").number("an angle in rad", 0.0);
  for (const YamlReader& rotation : node.at("body_rotations").elements()) {
    plane.body_rotations.emplace_back(
        Eigen::Vector4d(read_unit_vector(rotation, "qx, qy, qz and qw", 4)));
  }
  if (plane.body_rotations.size() != bodies) {
    node.at("body_rotations")
        .refuse(fmt::format("{} rotations; marker_offsets has {} bodies",
                            plane.body_rotations.size(), bodies));
  }
  return plane;
}

constexpr const char* kCalibrationSchema = "limber/driver_calibration/1";
constexpr double kMaxFrameM = 1e4;
constexpr double kMaxClockS = 1e12;
constexpr double kMaxZeroKpa = 1e4;

std::string to_yaml(const std::vector<WireChannel>& channels) {
  const auto parts = mapped<std::string>(channels, [&](const WireChannel& one) {
    return fmt::format("{{channel: {}, sign: {}}}", one.channel, one.sign > 0.0 ? 1 : -1);
  });
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::string to_yaml(const Pose& pose) {
  return fmt::format("{{x_m: {}, y_m: {}, theta_rad: {}}}", pose.x_m, pose.y_m, pose.theta_rad);
}

std::string to_yaml(const TimeInterval& time) {
  return fmt::format("{{value_s: {}, low_s: {}, high_s: {}}}", time.value_s, time.low_s,
                     time.high_s);
}

std::string to_yaml(const TrackerCalibration& tracker) {
  std::string text = fmt::format(
      "tracker:\n  metres_per_unit: {}\n  radians_per_unit: {}\n  mirrored: {}\n"
      "  base: {}                # frame B in the tracker's\n"
      "  position_interval_m: {}\n  heading_interval_rad: {}\n"
      "  marker_offsets:         # of each plate's marker body, in the plate's frame\n",
      tracker.metres_per_unit, tracker.radians_per_unit, tracker.mirrored, to_yaml(tracker.base),
      tracker.position_interval_m, tracker.heading_interval_rad);
  for (const Pose& offset : tracker.marker_offsets) {
    text += "    - " + to_yaml(offset) + "\n";
  }
  return tracker.plane ? text + to_yaml(*tracker.plane) : text;
}

std::string to_yaml(const ClockCalibration& clocks) {
  std::string text;
  if (clocks.driver) {
    text += fmt::format("  driver: {}\n  driver_drift: {}\n", to_yaml(*clocks.driver),
                        clocks.driver_drift);
  }
  if (clocks.tracker) {
    text += fmt::format("  tracker: {}\n", to_yaml(*clocks.tracker));
  }
  if (clocks.shape_delay) {
    text += fmt::format("  shape_delay: {}\n", to_yaml(*clocks.shape_delay));
  }
  return text.empty() ? "" : "clocks:                   # limber applies none of them\n" + text;
}

/// A permutation of the wire's numbers, with signs.
std::vector<WireChannel> read_channels(const YamlReader& node) {
  std::vector<WireChannel> channels;
  const std::vector<YamlReader> elements = node.elements();
  const auto count = int(elements.size());
  node.refuse_if(count < 1 || count > kMaxSegments, "{} channels; expected one of each segment",
                 count);
  std::vector<bool> taken(elements.size());
  for (const YamlReader& element : elements) {
    element.refuse_unknown_keys({"channel", "sign"});
    WireChannel one;
    one.channel = element.at("channel").integer("a channel", 0, count - 1);
    one.sign = element.at("sign").integer("1 or -1", -1, 1);
    if (one.sign == 0.0) {
      element.at("sign").refuse("0; expected 1 or -1");
    }
    if (taken[one.channel]) {
      element.at("channel").refuse(fmt::format("{} is another segment's too", one.channel));
    }
    taken[one.channel] = true;
    channels.push_back(one);
  }
  return channels;
}

std::vector<double> read_kpa(const YamlReader& node, std::size_t count, double low) {
  std::vector<double> values = node.numbers("pressures in kPa");
  node.refuse_if(values.size() != count, "{} numbers; expected {}, one of each channel",
                 values.size(), count);
  for (const double value : values) {
    node.refuse_if(!(value >= low && value <= kMaxZeroKpa), "{} kPa; expected {} to {}", value, low,
                   kMaxZeroKpa);
  }
  return values;
}

Pose read_pose(const YamlReader& node) {
  node.refuse_unknown_keys({"x_m", "y_m", "theta_rad"});
  return {node.at("x_m").number("a length in metres", -kMaxFrameM, kMaxFrameM),
          node.at("y_m").number("a length in metres", -kMaxFrameM, kMaxFrameM),
          node.at("theta_rad").number("an angle in rad", -kMaxFrameM, kMaxFrameM)};
}

TimeInterval read_interval(const YamlReader& node) {
  node.refuse_unknown_keys({"value_s", "low_s", "high_s"});
  const auto time = [&](const char* key) {
    return node.at(key).number("a time in seconds", -kMaxClockS, kMaxClockS);
  };
  return {time("value_s"), time("low_s"), time("high_s")};
}

TrackerCalibration read_tracker(const YamlReader& node) {
  node.refuse_unknown_keys({"metres_per_unit", "radians_per_unit", "mirrored", "base",
                            "position_interval_m", "heading_interval_rad", "marker_offsets",
                            "plane"});
  TrackerCalibration tracker;
  tracker.metres_per_unit = node.at("metres_per_unit").number("metres", 1e-6, 1e3);
  tracker.radians_per_unit = node.at("radians_per_unit").number("radians", -1e3, 1e3);
  if (std::abs(tracker.radians_per_unit) < 1e-6) {
    node.at("radians_per_unit").refuse("expected an angle's unit in rad, not 0");
  }
  tracker.mirrored = node.at("mirrored").boolean();
  tracker.base = read_pose(node.at("base"));
  tracker.position_interval_m = node.at("position_interval_m").number("a length in metres", 0.0);
  tracker.heading_interval_rad = node.at("heading_interval_rad").number("an angle in rad", 0.0);
  for (const YamlReader& offset : node.at("marker_offsets").elements()) {
    tracker.marker_offsets.push_back(read_pose(offset));
  }
  if (node.has("plane")) {
    tracker.plane = read_plane(node.at("plane"), tracker.marker_offsets.size());
    if (std::abs(tracker.radians_per_unit) != 1.0) {
      node.at("radians_per_unit").refuse("expected 1 or -1: beside plane, headings are in rad");
    }
  }
  return tracker;
}

ClockCalibration read_clocks(const YamlReader& node) {
  node.refuse_unknown_keys({"driver", "driver_drift", "tracker", "shape_delay"});
  const auto interval = [&](const char* key) {
    return node.has(key) ? std::optional(read_interval(node.at(key))) : std::nullopt;
  };
  ClockCalibration clocks;
  clocks.driver = interval("driver");
  if (clocks.driver) {
    clocks.driver_drift = node.at("driver_drift").number("seconds per second", -1.0, 1.0);
  }
  clocks.tracker = interval("tracker");
  clocks.shape_delay = interval("shape_delay");
  return clocks;
}

WireCalibration read_root(const YamlReader& root) {
  root.require_schema(kCalibrationSchema);
  root.refuse_unknown_keys({"schema", "arm", "length_m", "valves", "sensors", "zero_kpa",
                            "noise_kpa", "tracker", "clocks"});
  WireCalibration calibration;
  calibration.arm = root.at("arm").text();
  calibration.length_m = root.at("length_m").positive("a length in metres");
  calibration.valves = read_channels(root.at("valves"));
  calibration.sensors = read_channels(root.at("sensors"));
  const std::size_t count = calibration.valves.size();
  if (calibration.sensors.size() != count) {
    root.at("sensors").refuse(
        fmt::format("{} channels; valves have {}", calibration.sensors.size(), count));
  }
  calibration.zero_kpa = read_kpa(root.at("zero_kpa"), count, -kMaxZeroKpa);
  calibration.noise_kpa = read_kpa(root.at("noise_kpa"), count, 0.0);
  if (root.has("tracker")) {
    calibration.tracker = read_tracker(root.at("tracker"));
  }
  if (root.has("clocks")) {
    calibration.clocks = read_clocks(root.at("clocks"));
  }
  return calibration;
}

std::string channel_in_words(const WireChannel& channel) {
  return fmt::format("{}{}", channel.channel, channel.sign > 0.0 ? "" : " with its sign turned");
}

std::string in_words(const TimeInterval& time) {
  constexpr double kMs = 1e3;
  return fmt::format("{:.1f} ms (from {:.1f} to {:.1f})", kMs * time.value_s, kMs * time.low_s,
                     kMs * time.high_s);
}

}  // namespace

WireCalibration read_wire_calibration(const fs::path& file) {
  return read_root(YamlReader::from_file(file));
}

WireCalibration parse_wire_calibration(const std::string& text, const std::string& name) {
  return read_root(YamlReader::from_text(text, name));
}

std::string to_yaml(const WireCalibration& calibration) {
  std::string text = fmt::format(
      "# How a driver's channels, sensors and tracker "
      "belong to an arm: limber driver calibrate wrote it,\n"
      "# and --calibration reads it (docs/hardware.md).\n"
      "schema: {}\narm: {}\nlength_m: {}\n"
      "valves: {}   # of each segment\nsensors: {}\n"
      "zero_kpa: [{}]   # of each reading on the wire\nnoise_kpa: [{}]\n",
      kCalibrationSchema, yaml_text(calibration.arm), calibration.length_m,
      to_yaml(calibration.valves), to_yaml(calibration.sensors),
      fmt::join(calibration.zero_kpa, ", "), fmt::join(calibration.noise_kpa, ", "));
  if (calibration.tracker) {
    text += to_yaml(*calibration.tracker);
  }
  return text + to_yaml(calibration.clocks);
}

std::string in_words(const WireCalibration& calibration) {
  std::string text;
  for (std::size_t s = 0; s < calibration.valves.size(); ++s) {
    text += fmt::format("{}: valve channel {}, sensor channel {}\n", segment_name(Eigen::Index(s)),
                        channel_in_words(calibration.valves[s]),
                        channel_in_words(calibration.sensors[s]));
  }
  text +=
      fmt::format("zero of each reading: {:.2f} kPa, noise {:.2f} kPa",
                  fmt::join(calibration.zero_kpa, ", "), fmt::join(calibration.noise_kpa, ", "));
  if (calibration.tracker) {
    const TrackerCalibration& tracker = *calibration.tracker;
    text += fmt::format(
        "\nbase in the tracker's frame: ({:.4f}, {:.4f}) m ± {:.1f} mm, heading {:.4f} ± {:.4f} "
        "rad{}; lengths in {:g} m, angles in {:g} rad",
        tracker.base.x_m, tracker.base.y_m, 1e3 * tracker.position_interval_m,
        tracker.base.theta_rad, tracker.heading_interval_rad,
        tracker.mirrored ? ", after y is turned over" : "", tracker.metres_per_unit,
        tracker.radians_per_unit);
    if (tracker.plane) {
      text += "\n" + in_words(*tracker.plane);
    }
  }
  if (calibration.clocks.driver) {
    text += "\nlimber's clock is ahead of the driver's by " + in_words(*calibration.clocks.driver);
  }
  if (calibration.clocks.tracker) {
    text += "\nthe driver's clock is ahead of the tracker's by " +
            in_words(*calibration.clocks.tracker);
  }
  if (calibration.clocks.shape_delay) {
    text += "\nshapes are older than pressures by " + in_words(*calibration.clocks.shape_delay) +
            ", the arm's own lag included";
  }
  return text;
}

}  // namespace limber
