#include "process_driver.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "others_may_run.hpp"

namespace limber::python {

namespace {

using DriverUse = SharedProcessDriver::Use;
using Path = fs::path;

constexpr std::string_view kExec = "exec:";

/// To a function in Python, or to standard error, which a notebook shows.
void tell(const py::object& on_message, const std::string& message) noexcept {
  const py::gil_scoped_acquire python;
  try {
    if (on_message.is_none()) {
      py::print(message, "file"_a = py::module_::import("sys").attr("stderr"));
    } else {
      on_message(message);
    }
  } catch (py::error_already_set& error) {
    error.discard_as_unraisable("limber.ProcessDriver");
  } catch (const std::exception&) {  // a message is not worth more: the arm is vented all the same
  }
}

std::unique_ptr<SharedProcessDriver> start(const ArmDescription& arm, const std::string& command,
                                           const std::optional<Path>& arm_file, double limit_scale,
                                           bool check_rate, const std::optional<Path>& log,
                                           const py::object& on_message, bool simulated,
                                           const std::optional<Path>& calibration) {
  require_planar(arm, "limber.ProcessDriver");
  refuse_if(!command.starts_with(kExec) || command.size() == kExec.size(),
            "driver '{}': expected exec:COMMAND, as in \"exec:python3 my_driver.py\"", command);
  refuse_if(!(limit_scale > 0.0 && limit_scale <= 1.0),
            "limit_scale = {}: expected a number over 0, at most 1", limit_scale);
  ProcessDriverSettings settings;
  settings.command = command.substr(kExec.size());
  settings.limit_scale = limit_scale;
  settings.check_rate = check_rate;
  settings.simulated = simulated;
  settings.install_signals = false;  // Python has its own
  if (arm_file) {
    settings.safety = load_safety(*arm_file);
  }
  if (calibration) {
    settings.calibration = read_wire_calibration(*calibration);
    require_calibration_of(*settings.calibration, arm, calibration->string());
  }
  settings.log = log.value_or(Path());
  settings.say = [listener = shared(on_message)](const std::string& message) {
    tell(*listener, message);
  };
  const OthersMayRun others_may_run;
  return std::make_unique<SharedProcessDriver>(arm, settings);
}

ArmState command(SharedProcessDriver& shared, const FloatArray& setpoint_kpa) {
  require_shape(setpoint_kpa, {setpoint_kpa.size()}, "setpoint_kpa");
  require_finite(setpoint_kpa, "setpoint_kpa");
  const DriverUse driver(shared);
  const OthersMayRun others_may_run;
  return driver->command(pressures_map(setpoint_kpa));
}

std::string repr_of(SharedProcessDriver& shared) {
  if (!shared.is_open()) {
    return "ProcessDriver(closed)";
  }
  try {
    const DriverUse driver(shared);
    return fmt::format("ProcessDriver(driver='{}', device='{}', is_real_time={})",
                       driver->hello().driver, driver->hello().device,
                       driver->is_real_time() ? "True" : "False");
  } catch (const InputError&) {  // a controller that a run asks may print it
    return "ProcessDriver(moving)";
  }
}

}  // namespace

SharedProcessDriver::SharedProcessDriver(const ArmDescription& arm,
                                         const ProcessDriverSettings& settings)
    : driver_(std::make_unique<ProcessDriver>(arm, settings)) {}

SharedProcessDriver::~SharedProcessDriver() {
  close();
}

void SharedProcessDriver::close() {
  if (driver_) {
    const OthersMayRun others_may_run;
    driver_.reset();
  }
}

SharedProcessDriver::Use::Use(SharedProcessDriver& shared) : shared_(shared) {
  refuse_if(shared.busy_.exchange(true), "this driver moves the arm already; one thread at a time");
  if (!shared.is_open()) {
    shared.busy_.store(false);
    throw InputError("this driver was closed; start another one");
  }
}

void require_within(const Plan& plan, const ProcessDriver& driver) {
  if (const auto found = first_beyond(plan, driver.limits_kpa())) {
    throw InputError(fmt::format(
        "plan: {}: set point of {} is {:.1f} kPa; the driver allows {} kPa. Nothing was "
        "moved; plan again with PlanningProblem(..., limits_kpa=driver.limits_kpa)",
        frame_name(found->frame), segment_name(found->segment), found->value,
        to_string(found->limits)));
  }
}

void require_reach(const ArmDescription& arm, double limit_scale, const ProcessDriver& driver) {
  if (const auto found = first_short_reach(arm, limit_scale, driver.limits_kpa())) {
    throw InputError(
        advice(*found, arm, driver.limits_kpa(), "ScheduleSettings(limit_scale={:g})"));
  }
}

void bind_process_driver(py::module_& module) {
  py::class_<SharedProcessDriver>(
      module, "ProcessDriver",
      "An arm behind a program of your own (docs/driver.md; limber.driver.serve makes one of "
      "Python), in a process that closes the valves whatever becomes of this one. One thread at a "
      "time; `with` closes it.")
      .def(py::init(&start), "arm"_a, "command"_a, "arm_file"_a = py::none(), "limit_scale"_a = 1.0,
           "check_rate"_a = true, "log"_a = py::none(), "on_message"_a = py::none(),
           "simulated"_a = false, "calibration"_a = py::none(),
           "Starts \"exec:COMMAND\" without a shell, and vents. arm_file: its mapping `safety` "
           "counts; limit_scale: limits in force are so many times the arm's; check_rate: False "
           "where motions jump and the valves ramp by themselves; log: file of what both sides "
           "said; on_message(text): told what came of each vent, else standard error is; "
           "simulated: True where the driver may be a simulation, asked as fast as it answers; "
           "calibration: file of `limber driver calibrate`.")
      .def(
          "state", [](SharedProcessDriver& shared) { return DriverUse(shared)->state(); },
          "The latest ArmState, as the driver measured it.")
      .def("command", &command, "setpoint_kpa"_a,
           "One frame at set points (n,) [kPa]; returns the ArmState after it. Who "
           "commands by hand vents by hand. Raises SystemFault where the driver fails, and for "
           "a set point beyond the limits, which is not sent: the driver can then only vent.")
      .def(
          "vent",
          [](SharedProcessDriver& shared) {
            const DriverUse driver(shared);
            const OthersMayRun others_may_run;
            driver->vent();
          },
          "Opens every vent valve, and watches the pressures come down, 5 s at most.")
      .def(
          "look",
          [](SharedProcessDriver& shared) -> ArmState {
            const DriverUse driver(shared);
            const OthersMayRun others_may_run;
            return driver->look();
          },
          "A fresh ArmState of the arm while it is vented.")
      .def(
          "close",
          [](SharedProcessDriver& shared) {
            if (shared.is_open()) {
              const DriverUse driver(shared);
              shared.close();
            }
          },
          "Vents and ends the process; so does the end of this object.")
      .def("__enter__", [](const py::object& self) { return self; })
      .def("__exit__", [](const py::object& self, const py::args&) { self.attr("close")(); })
      .def_property_readonly(
          "limits_kpa",
          [](SharedProcessDriver& shared) { return limits_array(DriverUse(shared)->limits_kpa()); },
          "In force, lower and upper, float32 (n, 2) [kPa].")
      .def_property_readonly(
          "is_real_time",
          [](SharedProcessDriver& shared) { return DriverUse(shared)->is_real_time(); },
          "Whether a frame takes its time: then a set point is due in each.")
      .def_property_readonly(
          "vent_confirmed",
          [](SharedProcessDriver& shared) { return DriverUse(shared)->last_vent().confirmed; },
          "Whether every measured pressure came down at the last vent.")
      .def("__repr__", &repr_of);
}

}  // namespace limber::python
