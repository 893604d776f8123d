#include "python_driver.hpp"

#include <fmt/format.h>

#include "arrays.hpp"
#include "limber/common/error.hpp"

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

}  // namespace

PythonDriver::PythonDriver(py::object driver, CallerThread& caller)
    : driver_(new py::object(std::move(driver)),
              [](py::object* object) {
                const py::gil_scoped_acquire python;
                delete object;
              }),
      caller_(caller) {
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

}  // namespace limber::python
