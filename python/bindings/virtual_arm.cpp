#include "virtual_arm.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "others_may_run.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

using ArmUse = SharedVirtualArm::Use;

void bind_state(py::module_& module) {
  py::class_<ArmState>(module, "ArmState",
                       "What is known of the arm at one frame: pressures and shape.")
      .def(py::init([](double time_s, const FloatArray& pressure_kpa,
                       const std::optional<FloatArray>& backbone,
                       const std::optional<FloatArray>& setpoint_kpa,
                       std::optional<double> tracker_t) {
             ArmState state;
             require_number("time_s", time_s, -kMaxSeconds, kMaxSeconds);
             state.time_s = time_s;
             state.pressure_kpa = pressures_from(pressure_kpa, pressure_kpa.size(), "pressure_kpa");
             if (backbone && backbone->ndim() == 2 && backbone->shape(1) == kSpacePoseSize) {
               require_finite(*backbone, "backbone");
               state.space_backbone = space_backbone_map(*backbone);
             } else if (backbone) {
               state.backbone = backbone_from(*backbone, backbone->size() / kPoseSize, "backbone");
             }
             if (setpoint_kpa) {
               state.setpoint_kpa =
                   pressures_from(*setpoint_kpa, pressure_kpa.size(), "setpoint_kpa");
             }
             require_finite(tracker_t.value_or(0.0), "tracker_t");
             state.tracker_s = tracker_t;
             return state;
           }),
           "time_s"_a, "pressure_kpa"_a, "backbone"_a = py::none(), "setpoint_kpa"_a = py::none(),
           "tracker_t"_a = py::none(),
           "[s]; (n,) [kPa]; (m, 3), in space (m, 7), or None where nothing tracks it; (n,) [kPa], "
           "in force when this was measured, None: the one commanded last; [s] or None.")
      .def_readonly("time_s", &ArmState::time_s, "When it was measured [s].")
      .def_property_readonly(
          "pressure_kpa", [](const ArmState& state) { return vector_array(state.pressure_kpa); },
          "Measured pressures, float32 (n,) [kPa], positive bends right; a copy.")
      .def_property_readonly(
          "backbone",
          [](const ArmState& state) -> py::object {
            return state.backbone         ? py::object(backbone_array<float>(*state.backbone))
                   : state.space_backbone ? py::object(backbone_array<float>(*state.space_backbone))
                                          : py::none();
          },
          "Measured shape, float32 (m, 3): x_m, y_m, theta_rad of each plate; in space (m, 7): "
          "x_m, y_m, z_m, qx, qy, qz, qw; None where nothing tracked it.")
      .def_property_readonly(
          "setpoint_kpa",
          [](const ArmState& state) -> py::object {
            return state.setpoint_kpa ? py::object(vector_array(*state.setpoint_kpa)) : py::none();
          },
          "Set points in force when this was measured, float32 (n,) [kPa], where the arm says so; "
          "else None.")
      .def_readonly("tracker_t", &ArmState::tracker_s,
                    "When the shape was seen, on the tracker's own clock [s]; or None.")
      .def("__repr__", [](const ArmState& state) {
        return "ArmState(time_s=" + std::string(py::repr(py::float_(state.time_s))) +
               ", pressure_kpa=" +
               std::string(py::repr(vector_array(state.pressure_kpa).attr("tolist")())) + ")";
      });
}

std::string repr_of_arm(SharedVirtualArm& arm) {
  try {
    return fmt::format("VirtualArm(time_s={})",
                       std::string(py::repr(py::float_(ArmUse(arm)->state().time_s))));
  } catch (const InputError&) {  // a controller that a run asks may print it
    return "VirtualArm(moving)";
  }
}

void bind_virtual_arm_options(py::module_& module) {
  Record<VirtualArmOptions>(module, "VirtualArmOptions",
                            "Faults of a real laboratory, all off by default.")
      .field("noise_m", &VirtualArmOptions::noise_m,
             "Standard deviation of measured x, y and z [m], >= 0.")
      .field("noise_rad", &VirtualArmOptions::noise_rad,
             "Standard deviation of measured headings, in space about each axis [rad], >= 0.")
      .field("noise_kpa", &VirtualArmOptions::noise_kpa,
             "Standard deviation of measured pressures [kPa], >= 0.")
      .field("drop_rate", &VirtualArmOptions::drop_rate,
             "Share of frames without a backbone, 0 to 1.")
      .field("latency_s", &VirtualArmOptions::latency_s,
             "Everything measured was true this long ago [s], >= 0.")
      .field("seed", &VirtualArmOptions::seed, "Seed of noise and drops.")
      .field("stream", &VirtualArmOptions::stream,
             "Number of the episode or trial, for noise of its own.")
      .keywords()
      .done();
}

}  // namespace

void bind_virtual_arm(py::module_& module) {
  bind_state(module);
  bind_virtual_arm_options(module);
  py::class_<SharedVirtualArm>(module, "VirtualArm",
                               "A soft arm, simulated: on a table, or in space; an ArmDriver.")
      .def(py::init<const ArmDescription&, const VirtualArmOptions&>(), "arm"_a,
           "options"_a = VirtualArmOptions{}, py::call_guard<OthersMayRun>(),
           "At rest: straight, vented, at time 0. Raises InputError where an option is out "
           "of range.")
      .def(
          "state", [](SharedVirtualArm& arm) { return ArmUse(arm)->state(); },
          "The latest ArmState; before the first command, the arm at rest.")
      .def(
          "command",
          [](SharedVirtualArm& arm, const FloatArray& setpoint_kpa) {
            require_shape(setpoint_kpa, {setpoint_kpa.size()}, "setpoint_kpa");
            const Pressures setpoints = pressures_map(setpoint_kpa);
            const ArmUse use(arm);
            const OthersMayRun others_may_run;
            return ArmState(use->command(setpoints));
          },
          "setpoint_kpa"_a,
          "One frame at set points (n,) [kPa]; returns the ArmState after it. Raises "
          "InputError for a set point beyond the limits.")
      .def(
          "vent", [](SharedVirtualArm& arm) { ArmUse(arm)->vent(); },
          "Opens every vent valve: all set points are 0 until the next command.")
      .def(
          "settle",
          [](SharedVirtualArm& arm, const FloatArray& setpoint_kpa, double seconds) {
            require_shape(setpoint_kpa, {setpoint_kpa.size()}, "setpoint_kpa");
            require_number("seconds", seconds, 0.0, kMaxSeconds);
            const Pressures setpoints = pressures_map(setpoint_kpa);
            const ArmUse use(arm);
            return interruptibly([&] { return use->settle(setpoints, seconds); });
          },
          "setpoint_kpa"_a, "seconds"_a,
          "The same set points (n,) [kPa] for so long [s]; returns the ArmState after it. Ctrl-C "
          "raises KeyboardInterrupt.")
      .def(
          "true_backbone",
          [](SharedVirtualArm& arm) {
            return arm.dimension() == Dimension::space
                       ? backbone_array<double>(ArmUse(arm)->true_plates())
                       : backbone_array<double>(ArmUse(arm)->true_backbone());
          },
          "Shape now, float64 (m, 3), in space (m, 7), without noise, drops or latency.")
      .def(
          "true_pressure_kpa",
          [](SharedVirtualArm& arm) { return vector_array(ArmUse(arm)->true_pressure_kpa()); },
          "Pressures now, float64 (n,) [kPa], without noise or latency.")
      .def("__repr__", &repr_of_arm);
}

}  // namespace limber::python
