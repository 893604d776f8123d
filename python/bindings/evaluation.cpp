#include "limber/training/evaluation.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/report/training_report.hpp"
#include "others_may_run.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_errors_of_tips(py::module_& module) {
  Record<ErrorStatistics>(
      module, "ErrorStatistics",
      "Errors over frames, in the unit of the field that holds them; NaN where there is no frame.")
      .read_only("mean", &ErrorStatistics::mean, "Mean over frames.")
      .read_only("std", &ErrorStatistics::std, "Standard deviation over frames.")
      .read_only("p95", &ErrorStatistics::p95, "95th percentile over frames.")
      .read_only("worst_motion", &ErrorStatistics::worst_motion,
                 "Largest mean over the frames of one motion.")
      .done();
  Record<TipErrors>(module, "TipErrors", "Errors of the predicted end effector.")
      .read_only("position_cm", &TipErrors::position_cm, "ErrorStatistics of its distance [cm].")
      .read_only("orientation_rad", &TipErrors::orientation_rad,
                 "ErrorStatistics of its heading, in space of its rotation [rad].")
      .done();
  Record<RolloutErrors>(module, "RolloutErrors",
                        "TipErrors by how often a prediction is corrected by what was recorded.")
      .read_only("one_step", &RolloutErrors::one_step, "TipErrors, corrected at every frame.")
      .read_only("window_32", &RolloutErrors::window_32, "TipErrors, corrected every 32 frames.")
      .read_only("per_motion", &RolloutErrors::per_motion,
                 "TipErrors, corrected at every motion's start.")
      .read_only("open_loop", &RolloutErrors::open_loop,
                 "TipErrors, never corrected after the first frame: how good a plan is.")
      .read_only("open_loop_from_setpoints", &RolloutErrors::open_loop_from_setpoints,
                 "TipErrors, never corrected, and from set points through the model's valves; "
                 "None where the model has none.")
      .done();
  Choice<Restart>(module, "Restart", "How often a prediction is corrected by what was recorded.")
      .value("every_frame", Restart::every_frame, "at every frame: RolloutErrors.one_step")
      .value("every_32_frames", Restart::every_32_frames,
             "every 32 frames: RolloutErrors.window_32")
      .value("every_motion", Restart::every_motion,
             "at every motion's start: RolloutErrors.per_motion")
      .value("at_the_start_only", Restart::at_the_start_only,
             "never after the first frame: RolloutErrors.open_loop");
}

void bind_novel_frames(py::module_& module) {
  py::class_<NovelFrames> novel(module, "NovelFrames",
                                "Tracked frames, and how many of them lie beyond what a model "
                                "learnt from, by whether their pressures do.");
  Record<NovelFrames::Count>(module, "NovelFramesCount",
                             "So many frames of NovelFrames, and so many of them novel.")
      .read_only("frames", &NovelFrames::Count::frames, "Number of frames.")
      .read_only("novel", &NovelFrames::Count::novel, "Frames beyond what the model learnt from.")
      .done();
  novel
      .def_readonly("pressures_within", &NovelFrames::pressures_within,
                    "NovelFramesCount of frames whose pressures are within the recorded ranges.")
      .def_readonly("pressures_beyond", &NovelFrames::pressures_beyond,
                    "NovelFramesCount of frames whose pressures are beyond them.")
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
      .read_only("frames", &Evaluation::frames,
                 "Frames that count: tracked, and not the first of an episode.")
      .read_only("no_load_open_loop", &Evaluation::no_load_open_loop,
                 "TipErrors of the no-load model, never corrected.")
      .read_only("network", &Evaluation::network,
                 "RolloutErrors of the network, or None where none was given.")
      .read_only("position_reduction_percent", &Evaluation::position_reduction_percent,
                 "How much smaller the network's open-loop error of position is than the no-load "
                 "model's [%].")
      .read_only("orientation_reduction_percent", &Evaluation::orientation_reduction_percent,
                 "The same of headings [%].")
      .read_only("noise_multiplied", &Evaluation::noise_multiplied,
                 "How many times as large a tracker's noise comes out of one step; 0 without a "
                 "network.")
      .done()
      .def_readonly("novel", &Evaluation::novel,
                    "NovelFrames of the network, or None where it does not know what it learnt "
                    "from.")
      .def("__str__", [](const Evaluation& evaluation) { return to_text(evaluation); })
      .def("_repr_svg_", &evaluation_picture, py::call_guard<OthersMayRun>());
  module.def(
      "predict",
      [](const ForwardModel& model, const Episode& episode, Restart restart, int jobs) {
        require_jobs(jobs);
        const FrameMatrix predicted =
            interruptibly([&] { return predict(model, episode, restart, jobs); });
        return copy_of<float>(
            predicted, {predicted.rows(), model.point_count(), pose_size(model.dimension())});
      },
      "model"_a, "episode"_a, "restart"_a, "jobs"_a = 0,
      "Predicted backbones float32 (T, m, 3), in space (T, m, 7), of an episode, fed with its "
      "pressures; NaN where a frame is only a start. restart: a Restart; jobs: threads, 0: one "
      "per core.");
  module.def(
      "evaluate",
      [](const ForwardModel& no_load, const ForwardModel* network, const EpisodeList& episodes,
         int jobs) {
        require_jobs(jobs);
        const std::vector<Episode> copies = episodes_from(episodes);
        return interruptibly([&] { return evaluate(no_load, network, copies, jobs); });
      },
      "no_load"_a, "network"_a, "episodes"_a, "jobs"_a = 0,
      "Evaluation: errors of the no-load model and of a network on episodes. no_load: "
      "ForwardModel(arm); network: ForwardModel(arm, model), or None. Take episodes "
      "that it was not trained on. jobs: threads, 0: one per core. Raises InputError "
      "where no episode has three frames, or nothing was tracked.");
}

}  // namespace limber::python
