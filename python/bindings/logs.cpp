#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "episodes.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/logs/log_import.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

namespace {

using Paths = std::vector<fs::path>;
using PathList = ListOf<fs::path>;

bool is_path(const py::handle& object) {
  return py::isinstance<py::str>(object) || py::hasattr(object, "__fspath__");
}

[[noreturn]] void refuse_path(const std::string& name, const py::handle& found) {
  throw py::type_error(name + ": expected a path or a list of paths, found " + type_name(found) +
                       " " + std::string(py::repr(found)).substr(0, 60));
}

/// One path, or several. @throws TypeError naming the argument, and what was found in it.
Paths paths_from(const PathList& paths, const std::string& name) {
  if (is_path(paths)) {
    return {paths.cast<fs::path>()};
  }
  if (!py::isinstance<py::iterable>(paths) || py::isinstance<py::bytes>(paths)) {
    refuse_path(name, paths);
  }
  Paths found;
  for (const py::handle& path : paths) {
    if (!is_path(path)) {
      refuse_path(name + "[" + std::to_string(found.size()) + "]", path);
    }
    found.push_back(path.cast<fs::path>());
  }
  return found;
}

using Import = ImportResult (*)(const Paths&, const ImportOptions&, const ArmDescription&);

/// Shared by both kinds of log.
template <Import import_logs>
ImportResult import_all(const PathList& logs, const ArmDescription& arm,
                        const std::optional<fs::path>& mapping, const PathList& command_logs,
                        std::optional<double> time_offset_s) {
  ImportOptions options;
  const Paths log_paths = paths_from(logs, "logs");
  options.command_logs = paths_from(command_logs, "command_logs");
  const OthersMayRun others_may_run;
  options.mapping = mapping ? read_import_mapping(*mapping, arm) : default_import_mapping(arm);
  options.time_offset_s = time_offset_s;
  return import_logs(log_paths, options, arm);
}

}  // namespace

}  // namespace limber::python

template <>
struct pybind11::detail::handle_type_name<limber::python::PathList> {
  static constexpr auto name = const_name("Union[List[os.PathLike], os.PathLike]");
};

namespace limber::python {

void bind_logs(py::module_& module) {
  py::class_<ImportResult>(module, "ImportResult", "A recording, and what was done to its logs.")
      .def_readonly("recording", &ImportResult::recording,
                    "The Recording of all logs, an episode for each unbroken run.")
      .def_property_readonly(
          "report", [](const ImportResult& result) { return to_text(result.report); },
          "Everything that was dropped or changed, a text with a part for each log.")
      .def("__repr__", [](const ImportResult& result) {
        return "ImportResult(" + std::string(py::repr(py::cast(result.recording))) + ")";
      });
  module.def("import_csv", &import_all<&limber::import_csv>, "logs"_a, "arm"_a,
             "mapping"_a = py::none(), "command_logs"_a = py::tuple(),
             "time_offset_s"_a = py::none(),
             "A recording from CSV logs: an ImportResult. logs: their paths, or one path; "
             "arm: whose logs they are; mapping: file that names their columns and units "
             "(docs/importing.md), required; command_logs: logs of pressures on a clock of "
             "their own, one for each of `logs`; time_offset_s: what to add to their times "
             "[s], None: found by correlation. Raises InputError naming log, line and column.");
  module.def("import_motive", &import_all<&limber::import_motive>, "logs"_a, "arm"_a,
             "mapping"_a = py::none(), "command_logs"_a = py::tuple(),
             "time_offset_s"_a = py::none(),
             "The same from OptiTrack Motive's CSV exports. mapping: None: all rigid bodies, "
             "or else all markers, are plates; command_logs: logs of the pressures, which "
             "Motive has not, one for each of `logs`.");
}

}  // namespace limber::python
