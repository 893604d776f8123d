#include "python_controller.hpp"

#include <fmt/format.h>

#include "arrays.hpp"
#include "limber/common/error.hpp"

namespace limber::python {

namespace {

std::shared_ptr<py::object> shared(py::object object) {
  return {new py::object(std::move(object)), [](py::object* one) {
            const py::gil_scoped_acquire python;
            delete one;
          }};
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
