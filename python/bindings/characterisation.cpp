#include "limber/arm/characterisation.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/simple_model.hpp"
#include "limber/data/space_fit.hpp"
#include "limber/sim/virtual_arm.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// @throws InputError for an arm in a plane, or where the fit is another arm's.
void require_spatial(const ArmDescription& arm, const char* what, const SpaceFit* fit = nullptr) {
  refuse_if(!arm.is_spatial(),
            "{} is of arms in space; '{}' is in a plane: fit_simple_model and fitted_arm "
            "are of those",
            what, arm.name);
  if (fit != nullptr && (fit->shape.rows() != 3 * arm.segment_count() ||
                         fit->shape.cols() != arm.channel_count() + 1)) {
    throw InputError(fmt::format("{}: a fit of {} segments and {} chambers; arm '{}' has {} and {}",
                                 what, fit->shape.rows() / 3, fit->shape.cols() - 1, arm.name,
                                 arm.segment_count(), arm.channel_count()));
  }
}

/// @throws InputError for an arm in space, or where the fit is another arm's.
void require_planar_fit(const ArmDescription& arm, const char* what, const SimpleFit& fit) {
  require_planar(arm, what);
  refuse_if(std::ssize(fit.segments) != arm.segment_count(),
            "{}: a fit of {} segments; arm '{}' has {}", what, fit.segments.size(), arm.name,
            arm.segment_count());
}

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
          [](const SimpleFit& fit, const ArmDescription& arm) {
            require_planar_fit(arm, "SimpleFit.describe", fit);
            return to_text(fit, arm);
          },
          "arm"_a, "Each number with its 95 % interval, as text.");
  module.def(
      "fit_simple_model",
      [](const ArmDescription& arm, const EpisodeList& episodes) {
        require_planar(arm, "limber.fit_simple_model (fit_space_model is its like)");
        const std::vector<Episode> runs = episodes_from(episodes);
        return interruptibly([&] { return fit_simple_model(arm, runs); });
      },
      "arm"_a, "episodes"_a,
      "SimpleFit: how much a pressure bends each segment, and how long it is, from "
      "the recordings. Raises InputError where there is no episode, or nothing was tracked.");
  module.def(
      "fitted_arm",
      [](const ArmDescription& arm, const SimpleFit& fit, const EpisodeList& episodes) {
        require_planar_fit(arm, "limber.fitted_arm (with_space_fit is its like)", fit);
        const std::vector<Episode> runs = episodes_from(episodes);
        return interruptibly([&] { return fitted_arm(arm, fit, runs); });
      },
      "arm"_a, "fit"_a, "episodes"_a,
      "The arm with the fit's polynomials and lengths, an ArmDescription. episodes: "
      "those that were fitted.");
}

/// float64 (rows, columns), a copy.
template <Eigen::MatrixXd SpaceFit::*kMatrix>
py::array_t<double> matrix_of(const SpaceFit& fit) {
  return copy_of<double>(fit.*kMatrix, {(fit.*kMatrix).rows(), (fit.*kMatrix).cols()});
}

