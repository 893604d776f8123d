#include "limber/world/plan.hpp"

#include <algorithm>
#include <functional>

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "others_may_run.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// One row a frame of what `member` names, shape (T, n).
template <class Frames, class Member>
py::array_t<float> rows_of(const Frames& frames, const Member& member) {
  const auto count = static_cast<py::ssize_t>(frames.size());
  const py::ssize_t n = frames.empty() ? 0 : std::invoke(member, frames.front()).size();
  py::array_t<float> rows({count, n});
  float* to = rows.mutable_data();
  for (const auto& frame : frames) {
    to = std::copy_n(std::invoke(member, frame).data(), n, to);
  }
  return rows;
}

py::array_t<float> backbones_of(const Plan& plan) {
  const py::array_t<float> rows = rows_of(plan.frames, &PlanFrame::backbone);
  return rows.attr("reshape")(rows.shape(0), -1, kPoseSize);
}

void bind_certified_figures(py::module_& module) {
  Record<CertifiedFigures>(module, "CertifiedFigures", "What its certificate said of a plan.")
      .read_only("clearance_m", &CertifiedFigures::clearance_m,
                 "Smallest distance of the moving arm from an obstacle [m]; inf without obstacles.")
      .read_only("max_deviation_m", &CertifiedFigures::max_deviation_m,
                 "Largest distance of a plate between the certificate's simulation and the plan "
                 "[m].")
      .read_only("seal_is_intact", &CertifiedFigures::seal_is_intact,
                 "False where the plan's file was changed since it was certified.")
      .done();
}

void bind_plan_origin(py::class_<Plan>& binding) {
  binding
      .def_readwrite("model_hash", &Plan::model_hash,
                     "content_hash of the model's file; empty for the no-load model.")
      .def_property_readonly(
          "arm_of_family", [](const Plan& plan) { return vector_array(plan.arm_of_family); },
          "e of the arm that it was certified with, float32 (k,), where a closed loop has followed "
          "which arm of its family this is; else empty. See model_of_followed_arm.")
      .def_readonly("arm_hash", &Plan::arm_hash, "ArmDescription.hash() of the arm.")
      .def_readonly("valves_hash", &Plan::valves_hash,
                    "ValveParameters.hash() of the valves; empty: planned without valves.")
      .def_readonly("environment_hash", &Plan::environment_hash,
                    "environment_hash() of the environment.")
      .def_readonly("margin_m", &Plan::margin_m, "Clearance from obstacles that was asked for [m].")
      .def_readonly("tube", &Plan::tube, "PlanTube that it keeps free of obstacles, or None.")
      .def_readonly("frame_rate_hz", &Plan::frame_rate_hz, "Frames per second [Hz].")
      .def_readonly("hold_frame_count", &Plan::hold_frame_count,
                    "Number of last frames, which repeat the final set point.")
      .def_readonly("goal_orientation_rad", &Plan::goal_orientation_rad,
                    "Predicted difference of the tip's heading from the goal's after the hold "
                    "[rad]; 0 where the goal has none.")
      .def_readonly("program_version", &Plan::program_version, "Version of limber that made it.")
      .def_readonly("certified", &Plan::certified, "CertifiedFigures, or None: not certified.");
}

void bind_plan_motion(py::class_<Plan>& binding) {
  binding
      .def_property_readonly(
          "waypoints_kpa",
          [](const Plan& plan) { return rows_of(plan.waypoints_kpa, std::identity()); },
          "Set points that it goes straight between, the start first, float32 (w, n) "
          "[kPa]; a copy.")
      .def_property_readonly(
          "setpoint_kpa",
          [](const Plan& plan) { return rows_of(plan.frames, &PlanFrame::setpoint_kpa); },
          "Set points to command, float32 (T, n) [kPa], positive bends right; a copy.")
      .def_property_readonly(
          "pressure_kpa",
          [](const Plan& plan) { return rows_of(plan.frames, &PlanFrame::pressure_kpa); },
          "Pressures predicted from them, float32 (T, n) [kPa]; a copy.")
      .def_property_readonly(
          "backbone", &backbones_of,
          "Predicted shapes, float32 (T, m, 3): x_m, y_m, theta_rad of each plate; a copy.")
      .def(
          "_repr_svg_",
          [](const Plan& plan) -> std::optional<std::string> {
            std::string picture = motion_picture(plan);
            return picture.empty() ? std::nullopt : std::optional(std::move(picture));
          },
          py::call_guard<OthersMayRun>());
}

void bind_plan(py::module_& module) {
  py::class_<Plan> plan =
      Record<Plan>(module, "Plan",
                   "A motion in pressure space. Frame 0 is the start; the set points of frame k "
                   "are commanded at (k - 1) / frame_rate_hz. Its frames are executed as they "
                   "stand, never resampled.")
          .read_only("arm_name", &Plan::arm_name, "Name of the arm that it was made for.")
          .read_only("model", &Plan::model, "\"no_load\" or \"network\": what predicted it.")
          .read_only("environment_name", &Plan::environment_name,
                     "Name of the environment that it was made for.")
          .read_only("planner", &Plan::planner,
                     "Name of the planner that made it, as make_planner knows it.")
          .read_only("seed", &Plan::seed, "Seed of the search that made it.")
          .property("frame_count", &Plan::frame_count, "T: frames, start and hold included.")
          .property("duration_s", &Plan::duration_s, "Time of the last frame, hold included [s].")
          .read_only("cost_kpa", &Plan::cost_kpa, "Sum of |dp| over segments and frames [kPa].")
          .read_only("clearance_m", &Plan::clearance_m,
                     "Smallest predicted distance from an obstacle [m], of the tube where there is "
                     "one; inf without obstacles.")
          .read_only("goal_distance_m", &Plan::goal_distance_m,
                     "Predicted distance of the tip from the goal's centre after the hold [m].")
          .done();
  bind_plan_origin(plan);
  bind_plan_motion(plan);
}

}  // namespace

void bind_plans(py::module_& module) {
  bind_certified_figures(module);
  bind_plan(module);
  module.def("read_plan", &read_plan, "path"_a, py::call_guard<OthersMayRun>(),
             "Reads and checks a plan (JSON). Raises InputError naming file and field.");
  module.def("read_plan_unchecked", &read_plan_unchecked, "path"_a, py::call_guard<OthersMayRun>(),
             "Reads a plan (JSON) for `certify` to judge: only types and finite numbers are "
             "checked.");
  module.def("write_plan", &write_plan, "path"_a, "plan"_a, py::call_guard<OthersMayRun>(),
             "Writes a plan (JSON), atomically, every number exactly.");
  module.def("write_setpoints_csv", &write_setpoints_csv, "path"_a, "plan"_a,
             py::call_guard<OthersMayRun>(),
             "Set points for a valve controller as CSV, one row for each frame: time_s, "
             "setpoint_0_kpa, ..., pressure_0_kpa, ...");
  module.def("write_backbones_csv", &write_backbones_csv, "path"_a, "plan"_a,
             py::call_guard<OthersMayRun>(),
             "Predicted shapes as CSV, one row for each frame: time_s, x_0_m, y_0_m, "
             "theta_0_rad, ...");
  module.def("require_plan_of", &require_plan_of, "plan"_a, "arm"_a, "file"_a = "plan",
             "Raises InputError where the plan was made for another arm or breaks its "
             "limits. file: the plan's name in the message.");
}

}  // namespace limber::python
