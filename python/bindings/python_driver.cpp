#include "python_driver.hpp"

#include "arrays.hpp"
#include "limber/common/error.hpp"

namespace limber::python {

PythonDriver::PythonDriver(py::object driver, CallerThread& caller)
    : driver_(new py::object(std::move(driver)),
              [](py::object* object) {
                const py::gil_scoped_acquire python;
                delete object;
              }),
      caller_(caller) {
  const py::gil_scoped_acquire python;
  state_ = driver_->attr("state")().cast<ArmState>();
}

const ArmState& PythonDriver::command(const Eigen::Ref<const Pressures>& setpoint_kpa) {
  const Pressures setpoints = setpoint_kpa;
  const bool returned = caller_.call(
      [&] { state_ = driver_->attr("command")(vector_array(setpoints)).cast<ArmState>(); });
  if (!returned) {
    throw Interrupted("the driver raised an exception");
  }
  return state_;
}

void PythonDriver::vent() noexcept {
  (void)caller_.call([&] { driver_->attr("vent")(); });
}

}  // namespace limber::python
