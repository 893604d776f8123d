#pragma once

#include <memory>

#include <pybind11/pybind11.h>

#include "caller_thread.hpp"
#include "limber/run/arm_driver.hpp"

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

}  // namespace limber::python
