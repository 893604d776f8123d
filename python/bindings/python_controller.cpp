#include "python_controller.hpp"

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
    throw py::type_error("controller: has no method step(arm); expected a Controller");
  }
  if (const py::object model = py::getattr(*controller_, "model", py::none()); !model.is_none()) {
    model_ = &model.cast<const MotionModel&>();
  }
}

Decision PythonController::step(const Moment& now) {
  Decision decision;
  const bool returned = caller_.call([&] {
    const py::object answer = controller_->attr("step")(at_this_moment(now.arm));
    if (!answer.is_none()) {
      const auto setpoints = answer.cast<FloatArray>();
      decision.setpoint_kpa = pressures_from(setpoints, segments_, "the controller's set points");
    }
  });
  if (!returned) {
    throw Interrupted("the controller raised an exception");
  }
  return decision;
}

}  // namespace limber::python