void bind_space_fit(py::module_& module) {
  py::class_<SpaceFit>(module, "SpaceFit",
                       "Constant curvature of an arm in space, fitted to recordings by "
                       "fit_space_model: s segments, n chambers.")
      .def_property_readonly("shape", &matrix_of<&SpaceFit::shape>,
                             "Bend about y and z [rad] and extension [share of the length] of each "
                             "segment, float64 (3 s, n + 1): over chambers' strains, and a "
                             "constant last.")
      .def_property_readonly("shape_sd", &matrix_of<&SpaceFit::shape_sd>,
                             "Standard deviation of each number of `shape`, of ten pieces of the "
                             "recordings, in its units.")
      .def_readonly("dead_time_s", &SpaceFit::dead_time_s,
                    "From a command to its first effect [s].")
      .def_readonly("dead_time_sd_s", &SpaceFit::dead_time_sd_s,
                    "Its standard deviation, of ten pieces of the recordings [s].")
      .def_readonly("lag_s", &SpaceFit::lag_s, "Time constant of shapes behind commands [s].")
      .def_readonly("plates_mm", &SpaceFit::plates_mm,
                    "Mean distance of the plates from the fit [mm].")
      .def_readonly("tip_mm", &SpaceFit::tip_mm, "Mean distance of the tip from the fit [mm].")
      .def(
          "describe",
          [](const SpaceFit& fit, const ArmDescription& arm) {
            require_spatial(arm, "SpaceFit.describe", &fit);
            return to_text(fit, arm);
          },
          "arm"_a, "What each chamber does, and what is odd about it, as text.")
      .def(
          "predict",
          [](const SpaceFit& fit, const ArmDescription& arm, const Episode& episode) {
            require_spatial(arm, "SpaceFit.predict", &fit);
            require_episodes_of({episode}, arm);
            const FrameMatrix rows = predict(fit, arm, episode);
            return copy_of<float>(rows, {rows.rows(), arm.point_count(), kSpacePoseSize});
          },
          "arm"_a, "episode"_a,
          "Backbones float32 (T, m, 7) that it expects under an episode's commands.")
      .def("__repr__", [](const SpaceFit& fit) {
        return fmt::format("SpaceFit(dead_time_s={:.3f}, lag_s={:.3f}, tip_mm={:.1f})",
                           fit.dead_time_s, fit.lag_s, fit.tip_mm);
      });
  module.def(
      "fit_space_model",
      [](const ArmDescription& arm, const EpisodeList& episodes) {
        require_spatial(arm, "limber.fit_space_model");
        const std::vector<Episode> runs = episodes_from(episodes);
        return interruptibly([&] { return fit_space_model(arm, runs); });
      },
      "arm"_a, "episodes"_a,
      "SpaceFit: how chambers bend and extend every segment of an arm in space, from the "
      "recordings. Raises InputError where too few frames were tracked.");
  module.def(
      "with_space_fit",
      [](const ArmDescription& arm, const SpaceFit& fit) {
        require_spatial(arm, "limber.with_space_fit", &fit);
        return with_space_fit(arm, fit);
      },
      "arm"_a, "fit"_a,
      "The arm with the fit as its no-load model, an ArmDescription. fit: a SpaceFit.");
}

}  // namespace

void bind_characterisation(py::module_& module) {
  bind_simple_model(module);
  bind_space_fit(module);
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
      [](const fs::path& path) { return load_arm(path, PolynomialsOf::characterisation); },
      "path"_a, py::call_guard<OthersMayRun>(),
      "An arm file whose strain polynomials may be missing or outdated.");
  module.def(
      "read_bench_csv",
      [](const fs::path& path, const ArmDescription& arm) {
        require_planar(arm, "limber.read_bench_csv");
        return read_bench_csv(path, arm);
      },
      "path"_a, "arm"_a, py::call_guard<OthersMayRun>(),
      "Bench points of every segment from a CSV file with the columns pressure_kpa, strain "
      "and, optionally, segment.");
  module.def("characterise", of_planar_arms("limber.characterise", &characterise), "arm"_a,
             "bench"_a, py::call_guard<OthersMayRun>(),
             "Fits a monotone quartic to every segment's bench points: a CharacterisedArm. "
             "bench: a list of BenchPoint for each segment, base first, at least 5 different "
             "pressures up to the limit. Raises InputError naming the segment.");
  module.def(
      "bench_test_all",
      [](const ArmDescription& arm, int steps) {
        return interruptibly([&] { return bench_test_all(arm, steps); });
      },
      "arm"_a, "steps"_a = 20,
      "The bench test of every segment of the virtual arm: a list of BenchPoint for each. steps: "
      "pressures from 0 to the limit, 4 to 1000. Ctrl-C raises KeyboardInterrupt.");
  module.def(
      "write_arm",
      [](const fs::path& path, const ArmDescription& arm) {
        write_file_atomically(path, arm_to_yaml(arm));
      },
      "path"_a, "arm"_a, py::call_guard<OthersMayRun>(),
      "Writes an arm file (YAML) that load_arm reads, atomically.");
}

}  // namespace limber::python
