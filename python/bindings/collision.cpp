#include "limber/world/collision.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
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
           py::arg("arm"), py::arg("environment"), py::arg("margin_m") = 0.0,
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
          py::arg("backbone"), "Clearance of one backbone, float32 (m, 3), less the margin.")
      .def(
          "is_free",
          [](const CollisionChecker& checker, const FloatArray& backbone) {
            return checker.is_free(backbone_map(checked(checker, backbone, "backbone")));
          },
          py::arg("backbone"), "Whether nothing touches the arm: of one backbone, float32 (m, 3).")
      .def(
          "is_motion_free",
          [](const CollisionChecker& checker, const FloatArray& from, const FloatArray& to) {
            return checker.is_motion_free(backbone_map(checked(checker, from, "from_backbone")),
                                          backbone_map(checked(checker, to, "to_backbone")));
          },
          py::arg("from_backbone"), py::arg("to_backbone"),
          "Whether the arm stays free while every plate moves straight from one backbone, float32 "
          "(m, 3), to the other.")
      .def("__repr__", [](const CollisionChecker& checker) {
        return fmt::format("CollisionChecker(obstacles={}, gaps={})", checker.obstacle_count(),
                           checker.gap_count());
      });
}

}  // namespace limber::python
