#include "limber/arm/characterisation.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/sim/bench_test.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_simple_model(py::module_& module) {
  py::class_<SimpleFit>(module, "SimpleFit",
                        "Gains, offsets and lengths of the simple model, fitted to recordings by "
                        "fit_simple_model.")
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
      [](const ArmDescription& arm, const EpisodeList& episodes) {
        const std::vector<Episode> runs = episodes_from(episodes);
        CallerThread caller;
        return caller.run_interruptible([&] { return fit_simple_model(arm, runs); });
      },
      py::arg("arm"), py::arg("episodes"),
      "SimpleFit: how much a pressure bends each segment, and how long it is, from "
      "the recordings. Raises InputError where there is no episode, or nothing was "
      "tracked.");
  module.def(
      "fitted_arm",
      [](const ArmDescription& arm, const SimpleFit& fit, const EpisodeList& episodes) {
        const std::vector<Episode> runs = episodes_from(episodes);
        CallerThread caller;
        return caller.run_interruptible([&] { return fitted_arm(arm, fit, runs); });
      },
      py::arg("arm"), py::arg("fit"), py::arg("episodes"),
      "The arm with the fit's polynomials and lengths, an ArmDescription. episodes: "
      "those that were fitted.");
}

}  // namespace

void bind_characterisation(py::module_& module) {
  bind_simple_model(module);
  Record<BenchPoint>(module, "BenchPoint", "One settled reading of a bench test.")
      .field("pressure_kpa", &BenchPoint::pressure_kpa,
             "Gauge pressure of the inflated side [kPa], >= 0.")
      .field("strain", &BenchPoint::strain,
             "Change of the side's length over its length at rest; negative: contracted.")
      .keywords()
      .done();
  Record<StrainFit>(module, "StrainFit", "A strain polynomial and how well it fits.")
      .read_only("polynomial", &StrainFit::polynomial,
                 "c1 to c4 of the contraction e = c1 p + c2 p^2 + c3 p^3 + c4 p^4, p in kPa.")
      .read_only("full_strain", &StrainFit::full_strain,
                 "Contraction at the pressure limit, a share of the length.")
      .read_only("rms_residual", &StrainFit::rms_residual,
                 "Root mean square of the residuals, as a share of full_strain.")
      .read_only("max_residual", &StrainFit::max_residual,
                 "Largest residual, as a share of full_strain.")
      .read_only("points", &StrainFit::points, "Number of readings that were used.")
      .read_only("warnings", &StrainFit::warnings,
                 "What is odd about the readings, a list of sentences.")
      .done();
  Record<CharacterisedArm>(module, "CharacterisedArm",
                           "An arm with fitted polynomials, and how well they fit.")
      .read_only("arm", &CharacterisedArm::arm, "The ArmDescription with the fitted polynomials.")
      .read_only("fits", &CharacterisedArm::fits,
                 "List of StrainFit, one for each segment, base first.")
      .done();
  module.def(
      "load_arm_to_characterise",
      [](const std::filesystem::path& path) {
        ArmDescription arm = load_arm(path, PolynomialsOf::characterisation);
        require_planar(arm, "limber.load_arm_to_characterise");
        return arm;
      },
      py::arg("path"), py::call_guard<OthersMayRun>(),
      "An arm file whose strain polynomials may be missing or outdated.");
  module.def("read_bench_csv", &read_bench_csv, py::arg("path"), py::arg("arm"),
             py::call_guard<OthersMayRun>(),
             "Bench points of every segment from a CSV file with the columns pressure_kpa, strain "
             "and, optionally, segment.");
  module.def("characterise", &characterise, py::arg("arm"), py::arg("bench"),
             py::call_guard<OthersMayRun>(),
             "Fits a monotone quartic to every segment's bench points: a CharacterisedArm. "
             "bench: a list of BenchPoint for each segment, base first, at least 5 different "
             "pressures up to the limit. Raises InputError naming the segment.");
  module.def("bench_test_all", &bench_test_all, py::arg("arm"), py::arg("steps") = 20,
             py::call_guard<OthersMayRun>(),
             "The bench test of every segment of the virtual arm: a list of BenchPoint for "
             "each. steps: pressures from 0 to the limit, >= 4.");
  module.def(
      "write_arm",
      [](const std::filesystem::path& path, const ArmDescription& arm) {
        write_file_atomically(path, arm_to_yaml(arm));
      },
      py::arg("path"), py::arg("arm"), py::call_guard<OthersMayRun>(),
      "Writes an arm file (YAML) that load_arm reads, atomically.");
}

}  // namespace limber::python
