#include "limber/run/executor.hpp"

namespace limber {

void PlanSource::observe(const Pressures& /*setpoint_kpa*/, const ArmState& /*state*/) {}

FrameSetpoint PlanSource::setpoint(const Plan& plan, std::size_t /*frame*/, std::size_t next) {
  return {plan.frames[next].setpoint_kpa, next};
}

std::function<MotionAdvice()> PlanSource::advise(const Plan& /*plan*/, std::size_t /*next*/) {
  return {};
}

const char* to_string(ExecutionStatus status) {
  switch (status) {
    case ExecutionStatus::done:
      return "done";
    case ExecutionStatus::fault:
      return "fault";
    default:
      return "stopped";
  }
}

}  // namespace limber
