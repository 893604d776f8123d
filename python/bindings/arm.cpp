#include "limber/arm/arm_description.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/world/environment.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_segments(py::module_& module) {
  py::enum_<NoLoadKind>(module, "NoLoadKind", "What the no-load model takes a command for.")
      .value("strain_polynomial", NoLoadKind::strain_polynomial,
             "the pressure of one side, which contracts by P(|p|)")
      .value("curvature", NoLoadKind::curvature, "proportional to the segment's curvature")
      .value("straight", NoLoadKind::straight, "nothing: the network learns the rest");
  Record<Command>(module, "Command",
                  "What a segment is told. Of another command than a pressure, names that end in "
                  "_kpa hold numbers in this unit.")
      .read_only("name", &Command::name, "\"pressure\", or what else.")
      .read_only("unit", &Command::unit, "\"kPa\", or what else.")
      .done();
  Record<Segment>(module, "Segment", "One bending segment: two actuators on each side.")
      .read_only("length_m", &Segment::length_m, "Unpressurised length [m].")
      .read_only("width_m", &Segment::width_m, "Between the two sides [m].")
      .read_only("gaps", &Segment::gaps, "Spaces between its plates.")
      .property(
          "pressure_limit_kpa",
          [](const Segment& segment) { return segment.pressure_limit_kpa.largest_kpa(); },
          "The larger one of both sides [kPa].")
      .read_only("strain_polynomial", &Segment::strain_polynomial,
                 "c1 to c4 of e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa.")
      .read_only("curvature_per_unit", &Segment::curvature_per_unit,
                 "[1/m] over the command; NoLoadKind.curvature alone.")
      .done()
      .def_property_readonly(
          "pressure_range_kpa",
          [](const Segment& segment) {
            const PressureLimits& limits = segment.pressure_limit_kpa;
            return std::pair(limits.lower_kpa, limits.upper_kpa);
          },
          "Its limits: lower and upper [kPa].");
}

py::array_t<float> largest_pressures_of(const ArmDescription& arm) {
  py::array_t<float> limits(arm.segment_count());
  for (int i = 0; i < arm.segment_count(); ++i) {
    const Segment& segment = arm.segments[static_cast<std::size_t>(i)];
    limits.mutable_at(i) = static_cast<float>(segment.pressure_limit_kpa.largest_kpa());
  }
  return limits;
}

py::array_t<float> pressure_ranges_of(const ArmDescription& arm) {
  py::array_t<float> ranges({arm.segment_count(), 2});
  for (int i = 0; i < arm.segment_count(); ++i) {
    const PressureLimits& limits = arm.segments[static_cast<std::size_t>(i)].pressure_limit_kpa;
    ranges.mutable_at(i, 0) = static_cast<float>(limits.lower_kpa);
    ranges.mutable_at(i, 1) = static_cast<float>(limits.upper_kpa);
  }
  return ranges;
}

}  // namespace

void bind_arm(py::module_& module) {
  bind_segments(module);
  Record<ArmDescription>(module, "ArmDescription",
                         "A planar arm as its file describes it. Models borrow it, so it does not "
                         "change: load_arm reads one.")
      .read_only("name", &ArmDescription::name, "The arm's name.")
      .read_only("command", &ArmDescription::command, "What its segments are told.")
      .read_only("no_load", &ArmDescription::no_load, "What the no-load model makes of it.")
      .property("segment_count", &ArmDescription::segment_count, "n.")
      .property("point_count", &ArmDescription::point_count,
                "m: plates along the backbone, base included.")
      .property("length_m", &ArmDescription::length_m, "All segments [m].")
      .read_only("frame_rate_hz", &ArmDescription::frame_rate_hz,
                 "Of recordings, models and plans [Hz].")
      .read_only("pressure_rate_limit_kpa_per_s", &ArmDescription::pressure_rate_limit_kpa_per_s,
                 "Bounds a plan's frames [kPa/s].")
      .read_only("actuator_radius_m", &ArmDescription::actuator_radius_m,
                 "A gap's collision radius is width/2 + this [m].")
      .done()
      .def_readonly("segments", &ArmDescription::segments, "Base first.")
      .def_property_readonly("frame_period_s", &ArmDescription::frame_period_s, "1/rate [s].")
      .def_property_readonly("pressure_step_limit_kpa", &ArmDescription::pressure_step_limit_kpa,
                             "Largest change of a set point within one frame [kPa].")
      .def_property_readonly(
          "pressure_limits_kpa", &largest_pressures_of,
          "Largest pressure of each segment, of either side, float32 (n,) [kPa].")
      .def_property_readonly("pressure_ranges_kpa", &pressure_ranges_of,
                             "Lower and upper limit of each segment, float32 (n, 2) [kPa].")
      .def("frames_in", &ArmDescription::frames_in, py::arg("seconds"),
           "Fewest frames that take at least so long.")
      .def("segment_of_gap", &ArmDescription::segment_of_gap, py::arg("gap"),
           "Segment that the gap between plates gap and gap + 1 belongs to.")
      .def("hash", &ArmDescription::hash,
           "Of everything that the no-load model and planning depend on.")
      .def("_repr_svg_", &arm_picture, py::call_guard<py::gil_scoped_release>());

  module.def(
      "load_arm", [](const std::filesystem::path& path) { return load_arm(path); }, py::arg("path"),
      py::call_guard<py::gil_scoped_release>(),
      "Reads and checks an arm file (YAML). Raises InputError naming file, line and field.");
  module.def("arm_to_yaml", &arm_to_yaml, py::arg("arm"), py::call_guard<py::gil_scoped_release>(),
             "The arm as the text of a file that load_arm reads.");
  module.def("rest_positions_m", &rest_positions_m, py::arg("arm"),
             "Distance along the arm at rest from the base to each plate, m numbers [m].");
  module.def(
      "arm_differences",
      [](const ArmDescription& there, const ArmDescription& here) {
        return arm_differences(there, here);
      },
      py::arg("there"), py::arg("here"),
      "Keys in which the arms differ, with both values; empty where they are the same arm.");
}

}  // namespace limber::python
