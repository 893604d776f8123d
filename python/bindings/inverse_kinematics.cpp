#include "limber/world/inverse_kinematics.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/pose_goal.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

FloatArray checked(const CollisionChecker& checker, const FloatArray& backbone, const char* name) {
  require_shape(backbone, {checker.gap_count() + 1, kPoseSize}, name);
  require_finite(backbone, name);
  return backbone;
}

}  // namespace

void bind_collision(py::module_& module) {
  Record<Clearance>(module, "Clearance", "Smallest distance between the arm and an obstacle.")
      .read_only("value_m", &Clearance::value_m,
                 "Distance [m]; negative: how deep the arm is in it; inf: no obstacles.")
      .read_only("gap", &Clearance::gap,
                 "Where on the arm: between plates gap and gap + 1; -1: nowhere.")
      .read_only("obstacle", &Clearance::obstacle, "Index in the environment's list; -1: none.")
      .done();
  py::class_<CollisionChecker>(module, "CollisionChecker",
                               "Collision of a thick backbone with obstacles. Constant: share it.")
      .def(py::init([](const ArmDescription& arm, const Environment& environment, double margin_m) {
             require_planar(arm, "limber.CollisionChecker");
             return CollisionChecker(arm, environment.obstacles, margin_m);
           }),
           "arm"_a, "environment"_a, "margin_m"_a = 0.0,
           "margin_m: added to the arm's radius everywhere [m], >= 0.")
      .def_property_readonly("obstacle_count", &CollisionChecker::obstacle_count,
                             "Number of obstacles.")
      .def_property_readonly("gap_count", &CollisionChecker::gap_count,
                             "Spaces between plates, m - 1.")
      .def(
          "clearance",
          [](const CollisionChecker& checker, const FloatArray& backbone) {
            return checker.clearance(backbone_map(checked(checker, backbone, "backbone")));
          },
          "backbone"_a, "Clearance of one backbone, float32 (m, 3), less the margin.")
      .def(
          "is_free",
          [](const CollisionChecker& checker, const FloatArray& backbone) {
            return checker.is_free(backbone_map(checked(checker, backbone, "backbone")));
          },
          "backbone"_a, "Whether nothing touches the arm: of one backbone, float32 (m, 3).")
      .def(
          "is_motion_free",
          [](const CollisionChecker& checker, const FloatArray& from, const FloatArray& to) {
            return checker.is_motion_free(backbone_map(checked(checker, from, "from_backbone")),
                                          backbone_map(checked(checker, to, "to_backbone")));
          },
          "from_backbone"_a, "to_backbone"_a,
          "Whether the arm stays free while every plate moves straight from one backbone, float32 "
          "(m, 3), to the other.")
      .def("__repr__", [](const CollisionChecker& checker) {
        return fmt::format("CollisionChecker(obstacles={}, gaps={})", checker.obstacle_count(),
                           checker.gap_count());
      });
}

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
      .fixed()
      .done();
  module.def("pose_error", &pose_error, "goal"_a, "pose"_a,
             "How far a Pose is from the centre of a PoseGoal: a PoseError.");
  module.def("is_within", &is_within, "goal"_a, "error"_a,
             "Whether both numbers of a PoseError are within the goal's tolerances.");
}

void bind_inverse_kinematics(py::module_& module) {
  using Settings = InverseKinematicsSettings;
  using Result = InverseKinematicsResult;
  Record<Settings>(module, "InverseKinematicsSettings", "How long solutions are looked for.")
      .field("starts", &Settings::starts, "Random configurations to start from, 1 to 10000.")
      .field("max_solutions", &Settings::max_solutions,
             "The search stops at so many solutions, >= 1.")
      .field("iterations", &Settings::iterations,
             "Largest number of Newton steps from each start, 1 to 1000.")
      .field("convergence_m", &Settings::convergence_m,
             "A start is done when the tip is this near to the goal [m], > 0.")
      .field("distinct_pressure", &Settings::distinct_pressure,
             "Solutions differ by more than this share of some segment's largest command, >= 0.")
      .keywords()
      .done();
  Record<Result>(module, "InverseKinematicsResult",
                 "What was found; that there is no solution is no error, and raises nothing.")
      .property(
          "pressures_kpa",
          [](const Result& result) {
            const auto k = static_cast<py::ssize_t>(result.pressures_kpa.size());
            const py::ssize_t n = result.best_pressures_kpa.size();
            py::array_t<double> rows({k, n});
            for (py::ssize_t i = 0; i < k; ++i) {
              Eigen::Map<Eigen::VectorXd>(rows.mutable_data() + i * n, n) = result.pressures_kpa[i];
            }
            return rows;
          },
          "Solutions, float64 (k, n) [kPa], in the order found.")
      .property(
          "best_pressures_kpa",
          [](const Result& result) { return vector_array(result.best_pressures_kpa); },
          "The nearest configuration of all starts, float64 (n,) [kPa].")
      .property(
          "best_error", [](const Result& result) { return fixed_copy(result.best_error); },
          "PoseError of best_pressures_kpa: how far they miss the goal's centre.")
      .read_only("starts_used", &Result::starts_used, "Number of starts that were tried.")
      .read_only("reason", &Result::reason, "Why there is no solution; empty where there is one.")
      .property("reachable", &Result::reachable, "Whether there is at least one solution.")
      .done();
  module.def(
      "solve_inverse_kinematics",
      [](const NoLoadModel& model, const PoseGoal& goal, const Settings& settings,
         RandomStream& random) {
        require_planar_model(model.dimension(), "limber.solve_inverse_kinematics");
        constexpr int kStartsAtOnce = 256;  // some 30 ms; signals wait no longer
        Settings answering = settings;
        answering.give_up = [starts = 0]() mutable {
          if (++starts % kStartsAtOnce == 0) {
            answer_signals();
          }
          return false;
        };
        return solve_inverse_kinematics(model, goal, answering, random);
      },
      "model"_a, "goal"_a, "settings"_a, "random"_a, py::call_guard<OthersMayRun>(),
      "Pressures whose no-load tip is at the goal: Newton-Raphson from random starts. "
      "model: a NoLoadModel; goal: a PoseGoal; random: a RandomStream. Not complete: "
      "if none is found, there may still be one. Raises InputError where the goal or "
      "a setting is out of range.");
}

}  // namespace limber::python
