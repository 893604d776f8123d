#include <pybind11/stl.h>

#include "bindings.hpp"
#include "limber/world/pose_goal.hpp"
#include "record.hpp"

namespace limber::python {

void bind_goals(py::module_& module) {
  Record<Pose>(module, "Pose",
               "A pose in the arm's plane, in frame B: the base is at the origin, x runs along "
               "the straight arm, y to its left.")
      .field("x_m", &Pose::x_m, "Along the straight arm, from the base [m].")
      .field("y_m", &Pose::y_m, "To the left of the straight arm [m].")
      .field("theta_rad", &Pose::theta_rad,
             "Heading [rad], counter-clockwise from x, unwrapped: it may exceed pi.")
      .keywords()
      .done();
  Record<PoseGoal>(module, "PoseGoal",
                   "A region of end-effector poses in frame B; without theta_rad any heading does.")
      .field("x_m", &PoseGoal::x_m,
             "Centre, along the straight arm [m]. It is beyond reach farther than the arm's "
             "length from the base.")
      .field("y_m", &PoseGoal::y_m, "Centre, to the left of the straight arm [m].")
      .field("theta_rad", &PoseGoal::theta_rad,
             "Heading [rad], counter-clockwise from x, modulo a full turn; None: any heading "
             "will do.")
      .field("position_tolerance_m", &PoseGoal::position_tolerance_m,
             "The tip is in the goal within this distance of its centre [m], > 0.")
      .field("orientation_tolerance_rad", &PoseGoal::orientation_tolerance_rad,
             "Largest difference of the heading [rad], > 0; unused without theta_rad.")
      .keywords()
      .fixed()
      .done();
  Record<PoseError>(module, "PoseError",
                    "How far a pose is from a goal's centre, or how far inside its tolerances.")
      .field("position_m", &PoseError::position_m, "Distance [m], >= 0.")
      .field("orientation_rad", &PoseError::orientation_rad,
             "Difference of the headings [rad], 0 to pi; 0 where the goal has no heading.")
      .keywords()
      .done();
  module.def("pose_error", &pose_error, py::arg("goal"), py::arg("pose"),
             "How far a Pose is from the centre of a PoseGoal: a PoseError.");
  module.def("is_within", &is_within, py::arg("goal"), py::arg("error"),
             "Whether both numbers of a PoseError are within the goal's tolerances.");
}

}  // namespace limber::python
