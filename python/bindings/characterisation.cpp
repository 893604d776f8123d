#include "limber/arm/characterisation.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/hardware/bench_test.hpp"
#include "record.hpp"

namespace limber::python {

void bind_characterisation(py::module_& module) {
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
      py::arg("path"), "An arm file whose strain polynomials may be missing or outdated.");
  module.def("read_bench_csv", &read_bench_csv, py::arg("path"), py::arg("arm"),
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
      py::arg("path"), py::arg("arm"), "Writes an arm file that load_arm reads.");
}

}  // namespace limber::python
