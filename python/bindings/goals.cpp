#include <pybind11/stl.h>

#include "bindings.hpp"
#include "limber/world/pose_goal.hpp"
#include "record.hpp"

namespace limber::python {

void bind_goals(py::module_& module) {
  Record<Pose>(module, "Pose", "A pose in the arm's plane, frame B.")
      .field("x_m", &Pose::x_m, "Along the straight arm [m].")
      .field("y_m", &Pose::y_m, "To its left [m].")
      .field("theta_rad", &Pose::theta_rad, "Heading, counter-clockwise, unwrapped [rad].")
      .keywords()
      .done();
  Record<PoseGoal>(module, "PoseGoal",
                   "A region of end-effector poses in frame B; without theta_rad any heading does.")
      .field("x_m", &PoseGoal::x_m, "Centre [m].")
      .field("y_m", &PoseGoal::y_m, "Centre [m].")
      .field("theta_rad", &PoseGoal::theta_rad, "Heading [rad], or None.")
      .field("position_tolerance_m", &PoseGoal::position_tolerance_m, "Radius [m], > 0.")
      .field("orientation_tolerance_rad", &PoseGoal::orientation_tolerance_rad,
             "Of the heading [rad], > 0; unused without theta_rad.")
      .keywords()
      .done();
  Record<PoseError>(module, "PoseError", "How far a pose is from a goal's centre.")
      .field("position_m", &PoseError::position_m, "Distance [m].")
      .field("orientation_rad", &PoseError::orientation_rad,
             "In [0, pi]; 0 where the goal has no heading.")
      .keywords()
      .done();
  module.def("pose_error", &pose_error, py::arg("goal"), py::arg("pose"),
             "How far a pose is from the goal's centre.");
  module.def("is_within", &is_within, py::arg("goal"), py::arg("error"),
             "Whether both errors are within the goal's tolerances.");
}

}  // namespace limber::python
