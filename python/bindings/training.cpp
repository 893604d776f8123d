#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/gap_bounds_fit.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// Hooks of one run: Ctrl-C, and a Python function of every epoch that may ask to stop.
TrainingHooks hooks_for(CallerThread& caller, const py::object& on_epoch) {
  TrainingHooks hooks;
  hooks.should_stop = [&caller] { return caller.should_stop(); };
  if (!on_epoch.is_none()) {
    hooks.on_epoch = [&caller, &on_epoch](const LearningCurvePoint& point) {
      caller.call([&] {
        if (!asks_to_go_on(on_epoch(point), "on_epoch")) {
          caller.ask_to_stop();
        }
      });
    };
  }
  return hooks;
}

void bind_data(py::module_& module) {
  py::class_<TrainingData>(module, "TrainingData",
                           "What is learnt from, what chooses the best epoch, "
                           "what is replayed, and what the error is measured "
                           "on. Lists of Episode: copies; assign whole lists.")
      .def(py::init([](const EpisodeList& training, const EpisodeList& validation,
                       const EpisodeList& replay, const EpisodeList& unseen) {
             return TrainingData{episodes_from(training), episodes_from(validation),
                                 episodes_from(replay), episodes_from(unseen)};
           }),
           "training"_a, "validation"_a = py::tuple(), "replay"_a = py::tuple(),
           "unseen"_a = py::tuple(), "Lists of Episode, copied; no episode belongs in two of them.")
      .def_property(
          "training", [](const TrainingData& data) { return episodes_to(data.training); },
          [](TrainingData& data, const EpisodeList& e) { data.training = episodes_from(e); },
          "List of Episode to learn from; a copy.")
      .def_property(
          "validation", [](const TrainingData& data) { return episodes_to(data.validation); },
          [](TrainingData& data, const EpisodeList& e) { data.validation = episodes_from(e); },
          "List of Episode that chooses the best epoch; a copy.")
      .def_property(
          "replay", [](const TrainingData& data) { return episodes_to(data.replay); },
          [](TrainingData& data, const EpisodeList& e) { data.replay = episodes_from(e); },
          "List of Episode that a model to be fine-tuned was trained on before, so that "
          "it does not forget them; a copy.")
      .def_property(
          "unseen", [](const TrainingData& data) { return episodes_to(data.unseen); },
          [](TrainingData& data, const EpisodeList& e) { data.unseen = episodes_from(e); },
          "List of Episode for note_unseen, which `train` never looks at; a copy.")
      .def_readwrite("arms", &TrainingData::arms,
                     "For a family: the arm of each training episode, from 0; empty: each one of "
                     "its own. A copy; assign whole lists.")
      .def_readonly("held_back", &TrainingData::held_back,
                    "Numbers, from 0, of the episodes given to hold_back_validation that validate.")
      .def("__repr__", [](const TrainingData& data) {
        return "TrainingData(training=" + std::to_string(data.training.size()) +
               " episodes, validation=" + std::to_string(data.validation.size()) +
               ", replay=" + std::to_string(data.replay.size()) +
               ", unseen=" + std::to_string(data.unseen.size()) + ")";
      });
  module.def(
      "hold_back_validation",
      [](const EpisodeList& episodes, double fraction, std::uint64_t seed) {
        std::vector<Episode> copies = episodes_from(episodes);
        const OthersMayRun others_may_run;
        return hold_back_validation(std::move(copies), fraction, seed);
      },
      "episodes"_a, "fraction"_a, "seed"_a,
      "TrainingData of the episodes, some of which are held back for validation: about `fraction` "
      "of the frames, in (0, 1), in whole episodes chosen by `seed`, at least one. Of one that has "
      "over 40 % of all frames its end is held back. Raises InputError where nothing would be left "
      "to learn from.");
  // With Python's lock, as it changes what others may read.
  module.def("hold_back_unseen", &hold_back_unseen, "data"_a, "fraction"_a, "seed"_a,
             "Moves about `fraction` of the frames, in [0, 1), from data.training to "
             "data.unseen, for note_unseen to measure the error on: whole episodes chosen by "
             "`seed`, or the end of the longest. `data` is changed; where it is too short, "
             "nothing is moved. Call it after hold_back_validation.");
}

