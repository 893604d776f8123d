#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <pybind11/stl_bind.h>

#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/report/training_report.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/gap_bounds_fit.hpp"
#include "limber/training/learnt_region_fit.hpp"
#include "limber/training/stage_choice.hpp"
#include "limber/training/trainer.hpp"
#include "limber/training/unseen_error.hpp"
#include "record.hpp"

// So that settings.stages[0].epochs = 3 changes the settings, as in C++.
PYBIND11_MAKE_OPAQUE(std::vector<limber::TrainingStage>)

namespace limber::python {

namespace {

/// Hooks of one run: Ctrl-C, and a Python function of every epoch that may ask to stop.
TrainingHooks hooks_for(CallerThread& caller, const py::object& on_epoch) {
  TrainingHooks hooks;
  hooks.should_stop = [&caller] { return caller.should_stop(); };
  if (!on_epoch.is_none()) {
    hooks.on_epoch = [&caller, &on_epoch](const LearningCurvePoint& point) {
      caller.call([&] {
        const py::object said = on_epoch(point);
        if (!said.is_none() && !said.cast<bool>()) {
          caller.ask_to_stop();
        }
      });
    };
  }
  return hooks;
}

void bind_choices(py::module_& module) {
  py::enum_<BackboneLayout>(module, "BackboneLayout", "How backbones enter the network.")
      .value("base_poses", BackboneLayout::base_poses, "the paper's")
      .value("gap_poses", BackboneLayout::gap_poses, "each plate's pose about the one before it");
  py::enum_<OutputForm>(module, "OutputForm", "What the network's outputs mean.")
      .value("compensation", OutputForm::compensation, "the paper's (5)")
      .value("gated_change", OutputForm::gated_change, "(16)");
  py::enum_<Optimiser>(module, "Optimiser", "How weights are changed.")
      .value("sgd", Optimiser::sgd, "the paper's")
      .value("adam", Optimiser::adam);
  py::enum_<LossReduction>(module, "LossReduction", "How windows' errors become one number.")
      .value("sum_over_batch", LossReduction::sum_over_batch)
      .value("mean_over_batch", LossReduction::mean_over_batch);
  py::enum_<Scaling>(module, "Scaling", "What the network's numbers are scaled to.")
      .value("unit_range", Scaling::unit_range, "[0, 1], the paper's")
      .value("unit_spread", Scaling::unit_spread, "mean 0, standard deviation 1");
  py::enum_<TrainingStatus>(module, "TrainingStatus", "How training ended.")
      .value("finished", TrainingStatus::finished)
      .value("interrupted", TrainingStatus::interrupted)
      .value("diverged", TrainingStatus::diverged);
}

void bind_settings(py::module_& module) {
  using S = TrainingSettings;
  Record<TrainingStage>(module, "TrainingStage", "A part of training, windows of one length.")
      .field("window_frames", &TrainingStage::window_frames, "Frames a window.")
      .field("windows_per_batch", &TrainingStage::windows_per_batch, "Windows a batch.")
      .field("epochs", &TrainingStage::epochs, ">= 1.")
      .keywords()
      .done();
  py::bind_vector<std::vector<TrainingStage>>(module, "TrainingStages",
                                              "Stages of training, a list.")
      .def("__repr__", [](const py::object& stages) {
        return "TrainingStages(" + std::string(py::repr(py::list(stages))) + ")";
      });
  Record<S>(module, "TrainingSettings",
            "Everything that decides a training run besides its data. Same settings, data and "
            "seed: same network, for any number of jobs.")
      .field("preset", &S::preset, "\"paper\" or \"best\"; training_preset fills in the rest.")
      .field("layout", &S::layout, "BackboneLayout.")
      .field("form", &S::form, "OutputForm.")
      .field("hidden_units", &S::hidden_units, "Of each hidden layer; assign a whole list.")
      .field("scaling", &S::scaling, "Scaling.")
      .field("reduction", &S::reduction, "LossReduction.")
      .field("stages", &S::stages, "In this order.")
      .field("optimiser", &S::optimiser, "Optimiser.")
      .field("learning_rate", &S::learning_rate, "At the start.")
      .field("cosine_decay", &S::cosine_decay, "Towards zero over the run; else constant.")
      .field("gradient_norm_limit", &S::gradient_norm_limit, "0: none.")
      .field("average_decay", &S::average_decay, "Of the weights' moving average; 0: none.")
      .field("input_noise", &S::input_noise, "Added to a window's first backbone, normalised.")
      .field("shift_windows", &S::shift_windows, "Each epoch cuts its windows elsewhere.")
      .field("ensemble", &S::ensemble, "Networks trained together, 1 to 64.")
      .field("replay_share", &S::replay_share, "Of an epoch's windows, from what is replayed.")
      .field("seed", &S::seed, "Of all chance.")
      .field("jobs", &S::jobs, "Threads, 0: one per core.")
      .field("time_limit_s", &S::time_limit_s, "Fixes the number of epochs at the start [s].")
      .field("validation_interval", &S::validation_interval, "Epochs between validations.")
      .field("checkpoint", &S::checkpoint, "File to go on from; empty: none.")
      .field("checkpoint_interval_s", &S::checkpoint_interval_s, "Between storing [s].")
      .field("resume", &S::resume, "Go on from the checkpoint.")
      .keywords()
      .done()
      .def_property_readonly("epoch_count", &S::epoch_count, "Of all stages.");
  module.def("training_preset", &training_preset, py::arg("name"), "Settings by name.");
  module.def("best_preset", &best_preset, "The default.");
  module.def("paper_preset", &paper_preset, "As published.");
  module.def("set_epoch_count", &set_epoch_count, py::arg("settings"), py::arg("epochs"),
             "Scales the stages to so many epochs in all.");
  module.def("set_window_frames", &set_window_frames, py::arg("settings"), py::arg("window_frames"),
             "Stages of windows of these lengths instead.");
  module.def("fine_tuning_of", &fine_tuning_of, py::arg("preset"),
             "Settings to train a model on that has learnt already.");
}

py::list copies_of(const std::vector<Episode>& episodes) {
  std::vector<Episode> copies;
  {
    const py::gil_scoped_release others_may_run;
    copies = episodes;
  }
  return episodes_to(std::move(copies));
}

void bind_data(py::module_& module) {
  py::class_<TrainingData>(module, "TrainingData",
                           "What is learnt from, what chooses the best epoch, "
                           "what is replayed, and what the error is measured "
                           "on. Lists of Episode: copies; assign whole lists.")
      .def(py::init([](const py::iterable& training, const py::iterable& validation,
                       const py::iterable& replay, const py::iterable& unseen) {
             return TrainingData{episodes_from(training), episodes_from(validation),
                                 episodes_from(replay), episodes_from(unseen)};
           }),
           py::arg("training"), py::arg("validation") = py::tuple(),
           py::arg("replay") = py::tuple(), py::arg("unseen") = py::tuple())
      .def_property(
          "training", [](const TrainingData& data) { return copies_of(data.training); },
          [](TrainingData& data, const py::iterable& e) { data.training = episodes_from(e); },
          "Learnt from.")
      .def_property(
          "validation", [](const TrainingData& data) { return copies_of(data.validation); },
          [](TrainingData& data, const py::iterable& e) { data.validation = episodes_from(e); },
          "Chooses the best epoch.")
      .def_property(
          "replay", [](const TrainingData& data) { return copies_of(data.replay); },
          [](TrainingData& data, const py::iterable& e) { data.replay = episodes_from(e); },
          "What a model to be fine-tuned was trained on.")
      .def_property(
          "unseen", [](const TrainingData& data) { return copies_of(data.unseen); },
          [](TrainingData& data, const py::iterable& e) { data.unseen = episodes_from(e); },
          "Never looked at by `train`.")
      .def_readonly("held_back", &TrainingData::held_back,
                    "Which of the episodes given to hold_back_validation validate.")
      .def("__repr__", [](const TrainingData& data) {
        return "TrainingData(training=" + std::to_string(data.training.size()) +
               " episodes, validation=" + std::to_string(data.validation.size()) +
               ", replay=" + std::to_string(data.replay.size()) +
               ", unseen=" + std::to_string(data.unseen.size()) + ")";
      });
  module.def(
      "hold_back_validation",
      [](const py::iterable& episodes, double fraction, std::uint64_t seed) {
        std::vector<Episode> copies = episodes_from(episodes);
        const py::gil_scoped_release others_may_run;
        return hold_back_validation(std::move(copies), fraction, seed);
      },
      py::arg("episodes"), py::arg("fraction"), py::arg("seed"),
      "Holds back whole episodes for validation, about `fraction` of the frames.");
  module.def("hold_back_unseen", &hold_back_unseen, py::arg("data"), py::arg("fraction"),
             py::arg("seed"), py::call_guard<py::gil_scoped_release>(),
             "Then moves about `fraction` of the frames to data.unseen.");
}

void bind_training_result(py::module_& module) {
  Record<LearningCurvePoint>(module, "LearningCurvePoint", "One row of the learning curve.")
      .read_only("epoch", &LearningCurvePoint::epoch, "From 1.")
      .read_only("window_frames", &LearningCurvePoint::window_frames, "Of its stage.")
      .read_only("learning_rate", &LearningCurvePoint::learning_rate, "Of its first batch.")
      .read_only("loss", &LearningCurvePoint::loss, "Mean frame error, normalised units.")
      .read_only("validation_position_error_cm", &LearningCurvePoint::validation_position_error_cm,
                 "Of the tip [cm]; NaN where not measured.")
      .read_only("elapsed_s", &LearningCurvePoint::elapsed_s, "[s]")
      .done();
  Record<LongRollout>(module, "LongRollout", "How far a model drifts if it is never corrected.")
      .read_only("frames", &LongRollout::frames, "Rolled out.")
      .read_only("max_distance_m", &LongRollout::max_distance_m, "Of a plate from the base [m].")
      .read_only("max_heading_rad", &LongRollout::max_heading_rad, "Of a plate [rad].")
      .read_only("bounded", &LongRollout::bounded, "No plate beyond twice the arm's length.")
      .read_only("held_share", &LongRollout::held_share, "Of the frames, at a bound.")
      .property("ran_away", &LongRollout::ran_away, "Unbounded, or leaning on its bounds.")
      .done();
  Record<TrainingResult>(module, "TrainingResult", "What came of training.")
      .read_only("status", &TrainingResult::status, "TrainingStatus.")
      .read_only("message", &TrainingResult::message, "Why it diverged, and what to try.")
      .read_only("best_epoch", &TrainingResult::best_epoch, "Which the model is of.")
      .read_only("best_validation_position_error_cm",
                 &TrainingResult::best_validation_position_error_cm, "Open loop [cm].")
      .read_only("wall_time_s", &TrainingResult::wall_time_s, "[s]")
      .done()
      .def_readonly("model", &TrainingResult::model, "The best by validation.")
      .def_readonly("passed_over_epochs", &TrainingResult::passed_over_epochs,
                    "Better by validation, but their networks ran away in a long rollout.")
      .def_readonly("long_rollout", &TrainingResult::long_rollout, "LongRollout of the best epoch.")
      .def_readonly("curve", &TrainingResult::curve, "LearningCurvePoint, one an epoch.")
      .def_readonly("member_validation_position_error_cm",
                    &TrainingResult::member_validation_position_error_cm, "Of an ensemble [cm].")
      .def(
          "_repr_svg_",
          [](const TrainingResult& result) { return learning_curve_svg(result.curve); },
          py::call_guard<py::gil_scoped_release>());
}

void bind_stage_choice(py::module_& module) {
  Record<WindowsTried>(module, "WindowsTried", "Windows of stages, and how a short run did.")
      .read_only("window_frames", &WindowsTried::window_frames, "Of each stage.")
      .read_only("one_step_cm", &WindowsTried::one_step_cm, "Tip error by validation [cm].")
      .read_only("window_32_cm", &WindowsTried::window_32_cm, "Over rollouts of 32 frames.")
      .read_only("window_600_cm", &WindowsTried::window_600_cm, "Of 600 frames: what decides.")
      .done();
  Record<StageChoice>(module, "StageChoice", "What a race between windows found.")
      .read_only("tried", &StageChoice::tried, "WindowsTried, the preset's first.")
      .read_only("chosen", &StageChoice::chosen, "Index in `tried`.")
      .read_only("race_epochs", &StageChoice::race_epochs, "Of each short run.")
      .read_only("epochs", &StageChoice::epochs, "Left for the chosen windows.")
      .done()
      .def("__str__", [](const StageChoice& choice) { return to_text(choice); });
  module.def(
      "choose_stages",
      [](const ArmDescription& arm, const TrainingData& data, TrainingSettings& settings,
         const py::object& on_epoch) {
        CallerThread caller;
        const TrainingHooks hooks = hooks_for(caller, on_epoch);
        return caller.run([&] { return choose_stages(arm, data, settings, hooks); });
      },
      py::arg("arm"), py::arg("data"), py::arg("settings"), py::arg("on_epoch") = py::none(),
      "Chooses windows by validation in short runs, as the program does without --windows; "
      "`settings` gets the chosen stages and the epochs that are left.");
}

void bind_runs(py::module_& module) {
  module.def(
      "train",
      [](const ArmDescription& arm, const TrainingData& data, const TrainingSettings& settings,
         const py::object& on_epoch) {
        CallerThread caller;
        const TrainingHooks hooks = hooks_for(caller, on_epoch);
        return caller.run([&] { return train(arm, data, settings, hooks); });
      },
      py::arg("arm"), py::arg("data"), py::arg("settings"), py::arg("on_epoch") = py::none(),
      "Trains a network. `on_epoch(LearningCurvePoint)` comes after every epoch; False stops the "
      "run. Ctrl-C raises KeyboardInterrupt; with a checkpoint, resume=True goes on.");
  module.def(
      "fine_tune",
      [](const ArmDescription& arm, const TrainingData& data, const TrainingSettings& settings,
         const CompensationModel& start, const py::object& on_epoch) {
        CallerThread caller;
        const TrainingHooks hooks = hooks_for(caller, on_epoch);
        return caller.run([&] { return fine_tune(arm, data, settings, start, hooks); });
      },
      py::arg("arm"), py::arg("data"), py::arg("settings"), py::arg("start"),
      py::arg("on_epoch") = py::none(), "The same, from the weights of a model.");
  module.def(
      "gap_bounds_of",
      [](const py::iterable& episodes) {
        const std::vector<Episode> copies = episodes_from(episodes);
        const py::gil_scoped_release others_may_run;
        return gap_bounds_of(copies);
      },
      py::arg("episodes"),
      "The bounds of a model that learnt from these episodes, for the model.bounds of an old one.");
  module.def(
      "learnt_region_of", [](const TrainingData& data) { return learnt_region_of(data); },
      py::arg("data"), py::call_guard<py::gil_scoped_release>(),
      "What a model has learnt that was trained on these data, for model.learnt.");
  module.def(
      "note_unseen",
      [](const ArmDescription& arm, CompensationModel& model, const py::iterable& unseen,
         int jobs) {
        const std::vector<Episode> episodes = episodes_from(unseen);
        const py::gil_scoped_release others_may_run;
        note_unseen(arm, model, episodes, jobs);
      },
      py::arg("arm"), py::arg("model"), py::arg("unseen"), py::arg("jobs") = 0,
      "Measures the finished model's error on episodes that it has never seen, and stores it.");
}

}  // namespace

void bind_training(py::module_& module) {
  bind_choices(module);
  bind_settings(module);
  bind_data(module);
  bind_training_result(module);
  bind_stage_choice(module);
  bind_runs(module);
}

}  // namespace limber::python
