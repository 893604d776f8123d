#include "limber/world/environment.hpp"

#include <type_traits>
#include <variant>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/yaml_reader.hpp"
#include "others_may_run.hpp"
#include "pictures.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

void bind_obstacles(py::module_& module) {
  Record<Circle>(module, "Circle", "A round obstacle, solid; in frame B.")
      .field("x_m", &Circle::x_m, "Centre, along the straight arm [m].")
      .field("y_m", &Circle::y_m, "Centre, to the left of the straight arm [m].")
      .field("radius_m", &Circle::radius_m, "Radius [m], > 0.")
      .keywords()
      .fixed()
      .done();
  Record<Rectangle>(module, "Rectangle", "A rectangular obstacle at any angle, solid; in frame B.")
      .field("x_m", &Rectangle::x_m, "Centre, along the straight arm [m].")
      .field("y_m", &Rectangle::y_m, "Centre, to the left of the straight arm [m].")
      .field("width_m", &Rectangle::width_m,
             "Size along its own x, which angle_rad turns [m], > 0.")
      .field("height_m", &Rectangle::height_m,
             "Size along its own y, which angle_rad turns [m], > 0.")
      .field("angle_rad", &Rectangle::angle_rad, "Turned counter-clockwise about its centre [rad].")
      .keywords()
      .fixed()
      .done();
  py::class_<Polygon>(module, "Polygon", "A simple polygon, convex or not; the inside is solid.")
      .def(py::init([](const DoubleArray& points_m) {
             require_shape(points_m, {points_m.size() / 2, 2}, "points_m");
             require_finite(points_m, "points_m");
             Polygon polygon;
             const auto rows = points_m.unchecked<2>();
             for (py::ssize_t i = 0; i < points_m.shape(0); ++i) {
               polygon.points_m.emplace_back(rows(i, 0), rows(i, 1));
             }
             return polygon;
           }),
           "points_m"_a, "Corners x_m, y_m in order, (k, 2) [m], 3 to 1000 of them.")
      .def_property_readonly(
          "points_m",
          [](const Polygon& polygon) {
            py::array_t<double> points({polygon.points_m.size(), std::size_t{2}});
            for (std::size_t i = 0; i < polygon.points_m.size(); ++i) {
              points.mutable_at(i, 0) = polygon.points_m[i].x();
              points.mutable_at(i, 1) = polygon.points_m[i].y();
            }
            return points;
          },
          "Corners x_m, y_m in order, float64 (k, 2) [m]; a copy.")
      .def("__repr__", [](const Polygon& polygon) {
        return fmt::format("Polygon({} corners)", polygon.points_m.size());
      });
}

void bind_start(py::module_& module) {
  py::class_<ArmStart>(module, "ArmStart", "State of the arm that a motion starts from.")
      .def(py::init([](const FloatArray& pressures_kpa, const FloatArray& backbone) {
             return ArmStart{pressures_from(pressures_kpa, pressures_kpa.size(), "pressures_kpa"),
                             backbone_from(backbone, backbone.size() / kPoseSize, "backbone")};
           }),
           "pressures_kpa"_a, "backbone"_a,
           "pressures_kpa: (n,) [kPa], signed; backbone: (m, 3), rows x_m, y_m, theta_rad "
           "in frame B, plate 0 at the base.")
      .def_property_readonly(
          "pressures_kpa", [](const ArmStart& start) { return vector_array(start.pressures_kpa); },
          "Pressures that the arm starts with, float32 (n,) [kPa], signed; a copy.")
      .def_property_readonly(
          "backbone", [](const ArmStart& start) { return backbone_array<float>(start.backbone); },
          "Shape that the arm starts with, float32 (m, 3): x_m, y_m, theta_rad of each "
          "plate; a copy.")
      .def("__repr__", [](const ArmStart& start) {
        return fmt::format("ArmStart(segments={}, points={})", start.pressures_kpa.size(),
                           start.backbone.rows());
      });
}

