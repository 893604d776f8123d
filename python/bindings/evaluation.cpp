#include "limber/training/evaluation.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "episodes.hpp"
#include "limber/report/training_report.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_errors_of_tips(py::module_& module) {
  Record<ErrorStatistics>(module, "ErrorStatistics", "Over frames.")
      .read_only("mean", &ErrorStatistics::mean, "Mean.")
      .read_only("std", &ErrorStatistics::std, "Standard deviation.")
      .read_only("p95", &ErrorStatistics::p95, "95th percentile.")
      .read_only("worst_motion", &ErrorStatistics::worst_motion, "Largest mean over one motion.")
      .done();
  Record<TipErrors>(module, "TipErrors", "Errors of the end effector.")
      .read_only("position_cm", &TipErrors::position_cm, "[cm]")
      .read_only("orientation_rad", &TipErrors::orientation_rad, "[rad]")
      .done();
  Record<RolloutErrors>(module, "RolloutErrors", "By how often a prediction is corrected.")
      .read_only("one_step", &RolloutErrors::one_step, "At every frame.")
      .read_only("window_32", &RolloutErrors::window_32, "Every 32 frames.")
      .read_only("per_motion", &RolloutErrors::per_motion, "At every motion's start.")
      .read_only("open_loop", &RolloutErrors::open_loop, "Never.")
      .read_only("open_loop_from_setpoints", &RolloutErrors::open_loop_from_setpoints,
                 "Never, and through the model's valves; or None.")
      .done();
  py::enum_<Restart>(module, "Restart", "How often a prediction is corrected.")
      .value("every_frame", Restart::every_frame, "one_step")
      .value("every_32_frames", Restart::every_32_frames, "window_32")
      .value("every_motion", Restart::every_motion, "per_motion")
      .value("at_the_start_only", Restart::at_the_start_only, "open_loop");
}

void bind_novel_frames(py::module_& module) {
  py::class_<NovelFrames> novel(module, "NovelFrames",
                                "Tracked frames, and how many of them lie beyond what a model "
                                "learnt from, by whether their pressures do.");
  py::class_<NovelFrames::Count>(module, "NovelFramesCount", "Of the frames of NovelFrames.")
      .def_readonly("frames", &NovelFrames::Count::frames, "All.")
      .def_readonly("novel", &NovelFrames::Count::novel, "Beyond what the model learnt from.")
      .def("__repr__", [](const NovelFrames::Count& count) {
        return fmt::format("NovelFramesCount(frames={}, novel={})", count.frames, count.novel);
      });
  novel
      .def_readonly("pressures_within", &NovelFrames::pressures_within,
                    "Pressures within the recorded ranges.")
      .def_readonly("pressures_beyond", &NovelFrames::pressures_beyond, "Pressures beyond them.")
      .def("__repr__", [](const NovelFrames& frames) {
        return fmt::format("NovelFrames(pressures_within={} of {}, pressures_beyond={} of {})",
                           frames.pressures_within.novel, frames.pressures_within.frames,
                           frames.pressures_beyond.novel, frames.pressures_beyond.frames);
      });
}

}  // namespace

void bind_evaluation(py::module_& module) {
  bind_errors_of_tips(module);
  bind_novel_frames(module);
  Record<Evaluation>(module, "Evaluation", "Errors of models on one recording.")
      .read_only("frames", &Evaluation::frames, "That count.")
      .read_only("no_load_open_loop", &Evaluation::no_load_open_loop, "Of the simple model.")
      .read_only("network", &Evaluation::network, "RolloutErrors, or None.")
      .read_only("position_reduction_percent", &Evaluation::position_reduction_percent,
                 "Open loop, network against no load [%].")
      .read_only("orientation_reduction_percent", &Evaluation::orientation_reduction_percent,
                 "The same of headings [%].")
      .done()
      .def_readonly("novel", &Evaluation::novel,
                    "NovelFrames of the network, or None where it does not know what it learnt "
                    "from.")
      .def("__str__", [](const Evaluation& evaluation) { return to_text(evaluation); })
      .def("_repr_svg_", &evaluation_picture, py::call_guard<py::gil_scoped_release>());
  module.def(
      "predict",
      [](const ForwardModel& model, const Episode& episode, Restart restart, int jobs) {
        FrameMatrix predicted;
        {
          const py::gil_scoped_release others_may_run;
          predicted = predict(model, episode, restart, jobs);
        }
        return copy_of<float>(predicted, {predicted.rows(), predicted.cols() / 3, 3});
      },
      py::arg("model"), py::arg("episode"), py::arg("restart"), py::arg("jobs") = 0,
      "Backbones float32 (T, m, 3) of an episode, fed with "
      "its pressures; NaN where a frame is only a start.");
  module.def(
      "evaluate",
      [](const ForwardModel& no_load, const ForwardModel* network, const py::iterable& episodes,
         int jobs) {
        const std::vector<Episode> copies = episodes_from(episodes);
        const py::gil_scoped_release others_may_run;
        return evaluate(no_load, network, copies, jobs);
      },
      py::arg("no_load"), py::arg("network"), py::arg("episodes"), py::arg("jobs") = 0,
      "Errors of the no-load model and, unless None, of a network.");
}

}  // namespace limber::python
