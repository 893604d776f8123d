#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "episodes.hpp"
#include "limber/common/error.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/training/adaptation.hpp"
#include "limber/training/trainer.hpp"
#include "record.hpp"

namespace limber::python {

namespace py = pybind11;
using namespace py::literals;

namespace {

void bind_trait(py::module_& module) {
  using T = TraitEstimate;
  Record<T>(module, "TraitEstimate", "What is believed of a quantity of an arm's physics.")
      .read_only("name", &T::name, "With its unit: tip_load_kg, friction_coefficient, …")
      .read_only("value", &T::value, "In that unit.")
      .read_only("deviation", &T::deviation, "Standard, of value - reference.")
      .read_only("reference", &T::reference,
                 "What the arm's file says, or what was believed before.")
      .property("differs", &T::differs, "Whether value is more than two deviations away from it.")
      .done();
}

void bind_adaptation(py::module_& module) {
  using A = Adaptation;
  Record<A>(module, "Adaptation",
            "What became of a family's network, and what its recording told. Errors are those of "
            "the tip over the seconds held back, the recording's last fifth, open loop.")
      .read_only("seconds", &A::seconds, "Recorded [s].")
      .read_only("moving_s", &A::moving_s, "Of these, in which the arm moved [s].")
      .read_only("held_back_s", &A::held_back_s, "Of these, held back [s]; 0: too few.")
      .read_only("middle_error_m", &A::middle_error_m, "Of the family's middle [m].")
      .read_only("fitted_error_m", &A::fitted_error_m, "Of the arm's vector alone [m].")
      .read_only("trained_error_m", &A::trained_error_m,
                 "With weights trained too [m]; NaN where none were.")
      .read_only("family_error_m", &A::family_error_m,
                 "Of arms of the family, as its record has it [m]; NaN: not known.")
      .read_only("distance", &A::distance,
                 "From the family's middle; about 1 for an arm of the family.")
      .read_only("distance_to_nearest", &A::distance_to_nearest,
                 "The same from the nearest arm that the family learnt from.")
      .read_only("uncertainty", &A::uncertainty, "Share of the family's spread that is left.")
      .read_only("largest_uncertainty", &A::largest_uncertainty,
                 "The same of what the recording tells least about.")
      .read_only("expected_error_m", &A::expected_error_m,
                 "Of the tip, as far as the fit can tell [m]; a tube's width is in proportion.")
      .read_only("has_trained_weights", &A::has_trained_weights,
                 "Whether `model` has weights of its own.")
      .property("is_of_family", &A::is_of_family, "Whether the family contains the arm.")
      .property("tells_too_little", &A::tells_too_little,
                "Whether the recording moved too little to tell.")
      .done()
      .def_readonly("model", &A::model, "CompensationModel of the arm, an ordinary one.")
      .def_readonly("traits", &A::traits,
                    "What the arm's vector tells of its physics: a list of TraitEstimate, beside "
                    "what the arm's file says.");
}

}  // namespace

void bind_families(py::module_& module) {
  bind_trait(module);
  bind_adaptation(module);
  module.def("is_family", &is_family, "model"_a,
             "Whether a model is a family's, which adapt makes one arm's.");
  module.def(
      "model_of_followed_arm",
      [](const CompensationModel& model, const FloatArray& e) {
        return model_of_followed_arm(model, pressures_from(e, e.size(), "e"));
      },
      "model"_a, "e"_a,
      "The model of another arm of the family that `model` was made of: the one that a closed loop "
      "had when it certified a plan (Plan.arm_of_family, float32 (k,)). Raises InputError where "
      "the model is of no family, or e of another size.");
  module.def(
      "adapt",
      [](const ArmDescription& arm, CompensationModel family, const EpisodeList& episodes,
         bool train_weights, std::uint64_t seed, int jobs) {
        require_jobs(jobs);
        const std::vector<Episode> copies = episodes_from(episodes);
        AdaptationSettings settings;
        settings.weights = train_weights ? AdaptWeights::automatic : AdaptWeights::never;
        settings.seed = seed;
        settings.jobs = jobs;
        return interruptibly([&] { return adapt(arm, family, copies, settings); });
      },
      "arm"_a, "family"_a, "episodes"_a, "train_weights"_a = true, "seed"_a = 1, "jobs"_a = 0,
      "Makes a family's network that of the arm in these episodes, of which a minute is enough: an "
      "Adaptation, whose model plans like any other. train_weights: whether weights are trained "
      "too where the family does not contain the arm and that is better. jobs: threads, 0: one per "
      "core. Raises InputError where the model is of no family, or the episodes are another arm's "
      "or too short.");
  module.def(
      "hold_back_arms",
      [](const EpisodeList& episodes, const std::vector<int>& arms, double fraction,
         std::uint64_t seed) {
        std::vector<Episode> copies = episodes_from(episodes);
        const OthersMayRun others_may_run;
        return hold_back_arms(std::move(copies), arms, fraction, seed);
      },
      "episodes"_a, "arms"_a, "fraction"_a, "seed"_a,
      "TrainingData for a family: the episodes of about `fraction` of the arms are held back for "
      "validation, none of fewer than ten. arms: the arm of each episode, any numbers.");
}

}  // namespace limber::python