/// Checked as a file is: written as YAML, and read back.
Environment make_environment(const std::string& name, std::vector<Obstacle> obstacles,
                             const PoseGoal& goal, std::optional<ArmStart> start) {
  const Environment environment{name, std::move(obstacles), std::move(start), goal};
  return read_environment(YamlReader::from_text(environment_to_yaml(environment), "Environment"));
}

SeenAs<std::vector<Obstacle>> fixed_obstacles(const Environment& environment) {
  py::list obstacles;
  for (const Obstacle& obstacle : environment.obstacles) {
    obstacles.append(std::visit(
        [](const auto& one) -> py::object {
          using T = std::decay_t<decltype(one)>;
          if constexpr (std::is_same_v<T, Polygon>) {
            return py::cast(one);  // has no fields to set
          } else {
            return fixed_copy(one);
          }
        },
        obstacle));
  }
  return obstacles;
}

}  // namespace

void bind_environments(py::module_& module) {
  bind_obstacles(module);
  bind_start(module);
  py::class_<Environment>(module, "Environment",
                          "What a plan is made for: obstacles, start and goal, in frame B. Plans "
                          "borrow it, so it does not change.")
      .def(py::init(&make_environment), "name"_a, "obstacles"_a, "goal"_a, "start"_a = py::none(),
           py::call_guard<OthersMayRun>(),
           "Checked as a file is: raises InputError naming the field. obstacles: a list of "
           "Circle, Rectangle and Polygon, which messages and results count from 0; goal: "
           "a PoseGoal; start: an ArmStart, None: straight and without pressure.")
      .def_readonly("name", &Environment::name, "Its name, as its file has it.")
      .def_property_readonly("obstacles", &fixed_obstacles,
                             "List of Circle, Rectangle and Polygon, obstacle 0 first; copies, "
                             "whose fields can't be set.")
      .def_property_readonly(
          "goal", [](const Environment& e) { return fixed_copy(e.goal); },
          "Where the tip shall end, a PoseGoal; a copy, whose fields can't be set.")
      .def_readonly("start", &Environment::start,
                    "ArmStart, or None: at rest, straight and without pressure.")
      .def("_repr_svg_", &obstacles_picture, py::call_guard<OthersMayRun>())
      .def("__repr__", [](const Environment& environment) {
        return fmt::format("Environment(name='{}', obstacles={}, goal=({}, {}))", environment.name,
                           environment.obstacles.size(), environment.goal.x_m,
                           environment.goal.y_m);
      });
  module.def(
      "load_environment",
      [](const fs::path& path, const ArmDescription* arm) {
        if (arm != nullptr) {
          require_planar(*arm, "limber.load_environment");
        }
        return arm == nullptr ? load_environment(path) : load_environment(path, *arm);
      },
      "path"_a, "arm"_a = py::none(), py::call_guard<OthersMayRun>(),
      "Reads and checks an environment file (YAML); with an arm, also that its start "
      "fits. Raises InputError naming file, line and field. Whether the goal is "
      "within reach is judged when planning.");
  module.def("environment_to_yaml", &environment_to_yaml, "environment"_a,
             py::call_guard<OthersMayRun>(),
             "The environment as the text of a file that load_environment reads.");
  module.def(
      "write_environment",
      [](const fs::path& path, const Environment& environment) {
        write_file_atomically(path, environment_to_yaml(environment));
      },
      "path"_a, "environment"_a, py::call_guard<OthersMayRun>(),
      "Writes an environment file (YAML) that load_environment reads, atomically.");
  module.def("environment_hash", &environment_hash, "environment"_a, py::call_guard<OthersMayRun>(),
             "Hash of everything that planning depends on, a text; the name is no part of it.");
  module.def(
      "start_state",
      [](const Environment& environment, const ArmDescription& arm) {
        require_planar(arm, "limber.start_state");
        return start_state(environment, arm);
      },
      "environment"_a, "arm"_a, py::call_guard<OthersMayRun>(),
      "Where the arm starts, an ArmStart: as the environment has it, or at rest.");
}

}  // namespace limber::python
