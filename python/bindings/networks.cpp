#include "limber/network/compensation_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_layer(py::module_& module) {
  py::class_<Layer>(module, "Layer",
                    "One layer, y = W x + b, with ReLU behind every layer but the last.")
      .def_property_readonly(
          "weight",
          [](const py::object& self) {
            const Eigen::MatrixXf& weight = self.cast<const Layer&>().weight;
            const auto item = static_cast<py::ssize_t>(sizeof(float));
            return read_only(py::array_t<float>({weight.rows(), weight.cols()},
                                                {item, item * weight.rows()}, weight.data(), self));
          },
          "W, float32 (outputs, inputs); a read-only view of limber's memory.")
      .def_property_readonly(
          "bias",
          [](const py::object& self) {
            const Eigen::VectorXf& bias = self.cast<const Layer&>().bias;
            return view_of(bias.data(), {bias.size()}, self);
          },
          "b, float32 (outputs,); a read-only view of limber's memory.")
      .def("__repr__", [](const Layer& layer) {
        return fmt::format("Layer({} -> {})", layer.weight.cols(), layer.weight.rows());
      });
}

/// One list of numbers, a view.
template <Eigen::VectorXf GapBounds::*kNumbers>
py::array_t<float> numbers_of(const py::object& self) {
  const Eigen::VectorXf& numbers = self.cast<const GapBounds&>().*kNumbers;
  return view_of(numbers.data(), {numbers.size()}, self);
}

void bind_gap_bounds(py::module_& module) {
  py::class_<GapBounds>(module, "GapBounds",
                        "What predictions keep the shape of every gap between two plates within: "
                        "float32 (m - 1,) each, base first; read-only views of limber's memory.")
      .def_property_readonly("min_length_m", &numbers_of<&GapBounds::min_length_m>,
                             "Shortest distance of the two plates, float32 (m - 1,) [m].")
      .def_property_readonly("max_length_m", &numbers_of<&GapBounds::max_length_m>,
                             "Longest distance of the two plates, float32 (m - 1,) [m].")
      .def_property_readonly(
          "min_turn_rad", &numbers_of<&GapBounds::min_turn_rad>,
          "Smallest turn from one plate to the next, signed, float32 (m - 1,) [rad].")
      .def_property_readonly(
          "max_turn_rad", &numbers_of<&GapBounds::max_turn_rad>,
          "Largest turn from one plate to the next, signed, float32 (m - 1,) [rad].")
      .def_property_readonly("max_bend_rad", &numbers_of<&GapBounds::max_bend_rad>,
                             "Largest bend from one plate to the next, in space, where a turn is a "
                             "twist; else float32 (0,) [rad].")
      .def("__repr__", [](const GapBounds& bounds) {
        return fmt::format(
            "GapBounds(gaps={}, length_m=({:.4f}, {:.4f}), turn_rad=({:.3f}, {:.3f}))",
            bounds.min_length_m.size(), bounds.min_length_m.minCoeff(),
            bounds.max_length_m.maxCoeff(), bounds.min_turn_rad.minCoeff(),
            bounds.max_turn_rad.maxCoeff());
      });
}

void bind_prediction_error(py::module_& module) {
  Record<PredictionError>(
      module, "PredictionError",
      "How far predictions were from the arm on motions that neither trained nor "
      "chose the model, open loop. Each number is one that 95 % of the runs do not exceed.")
      .read_only("runs", &PredictionError::runs, "Number of runs that it was measured over, >= 1.")
      .read_only("run_s", &PredictionError::run_s, "Mean length of a run [s].")
      .read_only("max_position_m", &PredictionError::max_position_m,
                 "Largest distance of any plate from its prediction in a run [m].")
      .read_only("off_path_m", &PredictionError::off_path_m,
                 "Largest distance of the arm from the predicted path in a run, early or late [m].")
      .read_only("end_position_m", &PredictionError::end_position_m,
                 "Distance of the tip from its prediction at a run's end [m].")
      .read_only(
          "end_orientation_rad", &PredictionError::end_orientation_rad,
          "Difference of the tip's heading at a run's end [rad]; None where rotations were not "
          "measured.")
      .done();
}

void bind_learnt_region(py::module_& module) {
  py::class_<LearntRegion>(
      module, "LearntRegion",
      "What the training recordings held: ranges of pressures [kPa], of their rates "
      "[kPa/s], and of shapes.")
      .def("__repr__", [](const LearntRegion& learnt) {
        const auto ranges = mapped<std::string>(learnt.low_kpa.size(), [&](Eigen::Index s) {
          return fmt::format("({:.1f}, {:.1f})", learnt.low_kpa[s], learnt.high_kpa[s]);
        });
        return fmt::format("LearntRegion(pressure_kpa=[{}], points={})", fmt::join(ranges, ", "),
                           learnt.point_count());
      });
}

