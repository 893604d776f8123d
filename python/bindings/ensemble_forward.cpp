#include "limber/forward/ensemble_forward.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// What a rollout gives, in NumPy's order.
struct SpreadRollout {
  py::array_t<float> mean;
  py::array_t<float> standard_deviation;
};

SpreadRollout rollout(const EnsembleForward& ensemble, const FloatArray& pressures_kpa,
                      const FloatArray& first) {
  const ForwardModel& member = ensemble.member(0);
  const py::ssize_t frames = batch_size(pressures_kpa, "pressures_kpa");
  const Shape shape = {frames, member.point_count(), pose_size(member.dimension())};
  require_shape(pressures_kpa, {frames, member.channel_count()}, "pressures_kpa");
  require_shape(first, {shape[1], shape[2]}, "first");
  require_finite(pressures_kpa, "pressures_kpa");
  require_finite(first, "first");
  refuse_if(frames == 0, "pressures_kpa has no frames; expected at least one");
  EnsembleForward::Prediction prediction;
  {
    const OthersMayRun others_may_run;
    prediction = ensemble.rollout(batch_map(pressures_kpa), pressures_map(first));
  }
  // A frame of NumPy's is a column of limber's: the same numbers in the same order.
  const auto array = [&](const Eigen::MatrixXf& columns) {
    py::array_t<float> rows(shape);
    std::copy_n(columns.data(), columns.size(), rows.mutable_data());
    return rows;
  };
  return {array(prediction.mean), array(prediction.standard_deviation)};
}

}  // namespace

void bind_ensemble_forward(py::module_& module) {
  Record<SpreadRollout>(module, "SpreadRollout", "Mean and spread of an ensemble's rollouts.")
      .read_only("mean", &SpreadRollout::mean,
                 "Mean backbones, float32 (T, m, 3), in space (T, m, 7) with unit quaternions [m, "
                 "rad].")
      .read_only("standard_deviation", &SpreadRollout::standard_deviation,
                 "Of each of these numbers over the networks, float32 of the same shape; 0 of a "
                 "single network.")
      .done();
  py::class_<EnsembleForward>(module, "EnsembleForward",
                              "All networks of an ensemble, each rolled out by itself: their "
                              "spread says how certain they are. Constant: share it freely.")
      .def(py::init([](const ArmDescription& arm, CompensationModel model) {
             const OthersMayRun others_may_run;
             return EnsembleForward(arm, model);
           }),
           "arm"_a, "model"_a,
           "model: a CompensationModel of one or more networks. Raises InputError where it was "
           "trained for another arm.")
      .def_property_readonly("member_count", &EnsembleForward::member_count,
                             "Number of networks, 1 where it is no ensemble.")
      .def("rollout", &rollout, "pressures_kpa"_a, "first"_a,
           "Feeds every network's own output back: pressures float32 (T, n) [kPa] from backbone "
           "`first` (m, 3), in space (m, 7), give a SpreadRollout.")
      .def("__repr__", [](const EnsembleForward& ensemble) {
        return fmt::format("EnsembleForward(networks={})", ensemble.member_count());
      });
}

}  // namespace limber::python
