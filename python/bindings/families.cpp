#include <pybind11/stl.h>

#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/common/error.hpp"
#include "limber/training/arm_fit.hpp"

namespace limber::python {

namespace py = pybind11;

void bind_families(py::module_& module) {
  py::class_<ArmFit>(module, "ArmFit", "Which arm of a family was recorded, as fit_arm finds it.")
      .def_readonly("model", &ArmFit::model, "CompensationModel of that arm, an ordinary one.")
      .def_readonly("middle_error_m", &ArmFit::middle_error_m,
                    "Mean error of the tip over the windows, of the family's middle [m].")
      .def_readonly("error_m", &ArmFit::error_m, "The same of `model` [m].")
      .def_readonly("distance", &ArmFit::distance,
                    "From the family's middle; about 1 for an arm of it.")
      .def_readonly("distance_to_nearest", &ArmFit::distance_to_nearest,
                    "The same from the nearest arm that the family learnt from.")
      .def_readonly("iterations", &ArmFit::iterations, "Steps of the fit.");
  module.def(
      "fit_arm",
      [](const ArmDescription& arm, const CompensationModel& family, const EpisodeList& episodes,
         int window_frames, int jobs) {
        if (window_frames < 1 || jobs < 0) {
          throw InputError("window_frames and jobs: expected at least 1 and 0");
        }
        const std::vector<Episode> copies = episodes_from(episodes);
        ArmFitSettings settings;
        settings.window_frames = window_frames;
        settings.jobs = jobs;
        CallerThread caller;
        return caller.run_interruptible([&] { return fit_arm(arm, family, copies, settings); });
      },
      py::arg("arm"), py::arg("family"), py::arg("episodes"),
      py::arg("window_frames") = ArmFitSettings().window_frames, py::arg("jobs") = 0,
      "Makes a family's network that of the arm in these episodes, of which a minute is enough: an "
      "ArmFit, whose model plans like any other. window_frames: that are predicted without "
      "correction. jobs: threads, 0: one per core. Raises InputError where the model is of no "
      "family, or the episodes are another arm's.");
}

}  // namespace limber::python
