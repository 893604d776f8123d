#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "limber/logs/log_import.hpp"

namespace limber::python {

namespace py = pybind11;

namespace {

using Paths = std::vector<std::filesystem::path>;
using Import = ImportResult (*)(const Paths&, const ImportOptions&, const ArmDescription&);

/// Shared by both kinds of log.
template <Import import_logs>
ImportResult import_all(const Paths& logs, const ArmDescription& arm,
                        const std::optional<std::filesystem::path>& mapping,
                        const Paths& command_logs, std::optional<double> time_offset_s) {
  ImportOptions options;
  const py::gil_scoped_release others_may_run;
  options.mapping = mapping ? read_import_mapping(*mapping, arm) : default_import_mapping(arm);
  options.command_logs = command_logs;
  options.time_offset_s = time_offset_s;
  return import_logs(logs, options, arm);
}

}  // namespace

void bind_logs(py::module_& module) {
  py::class_<ImportResult>(module, "ImportResult", "A recording, and what was done to its logs.")
      .def_readonly("recording", &ImportResult::recording, "The recording.")
      .def_property_readonly(
          "report", [](const ImportResult& result) { return to_text(result.report); },
          "Everything that was dropped or changed, in sentences.")
      .def("__repr__", [](const ImportResult& result) {
        return "ImportResult(" + std::string(py::repr(py::cast(result.recording))) + ")";
      });
  module.def("import_csv", &import_all<&limber::import_csv>, py::arg("logs"), py::arg("arm"),
             py::arg("mapping") = py::none(), py::arg("command_logs") = Paths{},
             py::arg("time_offset_s") = py::none(),
             "A recording from CSV logs; the mapping file names "
             "their columns and units (docs/importing.md).");
  module.def("import_motive", &import_all<&limber::import_motive>, py::arg("logs"), py::arg("arm"),
             py::arg("mapping") = py::none(), py::arg("command_logs") = Paths{},
             py::arg("time_offset_s") = py::none(),
             "The same from OptiTrack Motive's CSV exports, with pressures in logs of their own.");
}

}  // namespace limber::python
