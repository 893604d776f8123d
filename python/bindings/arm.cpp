#include "limber/arm/arm_description.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/arm/arm_commands.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/world/environment.hpp"
#include "others_may_run.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_segments(py::module_& module) {
  Choice<NoLoadKind>(module, "NoLoadKind", "What the no-load model takes a command for.")
      .value("strain_polynomial", NoLoadKind::strain_polynomial,
             "the pressure of one side, which contracts by P(|p|)")
      .value("curvature", NoLoadKind::curvature, "proportional to the segment's curvature")
      .value("straight", NoLoadKind::straight, "nothing: the network learns the rest")
      .value("chambers", NoLoadKind::chambers,
             "in space: strains of chambers, by where they lie in the segment")
      .value("fitted", NoLoadKind::fitted,
             "in space: a matrix from all strains to the segment's bend and extension");
  Record<Command>(module, "Command",
                  "What a segment is told. Of another command than a pressure, names that end in "
                  "_kpa hold numbers in this unit.")
      .read_only("name", &Command::name,
                 "\"pressure\", or what else segments are told, such as \"motor angle\".")
      .read_only("unit", &Command::unit,
                 "\"kPa\", or the unit of that other command, such as \"rad\".")
      .done();
  Record<Chamber>(module, "Chamber",
                  "What bends a segment of an arm in space: a chamber, a muscle or a tendon, with "
                  "a command of its own.")
      .read_only("angle_deg", &Chamber::angle_deg,
                 "Where it lies in the cross-section, seen from the tip, from y toward z [deg].")
      .read_only("radius_m", &Chamber::radius_m, "Distance from the segment's axis [m].")
      .read_only("sense", &Chamber::sense,
                 "1 where it extends under positive commands, -1 where it contracts.")
      .property(
          "pressure_range_kpa",
          [](const Chamber& chamber) {
            return std::pair(chamber.limit_kpa.lower_kpa, chamber.limit_kpa.upper_kpa);
          },
          "(lower, upper) limit of its command [kPa].")
      .read_only("strain_polynomial", &Chamber::strain_polynomial,
                 "c1 to c4 of the strain c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa. All 0: the "
                 "strain is the command.")
      .done();
  Record<Segment>(module, "Segment",
                  "One bending segment, with two actuators on each side. A positive pressure "
                  "inflates its right side, a negative one its left side. In space it has "
                  "chambers, and what is said of its pressure stands for nothing.")
      .read_only("length_m", &Segment::length_m, "Length without pressure [m], > 0, at most 10.")
      .read_only("width_m", &Segment::width_m,
                 "Between the centre lines of its two sides [m], > 0, at most 10.")
      .read_only("gaps", &Segment::gaps, "Spaces between its plates, 1 to 100.")
      .property(
          "pressure_limit_kpa",
          [](const Segment& segment) { return segment.pressure_limit_kpa.largest_kpa(); },
          "The larger one of both sides' limits [kPa], > 0.")
      .read_only("strain_polynomial", &Segment::strain_polynomial,
                 "c1 to c4 of the contraction e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa, e a "
                 "share of the length. All 0 where the arm has none.")
      .read_only("curvature_per_unit", &Segment::curvature_per_unit,
                 "Curvature [1/m] for one unit of the command; only with NoLoadKind.curvature.")
      .done()
      .def_property_readonly(
          "pressure_range_kpa",
          [](const Segment& segment) {
            const PressureLimits& limits = segment.pressure_limit_kpa;
            return std::pair(limits.lower_kpa, limits.upper_kpa);
          },
          "(lower, upper) limit of its command [kPa], signed: positive bends right.")
      .def_readonly("chambers", &Segment::chambers, "In space its Chambers; else empty.");
}

Eigen::VectorXd vector_from(const DoubleArray& array, const char* name) {
  require_shape(array, {array.size()}, name);
  require_finite(array, name);
  return Eigen::Map<const Eigen::VectorXd>(array.data(), array.size());
}

void bind_commands(py::module_& module) {
  Record<ArmCommand>(
      module, "ArmCommand",
      "A command of the real arm, such as a motor's, and how much of it each segment gets.")
      .read_only("name", &ArmCommand::name, "Of its column in logs.")
      .read_only("shares", &ArmCommand::shares, "n, with sign.")
      .done();
}

/// Once ArmDescription is known: signatures name it.
void bind_command_sums(py::module_& module) {
  module.def(
      "command_shares",
      [](const ArmDescription& arm) {
        const Eigen::MatrixXd shares = command_shares(arm);
        return copy_of<double>(shares, {shares.rows(), shares.cols()});
      },
      "arm"_a, "S, float64 (n, k): commands of segments are S times the arm's own, k of them.");
  module.def(
      "segment_commands",
      [](const ArmDescription& arm, const DoubleArray& commands) {
        return vector_array(segment_commands(arm, vector_from(commands, "commands")));
      },
      "arm"_a, "commands"_a,
      "Commands of segments, float64 (n,), that the arm's own commands (k,) make.");
  module.def(
      "commands_for",
      [](const ArmDescription& arm, const DoubleArray& wanted) {
        return vector_array(commands_for(arm, vector_from(wanted, "segment_commands")));
      },
      "arm"_a, "segment_commands"_a,
      "The arm's own commands, float64 (k,), that make these of its segments (n,): the smallest, "
      "by their sum of squares.");
}

