#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "limber/training/fine_tuning.hpp"
#include "limber/training/trainer.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_choices(py::module_& module) {
  Choice<BackboneLayout>(module, "BackboneLayout", "How backbones enter the network.")
      .value("base_poses", BackboneLayout::base_poses,
             "each plate's pose about the base, the paper's")
      .value("gap_poses", BackboneLayout::gap_poses, "each plate's pose about the one before it");
  Choice<OutputForm>(module, "OutputForm", "What the network's outputs mean.")
      .value("compensation", OutputForm::compensation,
             "the paper's: what is added to the no-load model's backbone, docs/model.md (5)")
      .value("gated_change", OutputForm::gated_change,
             "how much each number changes, through a gate, docs/model.md (16)");
  Choice<Optimiser>(module, "Optimiser", "How weights are changed.")
      .value("sgd", Optimiser::sgd, "stochastic gradient descent, the paper's")
      .value("adam", Optimiser::adam, "Kingma and Ba, 2015")
      .value("soap", Optimiser::soap,
             "Adam in the directions in which gradients vary, Vyas et al., 2024");
  Choice<LossReduction>(module, "LossReduction", "How windows' errors become one number.")
      .value("sum_over_batch", LossReduction::sum_over_batch,
             "the paper's: the step grows with the batch")
      .value("mean_over_batch", LossReduction::mean_over_batch,
             "the step does not grow with the batch");
  Choice<Scaling>(module, "Scaling", "What the network's numbers are scaled to.")
      .value("unit_range", Scaling::unit_range, "[0, 1], the paper's")
      .value("unit_spread", Scaling::unit_spread, "mean 0, standard deviation 1")
      .value("shared_range", Scaling::shared_range,
             "[0, 1], one range for poses and compensations: 0 is the no-load model")
      .value("range_by_unit", Scaling::range_by_unit,
             "the same with one range for all positions and one for all angles");
  Choice<FirstWeights>(module, "FirstWeights", "What weights are before training.")
      .value("he", FirstWeights::he, "He et al., 2015, the last layer a tenth; biases zero")
      .value("torch", FirstWeights::torch,
             "weights and biases within 1 / sqrt(inputs), as PyTorch's linear layers");
  Choice<TrainingStatus>(module, "TrainingStatus", "How training ended.")
      .value("finished", TrainingStatus::finished, "all epochs were done")
      .value("interrupted", TrainingStatus::interrupted,
             "it was stopped; the model is the best until then")
      .value("diverged", TrainingStatus::diverged,
             "the error became infinite, see TrainingResult.message");
}

void bind_training_stages(py::module_& module) {
  Record<TrainingStage>(module, "TrainingStage", "A part of training, windows of one length.")
      .field("window_frames", &TrainingStage::window_frames,
             "Frames that the network is rolled over, fed with its own output, >= 1.")
      .field("windows_per_batch", &TrainingStage::windows_per_batch,
             "Windows for each change of the weights, >= 1.")
      .field("epochs", &TrainingStage::epochs, "Passes over the training data, >= 1.")
      .keywords()
      .fixed()
      .done();
}

/// Of one run: where its numbers come from, how long it lasts, where it is stored.
void add_run_fields(Record<TrainingSettings>& settings) {
  using S = TrainingSettings;
  settings.field("seed", &S::seed, "Seed of first weights and of the windows' order.")
      .field("jobs", &S::jobs, "Threads, 0: one per core; never changes a result.")
      .field("time_limit_s", &S::time_limit_s,
             "> 0: epochs are scaled to about this time, once, at the start [s]; 0: no limit.")
      .field("keep_epoch", &S::keep_epoch,
             "> 0: training ends after this epoch, whose network is kept; nothing may validate. 0: "
             "the best one is.")
      .field("validation_interval", &S::validation_interval,
             "Epochs from one validation to the next, >= 1.")
      .field("checkpoint", &S::checkpoint,
             "File that the run is stored in to go on from; empty: none.")
      .field("checkpoint_interval_s", &S::checkpoint_interval_s,
             "Least time between storing it [s], >= 0.")
      .field("resume", &S::resume,
             "Whether to go on from the checkpoint: the result is that of an unbroken run.");
}