void bind_training_result(py::module_& module) {
  Record<LearningCurvePoint>(module, "LearningCurvePoint", "One row of the learning curve.")
      .read_only("epoch", &LearningCurvePoint::epoch, "Number of the epoch, from 1.")
      .read_only("window_frames", &LearningCurvePoint::window_frames, "Frames of its windows.")
      .read_only("learning_rate", &LearningCurvePoint::learning_rate,
                 "Step size of its first batch.")
      .read_only("loss", &LearningCurvePoint::loss, "Mean error of a frame, in normalised units.")
      .read_only("validation_position_error_cm", &LearningCurvePoint::validation_position_error_cm,
                 "Mean distance of the tip over open-loop rollouts of up to 600 frames [cm]; NaN "
                 "where not measured.")
      .read_only("elapsed_s", &LearningCurvePoint::elapsed_s, "Since training began [s].")
      .done();
  Record<LongRollout>(module, "LongRollout", "How far a model drifts if it is never corrected.")
      .read_only("frames", &LongRollout::frames, "Number of frames that were rolled out.")
      .read_only("max_distance_m", &LongRollout::max_distance_m,
                 "Largest distance of a plate from the base [m].")
      .read_only("max_heading_rad", &LongRollout::max_heading_rad,
                 "Largest heading of a plate, in magnitude [rad].")
      .read_only(
          "bounded", &LongRollout::bounded,
          "Whether no plate was farther from the base than twice the arm's length, and bounds "
          "held a gap in at most a tenth of the frames.")
      .read_only("held_share", &LongRollout::held_share,
                 "Share of the frames in which GapBounds held a gap, 0 to 1.")
      .done();
  Record<TrainingResult>(module, "TrainingResult", "What came of training.")
      .read_only("status", &TrainingResult::status, "TrainingStatus: how training ended.")
      .read_only("message", &TrainingResult::message,
                 "Why it diverged, and what to try; else empty.")
      .read_only("best_epoch", &TrainingResult::best_epoch,
                 "Number of the epoch that the model is of, from 1.")
      .read_only("best_validation_position_error_cm",
                 &TrainingResult::best_validation_position_error_cm,
                 "Error of that epoch by validation, open loop [cm]; NaN without validation "
                 "episodes.")
      .read_only("wall_time_s", &TrainingResult::wall_time_s, "How long training took [s].")
      .done()
      .def_readonly("model", &TrainingResult::model,
                    "CompensationModel of the best epoch by validation.")
      .def_readonly("passed_over_epochs", &TrainingResult::passed_over_epochs,
                    "Epochs with smaller errors by validation whose networks ran away in a long "
                    "rollout.")
      .def_readonly("long_rollout", &TrainingResult::long_rollout,
                    "LongRollout of the best epoch, its worst network.")
      .def_readonly("curve", &TrainingResult::curve,
                    "List of LearningCurvePoint, one for each epoch.")
      .def_readonly("member_validation_position_error_cm",
                    &TrainingResult::member_validation_position_error_cm,
                    "The same of each network of an ensemble, a list [cm].")
      .def(
          "_repr_svg_",
          [](const TrainingResult& result) { return learning_curve_svg(result.curve); },
          py::call_guard<OthersMayRun>());
}

// What Python may change while its lock is let go is taken by value.
void bind_runs(py::module_& module) {
  module.def(
      "train",
      [](const ArmDescription& arm, TrainingData data, TrainingSettings settings,
         const py::object& on_epoch) {
        CallerThread caller;
        const TrainingHooks hooks = hooks_for(caller, on_epoch);
        return caller.run([&] { return train(arm, data, settings, hooks); });
      },
      "arm"_a, "data"_a, "settings"_a, "on_epoch"_a = py::none(),
      "Trains a network: a TrainingResult. data: TrainingData, as "
      "hold_back_validation makes it. `on_epoch(LearningCurvePoint)` comes after "
      "every epoch; False stops the run. Ctrl-C raises KeyboardInterrupt; with a "
      "checkpoint, resume=True goes on. Raises InputError where the data do not fit "
      "the arm, or are shorter than one window.");
  module.def(
      "fine_tune",
      [](const ArmDescription& arm, TrainingData data, TrainingSettings settings,
         CompensationModel start, const py::object& on_epoch) {
        CallerThread caller;
        const TrainingHooks hooks = hooks_for(caller, on_epoch);
        return caller.run([&] { return fine_tune(arm, data, settings, start, hooks); });
      },
      "arm"_a, "data"_a, "settings"_a, "start"_a, "on_epoch"_a = py::none(),
      "Trains on from the weights of the model `start`, which keeps its layout and "
      "sizes; else as `train`. Raises InputError where it is another arm's.");
  module.def(
      "gap_bounds_of",
      [](const EpisodeList& episodes) {
        const std::vector<Episode> copies = episodes_from(episodes);
        const OthersMayRun others_may_run;
        return gap_bounds_of(copies);
      },
      "episodes"_a,
      "The bounds of a model that learnt from these episodes, for the model.bounds of an old one.");
  module.def(
      "learnt_region_of",
      [](TrainingData data) {
        const OthersMayRun others_may_run;
        refuse_if(data.training.empty(), "learnt_region_of: no episodes to train with");
        require_planar_model(data.training.front().dimension, "limber.learnt_region_of");
        return learnt_region_of(data);
      },
      "data"_a, "What a model has learnt that was trained on these data, for model.learnt.");
  module.def(
      "note_unseen",
      [](const ArmDescription& arm, CompensationModel& model, const EpisodeList& unseen, int jobs) {
        require_jobs(jobs);
        const std::vector<Episode> episodes = episodes_from(unseen);
        CompensationModel measured = model;
        interruptibly([&] {
          note_unseen(arm, measured, episodes, jobs);
          return true;
        });
        model.prediction_error = std::move(measured.prediction_error);
        model.learnt = std::move(measured.learnt);
      },
      "arm"_a, "model"_a, "unseen"_a, "jobs"_a = 0,
      "Measures the finished model's error on episodes that it has never seen, and "
      "stores it as model.prediction_error: error_room then keeps plans so far clear "
      "of obstacles. unseen: data.unseen; motions in it count that move a set point, "
      "up to 5 s each. Where there is none, or a prediction is not finite, "
      "prediction_error becomes None. jobs: threads, 0: one per core.");
}

}  // namespace

void bind_training(py::module_& module) {
  bind_training_settings(module);
  bind_data(module);
  bind_training_result(module);
  bind_runs(module);
}

}  // namespace limber::python
