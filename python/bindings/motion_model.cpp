#include "limber/forward/motion_model.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/error.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/forward/recorded_region.hpp"
#include "limber/planning/problem_check.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void step(const MotionModel& model, const FloatArray& setpoint_kpa, MotionState& state) {
  thread_local MotionModel::Workspace scratch;
  require_shape(setpoint_kpa, {model.channel_count()}, "setpoint_kpa");
  require_finite(setpoint_kpa, "setpoint_kpa");
  refuse_if(state.valves.size() != model.valves().state_size() ||
                state.backbone.rows() != model.point_count() ||
                (model.has_network() && model.compensation().reads_velocity &&
                 state.before.rows() != model.point_count()),
            "state: of another arm or other valves; settled_state of this model makes one");
  model.step(pressures_map(setpoint_kpa), state, scratch);
}

void bind_tube(py::module_& module) {
  Record<PlanTube>(module, "PlanTube",
                   "How far the arm may be from where a plan predicts it, in a share of all runs; "
                   "`limber calibrate` measures it.")
      .read_only("level", &PlanTube::level, "Share of runs that stay in the tube, in (0, 1).")
      .read_only("plate_radius_m", &PlanTube::plate_radius_m,
                 "How far each plate may be from its prediction, m numbers, base first [m].")
      .read_only("end_radius_m", &PlanTube::end_radius_m,
                 "How far the tip may be after the hold [m], >= 0.")
      .read_only("end_heading_rad", &PlanTube::end_heading_rad,
                 "How far the tip's heading may be off after the hold [rad], >= 0.")
      .done()
      .def_property_readonly(
          "start_share", [](const PlanTube& tube) { return tube.growth.start_share; },
          "Share of its radius that a plate has where it starts, in (0, 1].")
      .def_property_readonly(
          "full_after_m", [](const PlanTube& tube) { return tube.growth.full_after_m; },
          "Distance from there at which it has all of it [m]; 0: everywhere.")
      .def_readonly("goal_inside", &PlanTube::goal_inside,
                    "Of a plan: whether its end lies so far inside the goal.");
}

void bind_error_room(py::module_& module) {
  Record<ErrorRoom>(module, "ErrorRoom", "What plans keep in hand for the model's error.")
      .read_only("margin_m", &ErrorRoom::margin_m,
                 "Clearance from obstacles [m], >= 0; of a tube its largest radius.")
      .property(
          "goal_margin", [](const ErrorRoom& room) { return fixed_copy(room.goal_margin); },
          "PoseError: how far inside the goal's tolerances plans end.")
      .read_only("tube", &ErrorRoom::tube, "PlanTube of a calibrated model, or None.")
      .read_only("margin_yields_to_start", &ErrorRoom::margin_yields_to_start,
                 "Whether an arm that starts nearer to an obstacle than margin_m keeps only the "
                 "clearance that it starts with, instead of having no plan. True unless margin_m "
                 "was given.")
      .read_only("note", &ErrorRoom::note,
                 "Why the amounts were not measured, and what to do about it; empty where they "
                 "were.")
      .done();
  module.def(
      "error_room",
      [](const ForwardModel& model, std::optional<double> margin_m,
         std::optional<double> goal_margin_m, std::optional<double> goal_margin_rad,
         std::optional<double> tube_level) {
        require_planar_model(model.dimension(), "limber.error_room");
        for (const auto& [name, asked] : {std::pair("margin_m", margin_m),
                                          {"goal_margin_m", goal_margin_m},
                                          {"goal_margin_rad", goal_margin_rad}}) {
          require_number(name, asked.value_or(0.0), 0.0, kMaxMarginM);
        }
        return error_room(model, {margin_m, goal_margin_m, goal_margin_rad, tube_level});
      },
      "model"_a, "margin_m"_a = py::none(), "goal_margin_m"_a = py::none(),
      "goal_margin_rad"_a = py::none(), "tube_level"_a = py::none(), py::call_guard<OthersMayRun>(),
      "The ErrorRoom that plans keep for a model's error: the tube that the model "
      "carries, else the error that it states (PredictionError). margin_m, "
      "goal_margin_m [m] and goal_margin_rad [rad], >= 0, are taken instead where "
      "they are given; tube_level chooses one of the model's tubes, such as 0.9. "
      "Raises InputError naming the levels there are. Without a network: 0, its error "
      "is larger than any room.");
}

