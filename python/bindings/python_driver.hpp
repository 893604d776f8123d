#pragma once

#include <memory>
#include <optional>

#include <pybind11/pybind11.h>

#include "caller_thread.hpp"
#include "limber/run/arm_driver.hpp"
#include "limber/run/controller.hpp"

namespace limber::python {

/// An arm that a Python object moves: `state()`, `command(setpoint_kpa)` and `vent()`, as
/// ArmDriver has them. Its methods run on the thread that waits for the work.
class PythonDriver final : public ArmDriver {
 public:
  PythonDriver(py::object driver, CallerThread& caller);

  const ArmState& state() const override { return state_; }
  const ArmState& command(const Eigen::Ref<const Pressures>& setpoint_kpa) override;
  void vent() noexcept override;

 private:
  std::shared_ptr<py::object> driver_;  // let go with Python's lock
  CallerThread& caller_;
  ArmState state_;
};

/// An ArmEstimate at one moment: a value, which may outlive the run.
struct ArmNow {
  int frames = 0;
  Pressures setpoint_kpa;
  ArmState measured;
  int lag_frames = 0;
  int frames_unseen = 0;
  std::optional<Backbone> rest;
  std::optional<MotionState> state;
};

/// A controller that is a Python object: `step(arm)` returns set points or None. Its methods run on
/// the thread that waits for the work.
class PythonController final : public Controller {
 public:
  /// @param segments  entries of its set points
  /// @throws TypeError where it has no `step`, or its `model` is no MotionModel.
  PythonController(py::object controller, Eigen::Index segments, CallerThread& caller);

  EstimateModel estimate_with() const override { return {model_, std::nullopt}; }
  Decision step(const Moment& now) override;

 private:
  std::shared_ptr<py::object> controller_;    // both let go with Python's lock
  std::shared_ptr<py::object> model_object_;  // whatever `model` is set to meanwhile
  Eigen::Index segments_;
  CallerThread& caller_;
  const MotionModel* model_ = nullptr;
};

}  // namespace limber::python
