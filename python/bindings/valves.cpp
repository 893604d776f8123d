#include "limber/arm/valve_model.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/filesystem.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_parameters(py::module_& module) {
  Record<ValveDirection>(module, "ValveDirection", "How a segment's pressure moves one way.")
      .field("time_constant_s", &ValveDirection::time_constant_s,
             "Time constant of the lag behind the set point [s], >= 0; 0: no lag.")
      .field("rate_limit_kpa_per_s", &ValveDirection::rate_limit_kpa_per_s,
             "Fastest change of the pressure [kPa/s], > 0; infinite where nothing limits it.")
      .keywords()
      .fixed()
      .done();
  Record<SegmentValves>(module, "SegmentValves", "One segment's valves and their controller.")
      .field("inflating", &SegmentValves::inflating,
             "ValveDirection of pressures that go away from 0 (that rise, where has_sides is "
             "False).")
      .field("venting", &SegmentValves::venting,
             "ValveDirection of pressures that go towards 0 (that fall, where has_sides is False).")
      .field("dead_time_s", &SegmentValves::dead_time_s,
             "From a set point to its first effect [s], 0 to 5; need not be whole frames.")
      .field("dead_band_kpa", &SegmentValves::dead_band_kpa,
             "The valves stay closed while the pressure is within this distance of the set "
             "point [kPa], >= 0; 0: they always follow.")
      .keywords()
      .fixed([](auto& fixed) {
        for (const auto& [name, member] : {std::pair("inflating", &SegmentValves::inflating),
                                           std::pair("venting", &SegmentValves::venting)}) {
          fixed.def_property_readonly(name, [member = member](const SegmentValves& valves) {
            return fixed_copy(valves.*member);
          });
        }
      })
      .done();
  Record<ValveParameters>(
      module, "ValveParameters",
      "Parameters of the valve model. ValveParameters() are ideal valves: pressures "
      "are the set points at once.")
      .field("has_sides", &ValveParameters::has_sides,
             "Whether a command has two sides, one of which vents before the other inflates: "
             "True for pressures, False for a curvature or an angle.")
      .list("segments", &ValveParameters::segments,
            "List of SegmentValves, one for each segment, in space for each chamber, base first; "
            "empty: ideal valves. "
            "A copy, whose fields can't be set: assign whole lists. ValveModel raises InputError "
            "where their number or a value does not fit the arm.")
      .keywords()
      .fixed()
      .done()
      .def_property_readonly("is_ideal", &ValveParameters::is_ideal,
                             "Whether there are no segments, so that pressures are the set points.")
      .def("hash", &ValveParameters::hash,
           "Hash of everything that a prediction depends on, a text; empty for ideal valves.")
      .def(
          "__eq__", [](const ValveParameters& a, const ValveParameters& b) { return a == b; },
          py::is_operator());
}

void bind_valve_findings(py::module_& module) {
  Record<ValveErrors>(
      module, "ValveErrors",
      "Size of modelled less measured pressure, over frames whose set point changed within 0.5 s.")
      .read_only("mean_kpa", &ValveErrors::mean_kpa, "Mean [kPa].")
      .read_only("p95_kpa", &ValveErrors::p95_kpa, "95th percentile [kPa].")
      .read_only("max_kpa", &ValveErrors::max_kpa, "Largest [kPa].")
      .read_only("frames", &ValveErrors::frames, "Frames that were looked at; 0: not measured.")
      .done();
  Record<ValveFindings>(module, "ValveFindings", "How valves were identified, or why not.")
      .read_only("source", &ValveFindings::source, "The recordings that they were identified from.")
      .read_only("held_back", &ValveFindings::held_back,
                 "ValveErrors on motions that the fit has not seen.")
      .read_only("from_setpoints", &ValveFindings::from_setpoints,
                 "ValveErrors on the same motions, if set points were taken for pressures.")
      .read_only("reason", &ValveFindings::reason,
                 "Why there are no parameters; empty where there are.")
      .read_only("warnings", &ValveFindings::warnings,
                 "What is suspicious about the recordings, a list of sentences.")
      .done();
  Record<IdentifiedValves>(module, "IdentifiedValves", "Valves and how they were found.")
      .field("parameters", &IdentifiedValves::parameters,
             "ValveParameters; ideal where findings.reason says why.")
      .field("findings", &IdentifiedValves::findings, "ValveFindings: how well the parameters fit.")
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
    const OthersMayRun others_may_run;
    pressures = model.run(setpoints, first);
  }
  py::array_t<double> result({frames, n});
  Eigen::Map<Eigen::MatrixXd>(result.mutable_data(), n, frames) = pressures;
  return result;
}

}  // namespace

void bind_valves(py::module_& module) {
  bind_parameters(module);
  bind_valve_findings(module);
  py::class_<ValveModel>(module, "ValveModel",
                         "Set points to pressures, frame by frame. Constant: share it freely.")
      .def(py::init([](const ArmDescription& arm, std::optional<ValveParameters> parameters) {
             return parameters ? ValveModel(arm, *std::move(parameters)) : ValveModel(arm);
           }),
           "arm"_a, "parameters"_a = py::none(),
           "Without parameters ideal valves: pressures are the set points. Raises "
           "InputError where the parameters do not fit the arm.")
      .def_property_readonly("is_ideal", &ValveModel::is_ideal,
                             "Whether pressures are the set points at once.")
      .def_property_readonly(
          "parameters", [](const ValveModel& model) { return fixed_copy(model.parameters()); },
          "ValveParameters, as given; a copy, whose fields can't be set.")
      .def_property_readonly("segment_count", &ValveModel::segment_count,
                             "n: segments of the arm, in space chambers.")
      .def("run", &run, "setpoint_kpa"_a, "first_pressure_kpa"_a,
           "Pressures along set points float64 (T, n) [kPa] from a settled start (n,): float64 "
           "(T, n), row k after frame k; row 0 is the start.")
      .def("__repr__", [](const ValveModel& model) {
        return fmt::format("ValveModel({})",
                           model.is_ideal() ? "ideal" : model.parameters().hash());
      });
  module.def(
      "read_valves", [](const fs::path& path) { return read_valves(path); }, "path"_a,
      py::call_guard<OthersMayRun>(),
      "Reads and checks a valve file (YAML or JSON): IdentifiedValves. Raises "
      "InputError naming file and key.");
  module.def("write_valves", &write_valves, "path"_a, "valves"_a, py::call_guard<OthersMayRun>(),
             "Writes a valve file that read_valves reads, atomically. valves: IdentifiedValves.");
}

}  // namespace limber::python
