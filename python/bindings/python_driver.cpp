#include "python_driver.hpp"

#include <fmt/format.h>

#include "arrays.hpp"
#include "limber/common/error.hpp"
#include "record.hpp"

namespace limber::python {

namespace {

/// @throws TypeError naming the driver's method that returned something else.
ArmState state_from(const py::object& driver, const char* method, const py::object& returned) {
  if (!py::isinstance<ArmState>(returned)) {
    throw py::type_error(fmt::format("{}.{} returned {}; expected an ArmState", type_name(driver),
                                     method, type_name(returned)));
  }
  return returned.cast<ArmState>();
}

ArmNow at_this_moment(const ArmEstimate& arm) {
  ArmNow now{arm.frames(),        arm.setpoint_kpa(), arm.measured(), arm.lag_frames(),
             arm.frames_unseen(), arm.rest(),         std::nullopt};
  if (arm.has_state()) {
    now.state = arm.state();
  }
  return now;
}

}  // namespace

PythonDriver::PythonDriver(py::object driver, CallerThread& caller)
    : driver_(shared(std::move(driver))), caller_(caller) {
  const py::gil_scoped_acquire python;
  state_ = state_from(*driver_, "state", driver_->attr("state")());
}

const ArmState& PythonDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  const Pressures setpoints = setpoint_kpa;
  const bool returned = caller_.call([&] {
    state_ = state_from(*driver_, "command", driver_->attr("command")(vector_array(setpoints)));
  });
  if (!returned) {
    throw Interrupted("the driver raised an exception");
  }
  return state_;
}

void PythonDriver::vent() noexcept {
  (void)caller_.call([&] { driver_->attr("vent")(); });
}

PythonController::PythonController(py::object controller, Eigen::Index segments,
                                   CallerThread& caller)
    : controller_(shared(std::move(controller))), segments_(segments), caller_(caller) {
  const py::gil_scoped_acquire python;
  if (!py::hasattr(*controller_, "step")) {
    throw py::type_error(fmt::format(
        "controller: {} has no method step(arm); expected a Controller", type_name(*controller_)));
  }
  model_object_ = shared(py::getattr(*controller_, "model", py::none()));
  if (model_object_->is_none()) {
    return;
  }
  if (!py::isinstance<MotionModel>(*model_object_)) {
    throw py::type_error(fmt::format("{}.model is {}; expected a MotionModel or None",
                                     type_name(*controller_), type_name(*model_object_)));
  }
  model_ = &model_object_->cast<const MotionModel&>();
}

Decision PythonController::step(const Moment& now) {
  Decision decision;
  const bool returned = caller_.call([&] {
    const py::object answer = controller_->attr("step")(at_this_moment(now.arm));
    if (!answer.is_none()) {
      py::detail::make_caster<FloatArray> setpoints;
      if (!setpoints.load(answer, true)) {
        throw py::type_error(fmt::format("{}.step returned {}; expected set points or None",
                                         type_name(*controller_), type_name(answer)));
      }
      decision.setpoint_kpa = pressures_from(py::detail::cast_op<const FloatArray&>(setpoints),
                                             segments_, "the controller's set points");
    }
  });
  if (!returned) {
    throw Interrupted("the controller raised an exception");
  }
  return decision;
}

}  // namespace limber::python