py::array_t<float> largest_pressures_of(const ArmDescription& arm) {
  py::array_t<float> limits(arm.channel_count());
  for (int i = 0; i < arm.channel_count(); ++i) {
    limits.mutable_at(i) = float(arm.limits_of_channel(i).largest_kpa());
  }
  return limits;
}

void bind_arm_functions(py::module_& module) {
  module.def(
      "load_arm", [](const fs::path& path) { return load_arm(path); }, "path"_a,
      py::call_guard<OthersMayRun>(),
      "Reads and checks an arm file (YAML). Raises InputError naming file, line and "
      "field, what was found and what is allowed.");
  module.def("arm_to_yaml", &arm_to_yaml, "arm"_a, py::call_guard<OthersMayRun>(),
             "The arm as the text of a file that load_arm reads.");
  module.def("rest_positions_m", &rest_positions_m, "arm"_a,
             "Distance along the arm at rest from the base to each plate, a list of m "
             "numbers [m]; the first is 0.");
  module.def("arm_differences", &arm_differences, "there"_a, "here"_a,
             "Keys in which the arms differ, with both values; empty where they are the same arm.");
}

}  // namespace

void bind_arm(py::module_& module) {
  bind_segments(module);
  bind_commands(module);
  Record<ArmDescription>(module, "ArmDescription",
                         "An arm as its file describes it. Models borrow it, so it does not "
                         "change: load_arm reads one.")
      .read_only("name", &ArmDescription::name, "The arm's name, as its file has it.")
      .read_only("command", &ArmDescription::command,
                 "What its segments are told: Command, pressures in kPa by default.")
      .read_only("no_load", &ArmDescription::no_load,
                 "NoLoadKind: what the no-load model makes of the command.")
      .property(
          "dimension", [](const ArmDescription& arm) { return position_size(arm.dimension); },
          "2: it moves in a plane, 3: in space.")
      .property("segment_count", &ArmDescription::segment_count, "Segments of the arm.")
      .property("channel_count", &ArmDescription::channel_count,
                "n: its pressures, one for each segment, in space for each chamber, base first.")
      .property("point_count", &ArmDescription::point_count,
                "m: plates along the backbone, base included. One more than gaps in all.")
      .property("length_m", &ArmDescription::length_m,
                "Length at rest of all segments together [m].")
      .read_only("frame_rate_hz", &ArmDescription::frame_rate_hz,
                 "Frames per second of recordings, models and plans [Hz], 1 to 1000.")
      .read_only("pressure_rate_limit_kpa_per_s", &ArmDescription::pressure_rate_limit_kpa_per_s,
                 "What the valves can follow [kPa/s], > 0: plans change no set point faster.")
      .read_only("actuator_radius_m", &ArmDescription::actuator_radius_m,
                 "A gap's collision radius is its segment's width/2 + this [m], 0 to 1.")
      .done()
      .def_readonly("segments", &ArmDescription::segments,
                    "Its Segments, base first: segments[0] is at the base.")
      .def_readonly("commands", &ArmDescription::commands,
                    "The real arm's ArmCommands, where they are not one for each segment; else "
                    "empty.")
      .def_property_readonly("frame_period_s", &ArmDescription::frame_period_s,
                             "Time from one frame to the next, 1/frame_rate_hz [s].")
      .def_property_readonly("pressure_step_limit_kpa", &ArmDescription::pressure_step_limit_kpa,
                             "Largest change of a set point within one frame [kPa].")
      .def_property_readonly(
          "pressure_limits_kpa", &largest_pressures_of,
          "Largest pressure of each segment, of either side, or chamber, float32 (n,) [kPa].")
      .def_property_readonly(
          "pressure_ranges_kpa",
          [](const ArmDescription& arm) { return limits_array(limits_of(arm)); },
          "Lower and upper limit of each segment or chamber, float32 (n, 2) [kPa].")
      .def(
          "frames_in",
          [](const ArmDescription& arm, double seconds) {
            require_number("seconds", seconds, 0.0, kMaxSeconds);
            return arm.frames_in(seconds);
          },
          "seconds"_a, "Fewest frames that take at least so long. seconds: 0 to 1e6.")
      .def(
          "segment_of_gap",
          [](const ArmDescription& arm, int gap) {
            require_number("gap", gap, 0, arm.point_count() - 2);
            return arm.segment_of_gap(gap);
          },
          "gap"_a,
          "Number of the segment, from 0, that the gap between plates gap and gap + 1 "
          "belongs to. gap: 0 to m - 2.")
      .def("hash", &ArmDescription::hash,
           "Hash of everything that the no-load model and planning depend on, a text.")
      .def("_repr_svg_", &arm_picture, py::call_guard<OthersMayRun>());
  bind_arm_functions(module);
  bind_command_sums(module);
}

}  // namespace limber::python