void bind_motion_state(py::module_& module) {
  py::class_<MotionState>(module, "MotionState",
                          "Everything that decides an arm's future under set points.")
      .def_property_readonly(
          "pressure_kpa",
          [](const MotionState& state) { return vector_array(Pressures(state.pressure_kpa())); },
          "Pressures now, float32 (n,) [kPa]; a copy.")
      .def_property_readonly(
          "setpoint_kpa",
          [](const MotionState& state) { return vector_array(Pressures(state.setpoint_kpa())); },
          "The last set points, float32 (n,) [kPa]; a copy.")
      .def_property_readonly(
          "backbone",
          [](const MotionState& state) { return backbone_array<float>(state.backbone); },
          "Shape now, float32 (m, 3): x_m, y_m, theta_rad of each plate; a copy.")
      .def(
          "copy", [](const MotionState& state) { return state; },
          "Another MotionState that is equal and independent.")
      .def(
          "__eq__", [](const MotionState& a, const MotionState& b) { return a == b; },
          py::is_operator())
      .def("__repr__", [](const MotionState& state) {
        const Pose tip = tip_pose(state.backbone);
        return fmt::format("MotionState(tip=({:.4f} m, {:.4f} m, {:.3f} rad))", tip.x_m, tip.y_m,
                           tip.theta_rad);
      });
}

}  // namespace

void bind_motion_model(py::module_& module) {
  bind_motion_state(module);
  py::class_<MotionModel>(module, "MotionModel",
                          "Set points to backbones, frame by frame: valves, and behind them the "
                          "forward model. Constant: share it freely.")
      .def(py::init([](const ForwardModel& forward, const ValveModel* valves) {
             require_planar_model(forward.dimension(), "limber.MotionModel");
             return valves == nullptr ? MotionModel(forward) : MotionModel(forward, *valves);
           }),
           "forward"_a, "valves"_a = py::none(), py::keep_alive<1, 2>(),
           "forward: a ForwardModel; valves: a ValveModel, None: pressures are the set points.")
      .def_property_readonly("forward", &MotionModel::forward,
                             py::return_value_policy::reference_internal,
                             "The ForwardModel behind the valves.")
      .def_property_readonly("valves", &MotionModel::valves,
                             py::return_value_policy::reference_internal,
                             "The ValveModel, ideal where none was given.")
      .def_property_readonly("segment_count", &MotionModel::segment_count,
                             "n: segments of the arm.")
      .def_property_readonly("point_count", &MotionModel::point_count,
                             "m: plates of the arm, base included.")
      .def_property_readonly("has_network", &MotionModel::has_network,
                             "Whether the forward model has a network.")
      .def(
          "settled_state",
          [](const MotionModel& model, const FloatArray& kpa, const FloatArray& backbone) {
            return model.settled_state(pressures_from(kpa, model.channel_count(), "kpa"),
                                       backbone_from(backbone, model.point_count(), "backbone"));
          },
          "kpa"_a, "backbone"_a,
          "MotionState of an arm that has long stood at pressures (n,) [kPa] with backbone (m, 3).")
      .def("step", &step, "setpoint_kpa"_a, "state"_a,
           "One frame at set points float32 (n,) [kPa]: `state` becomes what follows it.")
      .def("__repr__", [](const MotionModel& model) {
        return fmt::format("MotionModel(network={}, valves={})",
                           model.has_network() ? model.compensation().shape() : "None",
                           model.valves().is_ideal() ? "ideal" : "identified");
      });
  py::class_<RecordedRegion>(module, "RecordedRegion",
                             "Judges whether motions stay within what the recordings held, for "
                             "PlanningProblem(stay_within=...).")
      .def(py::init([](const LearntRegion& learnt, double frame_rate_hz) {
             require_number("frame_rate_hz", frame_rate_hz, 1e-3, 1e6);
             return RecordedRegion(learnt, frame_rate_hz);
           }),
           "learnt"_a, "frame_rate_hz"_a, py::keep_alive<1, 2>(),
           "learnt: LearntRegion, a model's model.learnt; frame_rate_hz: the arm's [Hz], > 0.")
      .def("__repr__", [](const RecordedRegion& region) {
        return fmt::format("RecordedRegion(segments={}, points={})",
                           region.learnt().segment_count(), region.learnt().point_count());
      });
  bind_tube(module);
  bind_error_room(module);
}

}  // namespace limber::python
