#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "caller_thread.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/driver/driver_run.hpp"
#include "limber/report/execution_report.hpp"
#include "limber/run/controller.hpp"
#include "limber/run/executor.hpp"
#include "others_may_run.hpp"
#include "process_driver.hpp"
#include "python_driver.hpp"
#include "record.hpp"
#include "virtual_arm.hpp"

namespace limber::python {

namespace {

constexpr const char* kParts = "_parts";  // arm, environment and plan of a result

/// limber's own closed loop, and what it is for.
struct ClosedLoopOf {
  std::unique_ptr<Controller> controller;
  std::string arm;
  std::string environment;
  std::string arm_hash;
  std::string environment_hash;
};

void require_loop_of(const ClosedLoopOf& loop, const ArmDescription& arm,
                     const Environment& environment) {
  const auto require = [](const char* what, const std::string& of, const std::string& of_hash,
                          const std::string& name, const std::string& hash) {
    refuse_if(of_hash != hash,
              "controller: a ClosedLoop for {} '{}' (hash {}); the run's is '{}' (hash {})", what,
              of, of_hash, name, hash);
  };
  require("arm", loop.arm, loop.arm_hash, arm.name, arm.hash());
  require("environment", loop.environment, loop.environment_hash, environment.name,
          environment_hash(environment));
}

ExecutionResult run_with(const ArmDescription& arm, const Environment& environment,
                         const Plan& plan, const py::object& driver, const ExecutionSettings& asked,
                         const py::object& controller) {
  ExecutionSettings settings = asked;
  CallerThread caller;
  settings.should_stop = [&] { return caller.should_stop(); };
  std::optional<PythonController> own;
  if (py::isinstance<ClosedLoopOf>(controller)) {
    const auto& loop = controller.cast<const ClosedLoopOf&>();
    require_loop_of(loop, arm, environment);
    settings.controller = loop.controller.get();
  } else if (!controller.is_none()) {
    settings.controller = &own.emplace(controller, arm.channel_count(), caller);
  }
  const auto run_on = [&](auto& one) {
    return caller.run([&] { return execute(arm, environment, plan, one, settings); });
  };
  if (py::isinstance<SharedVirtualArm>(driver)) {
    const SharedVirtualArm::Use use(driver.cast<SharedVirtualArm&>());
    return run_on(*use);
  }
  if (py::isinstance<SharedProcessDriver>(driver)) {
    const SharedProcessDriver::Use use(driver.cast<SharedProcessDriver&>());
    require_within(plan, *use);
    if (!settings.max_start_error_m) {
      settings.max_start_error_m = allowed_start_error_m(plan);
    }
    return caller.run([&] {
      use->look();  // since its last vent it may have been planned for a minute
      return execute(arm, environment, plan, *use, settings);
    });
  }
  PythonDriver python_driver(driver, caller);
  return run_on(python_driver);
}

/// With what its picture needs: the very objects that the caller handed over.
SeenAs<ExecutionResult> execute_with(const ArmDescription& arm, const Environment& environment,
                                     const Plan& plan, const py::object& driver,
                                     const ExecutionSettings& settings,
                                     const py::object& controller) {
  require_planar(arm, "limber.execute");
  py::object result = py::cast(run_with(arm, environment, plan, driver, settings, controller));
  result.attr(kParts) = py::make_tuple(py::cast(&arm), py::cast(&environment), py::cast(&plan));
  return result;
}

std::optional<std::string> picture_of(const py::object& self) {
  if (!py::hasattr(self, kParts)) {
    return std::nullopt;
  }
  const auto parts = self.attr(kParts).cast<py::tuple>();
  const auto& arm = parts[0].cast<const ArmDescription&>();
  const auto& environment = parts[1].cast<const Environment&>();
  const auto& plan = parts[2].cast<const Plan&>();
  const auto& result = self.cast<const ExecutionResult&>();
  const OthersMayRun others_may_run;
  return execution_picture(arm, environment, plan, result);
}

void bind_execution_findings(py::module_& module) {
  Choice<ExecutionStatus>(module, "ExecutionStatus", "How an execution ended.")
      .value("done", ExecutionStatus::done, "every frame was commanded, and the hold after them")
      .value("fault", ExecutionStatus::fault, "the arm failed, ExecutionResult.message")
      .value("stopped", ExecutionStatus::stopped, "stopped on request, ExecutionResult.message");
  Record<ExecutionSettings>(module, "ExecutionSettings", "How a plan is executed.")
      .field("hold_s", &ExecutionSettings::hold_s,
             "How long the last set point is held, the plan's own hold counted [s], >= 0; "
             "then the goal is judged.")
      .field("max_start_error_m", &ExecutionSettings::max_start_error_m,
             "How far a plate may be from the plan's start, as measured [m]; None: of a "
             "ProcessDriver the plan's margin, at least 1 cm, else anywhere.")
      .keywords()
      .done();
  Record<ExecutedError>(module, "ExecutedError", "Distance between predicted and executed tip.")
      .read_only("mean_m", &ExecutedError::mean_m, "Mean distance over the plan's frames [m].")
      .read_only("before_hold_m", &ExecutedError::before_hold_m,
                 "Mean distance before the plan's hold, while it moves [m].")
      .read_only("max_m", &ExecutedError::max_m, "Largest distance [m].")
      .read_only("final_m", &ExecutedError::final_m, "Distance at the plan's last frame [m].")
      .done();
  Record<PressureLoss>(module, "PressureLoss", "A segment that loses pressure: a leak, or a valve.")
      .read_only("segment", &PressureLoss::segment, "Its number, from 0.")
      .read_only("share", &PressureLoss::share,
                 "Of the pressure that its valves would make of the set points, missing.")
      .read_only("noticed_s", &PressureLoss::noticed_s, "Since the run began [s].")
      .done();
  Record<Contact>(module, "Contact", "The arm near or in an obstacle at one moment.")
      .read_only("time_s", &Contact::time_s, "Since the run began [s].")
      .read_only("clearance", &Contact::clearance,
                 "Clearance: how near, where on the arm, and to which obstacle.")
      .done();
}

void bind_controllers(py::module_& module) {
  Record<ArmNow>(module, "ArmEstimate", "What is known about an arm at one moment of a run.")
      .read_only("frames", &ArmNow::frames, "Set points sent since the start.")
      .read_only("lag_frames", &ArmNow::lag_frames,
                 "Frames by which what is measured is behind what was sent.")
      .read_only("frames_unseen", &ArmNow::frames_unseen, "Frames since the arm was tracked last.")
      .done()
      .def_property_readonly(
          "setpoint_kpa", [](const ArmNow& now) { return vector_array(now.setpoint_kpa); },
          "Set points of the last frame, float32 (n,) [kPa].")
      .def_readonly("measured", &ArmNow::measured,
                    "ArmState as the driver said it, lag_frames behind the set points.")
      .def_property_readonly(
          "rest",
          [](const ArmNow& now) -> py::object {
            return now.rest ? py::object(backbone_array<float>(*now.rest)) : py::none();
          },
          "Mean shape of an arm that has rested for 0.5 s, float32 (m, 3), or None.")
      .def_readonly("state", &ArmNow::state,
                    "MotionState after the last set points, or None: no model, or never tracked.");
  py::class_<ClosedLoopOf>(module, "ClosedLoop",
                           "Leads the arm along its plan, and plans again from where it is "
                           "measured, while it moves and after. One run.")
      .def(
          py::init([](const ArmDescription& arm, const MotionModel& model,
                      const Environment& environment, const std::optional<ErrorRoom>& room,
                      std::uint64_t seed, bool adapts) {
            require_planar(arm, "limber.ClosedLoop");
            return ClosedLoopOf{
                make_closed_loop(arm, model, environment,
                                 room ? *room : error_room(model.forward()), seed, adapts),
                arm.name, environment.name, arm.hash(), environment_hash(environment)};
          }),
          "arm"_a, "model"_a, "environment"_a, "room"_a = py::none(), "seed"_a = 1,
          "adapts"_a = true, py::keep_alive<1, 2>(), py::keep_alive<1, 3>(), py::keep_alive<1, 4>(),
          "room: ErrorRoom that plans keep, None: error_room(model.forward); seed: of the "
          "searches; adapts: of a model that adapt made from a family, which arm of it this is, is "
          "followed while it moves. Raises InputError for a model without a network.")
      .def("__repr__", [](const ClosedLoopOf& loop) {
        return "ClosedLoop(arm='" + loop.arm + "', environment='" + loop.environment + "')";
      });
}

/// What is known only of an arm that was seen at its end.
template <class Known>
std::optional<Known> if_seen(const ExecutionResult& run, const Known& value) {
  return run.final_backbone ? std::optional<Known>(value) : std::nullopt;
}

}  // namespace

void bind_execution(py::module_& module) {
  bind_execution_findings(module);
  bind_controllers(module);
  Record<ExecutionResult>(module, "ExecutionResult", "What came of executing a plan.",
                          py::dynamic_attr())
      .read_only("status", &ExecutionResult::status, "ExecutionStatus: how the run ended.")
      .read_only("message", &ExecutionResult::message,
                 "Why it did not arrive: what ended it, or what it missed or struck; else empty.")
      .read_only("frames", &ExecutionResult::frames,
                 "Number of set points commanded, those of the hold included.")
      .read_only("frames_not_seen", &ExecutionResult::frames_not_seen,
                 "Number of them after which the arm was not tracked.")
      .property(
          "goal_reached", [](const ExecutionResult& run) { return if_seen(run, run.goal_reached); },
          "Whether the tip was in the goal after the hold, or None: not tracked in the last 0.25 "
          "s.")
      .property(
          "goal_error",
          [](const ExecutionResult& run) { return if_seen(run, fixed_copy(run.goal_error)); },
          "PoseError of the tip after the hold, or None: not tracked in the last 0.25 s.")
      .property(
          "collided",
          [](const ExecutionResult& run) {
            return run.collided ? std::optional(true) : if_seen(run, false);
          },
          "Whether the arm was seen to touch an obstacle, or None: not seen to, and not tracked in "
          "the last 0.25 s.")
      .read_only("prediction", &ExecutionResult::prediction,
                 "ExecutedError between plan and arm, or None where nothing was tracked.")
      .done()
      .def_readonly("replans", &ExecutionResult::replans, "Number of plans after the first.")
      .def_readonly("halts", &ExecutionResult::halts,
                    "Number of plans that were left before their end.")
      .def_property_readonly(
          "arm",
          [](const ExecutionResult& run) {
            return run.arm ? std::optional(py::array_t<float>(run.arm->e.size(), run.arm->e.data()))
                           : std::nullopt;
          },
          "Which arm of the model's family it is, as a closed loop that adapts has it at the end: "
          "e, float32 (k,), or None.")
      .def_readonly("arm_changed_s", &ExecutionResult::arm_changed_s,
                    "When that arm first moved far from what was predicted [s], or None.")
      .def_readonly("arm_changes", &ExecutionResult::arm_changes,
                    "What may have changed of it, the likeliest first: lists of TraitEstimate that "
                    "changed together, beside what was believed before.")
      .def_readonly("pressure_losses", &ExecutionResult::pressure_losses,
                    "Segments whose pressure fell short of what their valves would make of the set "
                    "points: a list of PressureLoss, in the order in which they were noticed.")
      .def_readonly("largest_window_error_m", &ExecutionResult::largest_window_error_m,
                    "Largest error of the plates' places over the windows that arm was fitted to, "
                    "each before its fit [m].")
      .def_readonly("last_window_error_m", &ExecutionResult::last_window_error_m,
                    "The same of the last one [m].")
      .def_readonly("frames_not_certified", &ExecutionResult::frames_not_certified,
                    "Frames in which nothing was certified from where the arm was.")
      .def_property_readonly(
          "open_loop_goal_error",
          [](const ExecutionResult& run) { return fixed_copy(run.open_loop_goal_error); },
          "PoseError where the first plan's hold ended, if more followed; or None.")
      .def_readonly("start_error_m", &ExecutionResult::start_error_m,
                    "Largest distance of a plate from where the plan starts, before the first set "
                    "point [m].")
      .def_readonly("first_collision", &ExecutionResult::first_collision,
                    "Contact when it first touched an obstacle, or None.")
      .def_readonly("closest", &ExecutionResult::closest,
                    "Contact where the arm came nearest to an obstacle, or None: no obstacles, or "
                    "not tracked in the last 0.25 s.")
      .def_property_readonly(
          "final_backbone",
          [](const ExecutionResult& result) -> py::object {
            return result.final_backbone ? py::object(backbone_array<float>(*result.final_backbone))
                                         : py::none();
          },
          "Shape after the hold, float32 (m, 3), or None: not tracked in the last 0.25 s.")
      .def_readonly("episode", &ExecutionResult::episode,
                    "Episode of what was commanded and measured, time 0 being the start.")
      .def("_repr_svg_", &picture_of);
  module.def("execute", &execute_with, "arm"_a, "environment"_a, "plan"_a, "driver"_a,
             "settings"_a = ExecutionSettings{}, "controller"_a = py::none(),
             "Commands a plan's frames as they stand, then holds; or what a controller decides, no "
             "faster than the plan was asked to move: a ClosedLoop, or a Controller of your own. "
             "driver: a VirtualArm, a ProcessDriver, or an ArmDriver of your own for "
             "simulation. The arm is vented before this returns, whatever happens; Ctrl-C "
             "raises KeyboardInterrupt. Raises InputError where arm, environment and plan do "
             "not belong together, or the arm is too far from the plan's start.");
}

}  // namespace limber::python