/// What may be taken from the model is never seen through a reference into it.
template <class Value>
auto value_of(Value CompensationModel::*member) {
  return [member](const CompensationModel& model) -> Value { return model.*member; };
}

template <class Value>
auto assigning(Value CompensationModel::*member) {
  return [member](CompensationModel& model, const Value& value) { model.*member = value; };
}

void bind_network(py::module_& module) {
  py::class_<CompensationModel>(module, "CompensationModel",
                                "The network with everything needed to use it.")
      .def_property_readonly(
          "layers",
          [](const py::object& self) {
            py::list layers;
            for (const Layer& layer : self.cast<const CompensationModel&>().layers) {
              layers.append(py::cast(&layer, py::return_value_policy::reference_internal, self));
            }
            return layers;
          },
          "List of Layer of the leading network; no copies.")
      .def_property_readonly("member_count", &CompensationModel::member_count,
                             "Networks of the ensemble, 1 where it is none.")
      .def_property_readonly("shape", &CompensationModel::shape,
                             "Sizes of the layers, inputs first: \"102-100-100-100-48\".")
      .def_property_readonly(
          "dimension",
          [](const CompensationModel& model) { return position_size(model.dimension); },
          "2: of an arm in a plane, 3: in space.")
      .def_readonly("arm_name", &CompensationModel::arm_name,
                    "Name of the arm that it was trained for.")
      .def_readonly("arm_hash", &CompensationModel::arm_hash, "ArmDescription.hash() of that arm.")
      .def_readonly("preset", &CompensationModel::preset,
                    "Preset it was trained by: \"paper\" or \"best\".")
      .def_readonly("reads_velocity", &CompensationModel::reads_velocity,
                    "Whether it reads how the backbone changed in the frame before.")
      .def_readonly("past_commands", &CompensationModel::past_commands,
                    "How many frames ago the commands were that it reads beside the latest ones.")
      .def_readwrite("training", &CompensationModel::training,
                     "Record of the training, a dict of texts; assign a whole one.")
      .def_readonly("learnt_from_setpoints", &CompensationModel::learnt_from_setpoints,
                    "It knows the valves along with the arm, and none belong before it.")
      .def_property(
          "valves", [](const CompensationModel& model) { return fixed_copy(model.valves); },
          assigning(&CompensationModel::valves),
          "ValveParameters between set points and pressures of the recordings, or None. A copy, "
          "whose fields can't be set: assign a whole one.")
      .def_property_readonly("valve_findings", value_of(&CompensationModel::valve_findings),
                             "ValveFindings: how its valves were found, or why there are none.")
      .def_property_readonly("prediction_error", value_of(&CompensationModel::prediction_error),
                             "PredictionError on motions that it has not seen, as note_unseen "
                             "stores it; or None.")
      .def_property("learnt", value_of(&CompensationModel::learnt),
                    assigning(&CompensationModel::learnt),
                    "What the recordings held, or None: see learnt_region_of.")
      .def_property("bounds", value_of(&CompensationModel::bounds),
                    assigning(&CompensationModel::bounds),
                    "What predictions stay within, or None: see gap_bounds_of.")
      .def("set_valves", &CompensationModel::set_valves, "identified"_a,
           "Stores valves and how they were found. identified: IdentifiedValves, as "
           "identify_valves returns them.")
      .def("__repr__", [](const CompensationModel& model) {
        return fmt::format("CompensationModel(arm='{}', shape='{}', preset='{}', members={})",
                           model.arm_name, model.shape(), model.preset, model.member_count());
      });
}

}  // namespace

void bind_networks(py::module_& module) {
  bind_layer(module);
  bind_prediction_error(module);
  bind_gap_bounds(module);
  bind_learnt_region(module);
  bind_network(module);
  module.def("read_model", &read_model, "path"_a, py::call_guard<OthersMayRun>(),
             "Reads and checks a model (safetensors). Raises InputError naming file and key.");
  module.def(
      "write_model",
      [](const fs::path& path, CompensationModel model) {  // Python may change its own
        const OthersMayRun others_may_run;
        write_model(path, model);
      },
      "path"_a, "model"_a, "Writes a model (safetensors) that read_model reads, atomically.");
  module.def("require_model_of", &require_model_of, "model"_a, "arm"_a, "where"_a = "model",
             "Raises InputError unless the model was trained for the arm. where: the model's "
             "name in the message.");
}

}  // namespace limber::python
