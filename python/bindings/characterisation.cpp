#include "limber/arm/characterisation.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "episodes.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/hardware/bench_test.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_simple_model(py::module_& module) {
  py::class_<SimpleFit>(module, "SimpleFit",
                        "Gains, offsets and lengths of the simple model, fitted to recordings.")
      .def("__repr__",
           [](const SimpleFit& fit) {
             return fmt::format("SimpleFit(segments={}, lag_s={:.3f}, blocks={})",
                                fit.segments.size(), fit.model.lag_s, fit.blocks);
           })
      .def(
          "describe",
          [](const SimpleFit& fit, const ArmDescription& arm) { return to_text(fit, arm); },
          py::arg("arm"), "Each number with its 95 % interval, as text.");
  module.def(
      "fit_simple_model",
      [](const ArmDescription& arm, const py::iterable& episodes) {
        const std::vector<Episode> runs = episodes_from(episodes);
        const py::gil_scoped_release others_may_run;
        return fit_simple_model(arm, runs);
      },
      py::arg("arm"), py::arg("episodes"),
      "How much a pressure bends each segment, and how long it is, from the recordings.");
  module.def(
      "fitted_arm",
      [](const ArmDescription& arm, const SimpleFit& fit, const py::iterable& episodes) {
        const std::vector<Episode> runs = episodes_from(episodes);
        const py::gil_scoped_release others_may_run;
        return fitted_arm(arm, fit, runs);
      },
      py::arg("arm"), py::arg("fit"), py::arg("episodes"),
      "The arm with the fit's polynomials and lengths.");
}

}  // namespace

void bind_characterisation(py::module_& module) {
  bind_simple_model(module);
  Record<BenchPoint>(module, "BenchPoint", "One settled reading of a bench test.")
      .field("pressure_kpa", &BenchPoint::pressure_kpa, "Of the inflated side, gauge [kPa].")
      .field("strain", &BenchPoint::strain, "Change of length over l0, negative: contracted.")
      .keywords()
      .done();
  Record<StrainFit>(module, "StrainFit", "A strain polynomial and how well it fits.")
      .read_only("polynomial", &StrainFit::polynomial, "c1 to c4.")
      .read_only("full_strain", &StrainFit::full_strain, "At the pressure limit.")
      .read_only("rms_residual", &StrainFit::rms_residual, "Over full strain.")
      .read_only("max_residual", &StrainFit::max_residual, "Over full strain.")
      .read_only("points", &StrainFit::points, "Readings that were used.")
      .read_only("warnings", &StrainFit::warnings, "Sentences.")
      .done();
  Record<CharacterisedArm>(module, "CharacterisedArm", "An arm with fitted polynomials.")
      .read_only("arm", &CharacterisedArm::arm, "The arm.")
      .read_only("fits", &CharacterisedArm::fits, "One a segment.")
      .done();
  module.def(
      "load_arm_to_characterise",
      [](const std::filesystem::path& path) {
        return load_arm(path, PolynomialsOf::characterisation);
      },
      py::arg("path"), py::call_guard<py::gil_scoped_release>(),
      "An arm file whose strain polynomials may be missing or outdated.");
  module.def("read_bench_csv", &read_bench_csv, py::arg("path"), py::arg("arm"),
             py::call_guard<py::gil_scoped_release>(),
             "Bench points of every segment from a CSV file with the columns pressure_kpa, strain "
             "and, optionally, segment.");
  module.def("characterise", &characterise, py::arg("arm"), py::arg("bench"),
             py::call_guard<py::gil_scoped_release>(),
             "Fits a monotone quartic to every segment's bench points.");
  module.def("bench_test_all", &bench_test_all, py::arg("arm"), py::arg("steps") = 20,
             py::call_guard<py::gil_scoped_release>(),
             "The bench test of every segment of the virtual arm.");
  module.def(
      "write_arm",
      [](const std::filesystem::path& path, const ArmDescription& arm) {
        write_file_atomically(path, arm_to_yaml(arm));
      },
      py::arg("path"), py::arg("arm"), py::call_guard<py::gil_scoped_release>(),
      "Writes an arm file that load_arm reads.");
}

}  // namespace limber::python
