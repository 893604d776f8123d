#include "limber/arm/no_load_model.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "others_may_run.hpp"
#include "planar.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// Shape (m, 3) of (n,), or (k, m, 3) of (k, n); in space 7 for 3.
py::array_t<float> backbone(const NoLoadModel& model, const FloatArray& pressures_kpa,
                            const py::object& out) {
  const py::ssize_t n = model.channel_count();
  const py::ssize_t m = model.point_count();
  const py::ssize_t size = pose_size(model.dimension());
  const bool batch = pressures_kpa.ndim() == 2;
  const py::ssize_t count = batch ? pressures_kpa.shape(0) : 1;
  require_shape(pressures_kpa, batch ? Shape{count, n} : Shape{n}, "pressures_kpa");
  py::array_t<float> result = result_array(out, batch ? Shape{count, m, size} : Shape{m, size});
  require_own_memory(result, pressures_kpa, "pressures_kpa", false);
  float* to = result.mutable_data();
  const float* from = pressures_kpa.data();
  std::optional<OthersMayRun> others_may_run;
  if (batch) {
    others_may_run.emplace();
  }
  require_finite(pressures_kpa, "pressures_kpa");
  for (py::ssize_t i = 0; i < count; ++i) {
    model.poses(Eigen::Map<const Eigen::VectorXf>(from + i * n, n),
                Eigen::Map<Eigen::VectorXf>(to + i * size * m, size * m));
  }
  return result;
}

void require_segment(const NoLoadModel& model, int segment, const char* method) {
  require_planar_model(model.dimension(), method);
  if (segment < 0 || segment >= model.segment_count()) {
    throw py::index_error(
        fmt::format("segment {}; expected 0 to {}", segment, model.segment_count() - 1));
  }
}

void bind_segment_shapes(py::module_& module) {
  Record<SegmentShape>(module, "SegmentShape", "Curvature and length of one segment.")
      .read_only("curvature_per_m", &SegmentShape::curvature_per_m,
                 "Curvature [1/m]; positive bends left, which a negative pressure does.")
      .read_only("length_m", &SegmentShape::length_m, "Length of its middle line when bent [m].")
      .done();
  Record<SegmentPressure>(module, "SegmentPressure", "A pressure that bends a segment as wanted.")
      .read_only("pressure_kpa", &SegmentPressure::pressure_kpa,
                 "Signed pressure within the segment's limits [kPa].")
      .read_only("reachable", &SegmentPressure::reachable,
                 "False where more than the limit would be needed; pressure_kpa is then at the "
                 "limit.")
      .done();
}

}  // namespace

void bind_no_load_model(py::module_& module) {
  bind_segment_shapes(module);
  py::class_<NoLoadModel>(module, "NoLoadModel",
                          "Shape of the unloaded, frictionless arm at given "
                          "pressures. Constant: any number of threads may share it.")
      .def(py::init<const ArmDescription&>(), "arm"_a, "The simple model of an arm.")
      .def_property_readonly("segment_count", &NoLoadModel::segment_count, "Segments of the arm.")
      .def_property_readonly("channel_count", &NoLoadModel::channel_count,
                             "n: pressures, one for each segment, in space for each chamber.")
      .def_property_readonly("point_count", &NoLoadModel::point_count,
                             "m: plates of the arm, base included.")
      .def("backbone", &backbone, "pressures_kpa"_a, "out"_a = py::none(),
           "Backbone at pressures [kPa]: float32 (n,) gives (m, 3), rows x_m, y_m, theta_rad from "
           "base to tip, in space (m, 7), rows x_m, y_m, z_m, qx, qy, qz, qw; (k, n) gives "
           "(k, m, 3) or (k, m, 7). Written to `out` where one is given.")
      .def(
          "segment_shape",
          [](const NoLoadModel& model, int segment, double pressure_kpa) {
            require_segment(model, segment, "NoLoadModel.segment_shape");
            require_finite(pressure_kpa, "pressure_kpa");
            return model.segment_shape(segment, pressure_kpa);
          },
          "segment"_a, "pressure_kpa"_a,
          "Curvature and length of one segment under a pressure: docs/model.md, (3) and "
          "(4). segment: 0 at the base; pressure_kpa: signed [kPa]. Raises IndexError for "
          "a segment that there is not.")
      .def(
          "pressure_for_curvature",
          [](const NoLoadModel& model, int segment, double curvature_per_m) {
            require_segment(model, segment, "NoLoadModel.pressure_for_curvature");
            require_finite(curvature_per_m, "curvature_per_m");
            return model.pressure_for_curvature(segment, curvature_per_m);
          },
          "segment"_a, "curvature_per_m"_a,
          "Pressure that bends a segment as wanted, the inverse of segment_shape: (11). "
          "curvature_per_m: positive bends left [1/m]. Beyond the limit: reachable is False.")
      .def(
          "curvature_limit_per_m",
          [](const NoLoadModel& model, int segment) {
            require_segment(model, segment, "NoLoadModel.curvature_limit_per_m");
            return model.curvature_limit_per_m(segment);
          },
          "segment"_a,
          "Largest curvature that the pressure limit of a segment allows, in magnitude [1/m].")
      .def("__repr__", [](const NoLoadModel& model) {
        return fmt::format("NoLoadModel(segments={}, points={})", model.segment_count(),
                           model.point_count());
      });
  module.def(
      "tip_pose",
      [](const DoubleArray& backbone) {
        require_shape(backbone, {std::max<py::ssize_t>(1, backbone.size() / kPoseSize), kPoseSize},
                      "backbone");
        const auto rows = backbone.unchecked<2>();
        const py::ssize_t last = backbone.shape(0) - 1;
        return Pose{rows(last, 0), rows(last, 1), rows(last, 2)};
      },
      "backbone"_a, "Pose of the end effector: the last row of a planar backbone (m, 3).");
}

}  // namespace limber::python
