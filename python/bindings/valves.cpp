#include "limber/arm/valve_model.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/arm/valve_file.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_parameters(py::module_& module) {
  Record<ValveDirection>(module, "ValveDirection", "How a segment's pressure moves one way.")
      .field("time_constant_s", &ValveDirection::time_constant_s, "[s]; 0 follows at once.")
      .field("rate_limit_kpa_per_s", &ValveDirection::rate_limit_kpa_per_s,
             "[kPa/s], > 0; infinite where nothing limits it.")
      .keywords()
      .done();
  Record<SegmentValves>(module, "SegmentValves", "One segment's valves and their controller.")
      .field("inflating", &SegmentValves::inflating, "Away from zero.")
      .field("venting", &SegmentValves::venting, "Toward zero.")
      .field("dead_time_s", &SegmentValves::dead_time_s, "From a set point to its effect [s].")
      .field("dead_band_kpa", &SegmentValves::dead_band_kpa,
             "The valves stay closed within this distance of the set point [kPa].")
      .keywords()
      .done();
  Record<ValveParameters>(module, "ValveParameters",
                          "Parameters of the valve model; without segments ideal valves.")
      .field("has_sides", &ValveParameters::has_sides, "Whether a pressure has two sides.")
      .field("segments", &ValveParameters::segments, "One a segment, or none; assign whole lists.")
      .keywords()
      .done()
      .def_property_readonly("is_ideal", &ValveParameters::is_ideal,
                             "Whether pressures are the set points.")
      .def("hash", &ValveParameters::hash, "Of everything that a prediction depends on.")
      .def("__eq__", [](const ValveParameters& a, const ValveParameters& b) { return a == b; });
  Record<ValveErrors>(module, "ValveErrors", "Modelled less measured pressure over moving frames.")
      .read_only("mean_kpa", &ValveErrors::mean_kpa, "[kPa]")
      .read_only("p95_kpa", &ValveErrors::p95_kpa, "[kPa]")
      .read_only("max_kpa", &ValveErrors::max_kpa, "[kPa]")
      .read_only("frames", &ValveErrors::frames, "0: not measured.")
      .done();
  Record<ValveFindings>(module, "ValveFindings", "How valves were identified, or why not.")
      .read_only("source", &ValveFindings::source, "The recordings.")
      .read_only("held_back", &ValveFindings::held_back, "On motions that the fit has not seen.")
      .read_only("from_setpoints", &ValveFindings::from_setpoints,
                 "The same, had set points been taken for pressures.")
      .read_only("reason", &ValveFindings::reason, "Why there are no parameters.")
      .read_only("warnings", &ValveFindings::warnings, "Sentences.")
      .done();
  Record<IdentifiedValves>(module, "IdentifiedValves", "Valves and how they were found.")
      .field("parameters", &IdentifiedValves::parameters, "Ideal where there is a reason.")
      .field("findings", &IdentifiedValves::findings, "How well they fit.")
      .keywords()
      .done();
}

/// Pressures of set points (T, n) from a settled start.
py::array_t<double> run(const ValveModel& model, const DoubleArray& setpoint_kpa,
                        const DoubleArray& first_pressure_kpa) {
  const py::ssize_t frames = batch_size(setpoint_kpa, "setpoint_kpa");
  const py::ssize_t n = model.segment_count();
  require_shape(setpoint_kpa, {frames, n}, "setpoint_kpa");
  require_shape(first_pressure_kpa, {n}, "first_pressure_kpa");
  require_finite(setpoint_kpa, "setpoint_kpa");
  require_finite(first_pressure_kpa, "first_pressure_kpa");
  const Eigen::Map<const Eigen::MatrixXd> setpoints(setpoint_kpa.data(), n, frames);
  const Eigen::Map<const Eigen::VectorXd> first(first_pressure_kpa.data(), n);
  Eigen::MatrixXd pressures;
  {
    const py::gil_scoped_release others_may_run;
    pressures = model.run(setpoints, first);
  }
  py::array_t<double> result({frames, n});
  Eigen::Map<Eigen::MatrixXd>(result.mutable_data(), n, frames) = pressures;
  return result;
}

}  // namespace

void bind_valves(py::module_& module) {
  bind_parameters(module);
  py::class_<ValveModel>(module, "ValveModel",
                         "Set points to pressures, frame by frame. Constant: share it freely.")
      .def(py::init([](const ArmDescription& arm, std::optional<ValveParameters> parameters) {
             return parameters ? ValveModel(arm, *std::move(parameters)) : ValveModel(arm);
           }),
           py::arg("arm"), py::arg("parameters") = py::none(),
           "Without parameters ideal valves: pressures are the set points.")
      .def_property_readonly("is_ideal", &ValveModel::is_ideal, "Whether pressures follow at once.")
      .def_property_readonly("parameters", &ValveModel::parameters, "As given.")
      .def_property_readonly("segment_count", &ValveModel::segment_count, "n.")
      .def("run", &run, py::arg("setpoint_kpa"), py::arg("first_pressure_kpa"),
           "Pressures along set points float64 (T, n) [kPa] from a settled start (n,): float64 "
           "(T, n), row k after frame k; row 0 is the start.")
      .def("__repr__", [](const ValveModel& model) {
        return fmt::format("ValveModel({})",
                           model.is_ideal() ? "ideal" : model.parameters().hash());
      });
  module.def(
      "read_valves", [](const std::filesystem::path& path) { return read_valves(path); },
      py::arg("path"), py::call_guard<py::gil_scoped_release>(),
      "Reads a valve file (YAML or JSON).");
  module.def("write_valves", &write_valves, py::arg("path"), py::arg("valves"),
             py::call_guard<py::gil_scoped_release>(), "Writes a valve file, atomically.");
}

}  // namespace limber::python