void bind_settings(py::module_& module) {
  using S = TrainingSettings;
  Record<S> settings(module, "TrainingSettings",
                     "Everything that decides a training run besides its data; best_preset() fills "
                     "it in, TrainingSettings() has no stages yet. Same settings, data and seed: "
                     "same network, for any number of jobs. `train` raises InputError for a value "
                     "out of range.");
  settings.field("preset", &S::preset, "\"paper\" or \"best\"; training_preset fills in the rest.")
      .field("layout", &S::layout, "BackboneLayout: how backbones enter the network.")
      .field("form", &S::form, "OutputForm: what the network's outputs mean.")
      .field("reads_velocity", &S::reads_velocity,
             "Whether the network reads how the backbone changed in the frame before.")
      .field("hidden_units", &S::hidden_units,
             "Units of each hidden layer, >= 1 each; a copy: assign a whole list.")
      .field("scaling", &S::scaling, "Scaling of the network's inputs and outputs.")
      .field("error_in_user_units", &S::error_in_user_units,
             "True: frame errors count in metres and radians; False: in units of the spread of "
             "what is added to the no-load model.")
      .field("first_weights", &S::first_weights, "FirstWeights: what training begins with.")
      .field("bounded", &S::bounded,
             "Whether gaps between plates stay within what was recorded of them.")
      .field("reduction", &S::reduction, "LossReduction: how a batch's errors become one number.")
      .list("stages", &S::stages,
            "List of TrainingStage, done in this order. A copy, whose fields can't be set: assign "
            "whole lists.")
      .field("optimiser", &S::optimiser, "Optimiser: how weights are changed.")
      .field("learning_rate", &S::learning_rate, "Step size at the start, > 0.")
      .field("cosine_decay", &S::cosine_decay,
             "True: the step size falls towards zero over the run; False: it stays.")
      .field("gradient_norm_limit", &S::gradient_norm_limit,
             "Longer gradients are shortened to this; 0: never.")
      .field("growth_limit", &S::growth_limit,
             "What a window's gradients may grow to on their way back, over what was put in; 0: "
             "anything.")
      .field("first_frames_power", &S::first_frames_power,
             "A window's frame k, from 0, counts (k + 1)^-power; 0: all count alike.")
      .field("weight_decay", &S::weight_decay,
             "By this times the learning rate every step shortens the weights, >= 0.")
      .field("shift_windows", &S::shift_windows,
             "Whether each epoch cuts its windows at another frame.")
      .field("family_size", &S::family_size,
             "Numbers that say which of a family's arms it is, 0 to 64; 0: the network is one "
             "arm's.")
      .field("ensemble", &S::ensemble,
             "Networks trained together, each from its own weights, 1 to 64.")
      .field("replay_share", &S::replay_share,
             "Share of an epoch's windows that comes from TrainingData.replay, 0 to 0.95.");
  add_run_fields(settings);
  settings.keywords().done().def_property_readonly("epoch_count", &S::epoch_count,
                                                   "Epochs of all stages together.");
}

void bind_training_presets(py::module_& module) {
  module.def("training_preset", &training_preset, "name"_a,
             "TrainingSettings by name: \"best\" or \"paper\". Raises InputError naming them.");
  module.def("best_preset", &best_preset,
             "The default TrainingSettings: a network that predicts how each plate moves "
             "about the one before it, trained by SOAP in windows of 32 frames. epoch_count says "
             "how many epochs; set_epoch_count changes that.");
  module.def("paper_preset", &paper_preset,
             "The TrainingSettings of the paper: windows of 32 frames, SGD, 6000 epochs. For "
             "comparison.");
  module.def("set_epoch_count", &set_epoch_count, "settings"_a, "epochs"_a,
             "Scales the stages of `settings` to so many epochs in all, keeping their "
             "proportions. Raises InputError where there are fewer epochs than stages.");
  module.def("set_window_frames", &set_window_frames, "settings"_a, "window_frames"_a,
             "Replaces the stages of `settings` by windows of these lengths [frames], in "
             "this order, which share the epochs. Raises InputError where there is none or "
             "one is < 1.");
  module.def("set_family_size", &set_family_size, "settings"_a, "size"_a,
             "Settings for a family of arms that so many numbers tell apart, 1 to 64: trained by "
             "SOAP in windows of 32 frames; replaces the stages' windows and hidden_units, three "
             "layers of 100.");
  module.def("fine_tuning_of", &fine_tuning_of, "preset"_a,
             "Settings for fine_tune, to go on with a model that has learnt: the last stage "
             "of `preset` with half its epochs and a tenth of its learning_rate; Adam in place of "
             "SOAP, without weight_decay, and all frames of a window alike.");
}

}  // namespace

void bind_training_settings(py::module_& module) {
  bind_choices(module);
  bind_training_stages(module);
  bind_settings(module);
  bind_training_presets(module);
}

}  // namespace limber::python
