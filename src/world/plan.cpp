#include "limber/world/plan.hpp"

#include <cmath>

#include <fmt/format.h>

#include "limber/arm/arm_commands.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/world/environment.hpp"

namespace limber {

namespace {

constexpr double kRoundingShare = 1e-5;  // of the largest command: float32, with room

/// The plan's own limits have to be narrower than the arm's.
void require_limits_of(const Plan& plan, const ArmDescription& arm, const std::string& file) {
  const std::string key = quantity_key(arm.command, "limits");
  refuse_if(!plan.limits.empty() && int(plan.limits.size()) != arm.channel_count(),
            "{}: {}: {} pairs found; arm '{}' has {} segments", file, key, plan.limits.size(),
            arm.name, arm.channel_count());
  for (std::size_t i = 0; i < plan.limits.size(); ++i) {
    const PressureLimits own = arm.limits_of_channel(int(i));
    if (!own.contains(plan.limits[i])) {
      throw InputError(fmt::format(
          "{}: {}[{}]: {} {unit} found; the limits of arm '{}' are {} {unit}", file, key, i,
          to_string(plan.limits[i]), arm.name, to_string(own), fmt::arg("unit", arm.command.unit)));
    }
  }
}

}  // namespace

double Plan::duration_s() const {
  return frames.empty() ? 0.0 : double(frames.size() - 1) / frame_rate_hz;
}

void require_plan_in(const Plan& plan, const Environment& environment, const std::string& file) {
  const std::string hash = environment_hash(environment);
  refuse_if(plan.environment_hash != hash,
            "{}: made for environment '{}' (hash {}); this one is '{}' (hash {})", file,
            plan.environment_name, plan.environment_hash, environment.name, hash);
}

void require_plan_of(const Plan& plan, const ArmDescription& arm, const std::string& file) {
  const std::string why = why_another_arm(plan.arm(), arm, file);
  if (!why.empty()) {
    throw InputError(fmt::format(
        "{}: arm_hash: made for arm '{}' ({}); this is arm '{}' ({}): {}. Plan again for this arm, "
        "or give the plan's own (--arm)",
        file, plan.arm_name, plan.arm_hash, arm.name, arm.hash(), why));
  }
  refuse_if(plan.frame_rate_hz != arm.frame_rate_hz,
            "{}: frame_rate_hz: {} found; arm '{}' takes {} frames per second", file,
            plan.frame_rate_hz, arm.name, arm.frame_rate_hz);
  const int n = arm.channel_count();
  require_limits_of(plan, arm, file);
  const std::vector<PressureLimits> allowed = plan.limits.empty() ? limits_of(arm) : plan.limits;
  const double step_limit = arm.pressure_step_limit_kpa();
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    const PlanFrame& frame = plan.frames[k];
    refuse_if(frame.setpoint_kpa.size() != n || frame.pressure_kpa.size() != n ||
                  frame.backbone.rows() != arm.point_count(),
              "{}: frames[{}]: {} set points and {} poses found; arm '{}' has {} segments and {} "
              "plates",
              file, k, frame.setpoint_kpa.size(), frame.backbone.rows(), arm.name, n,
              arm.point_count());
    for (int i = 0; i < n; ++i) {
      const double pressure = frame.setpoint_kpa[i];
      const PressureLimits& limits = allowed[i];
      if (!limits.contains(pressure)) {
        throw InputError(fmt::format(
            "{}: frames[{}].{setpoint}[{}]: {} {unit} found; expected {} {unit}{}", file, k, i,
            pressure, to_string(limits), plan.limits.empty() ? "" : ", the plan's limits",
            fmt::arg("unit", arm.command.unit),
            fmt::arg("setpoint", quantity_key(arm.command, "setpoint"))));
      }
      const double step =
          k == 0 ? 0.0 : std::abs(pressure - double(plan.frames[k - 1].setpoint_kpa[i]));
      if (step > step_limit + kRoundingShare * arm.limits_of_channel(i).largest_kpa()) {
        throw InputError(fmt::format(
            "{}: frames[{}].{setpoint}[{}]: a step of {:.6g} {unit} in one frame; expected at "
            "most {} {unit} ({} {unit}/s at {} Hz)",
            file, k, i, step, step_limit, arm.pressure_rate_limit_kpa_per_s, arm.frame_rate_hz,
            fmt::arg("unit", arm.command.unit),
            fmt::arg("setpoint", quantity_key(arm.command, "setpoint"))));
      }
    }
  }
}

void write_setpoints_csv(const fs::path& path, const Plan& plan) {
  std::string text = "time_s";
  const Eigen::Index n = plan.frames.empty() ? 0 : plan.frames.front().setpoint_kpa.size();
  for (const std::string& what : {std::string("setpoint"), followed_name(plan.command)}) {
    for (int i = 0; i < n; ++i) {
      text += "," + quantity_column(plan.command, what, i);
    }
  }
  text += '\n';
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    text += fmt::format("{}", double(k - 1) / plan.frame_rate_hz);
    for (const Pressures& row : {plan.frames[k].setpoint_kpa, plan.frames[k].pressure_kpa}) {
      for (const float pressure : row) {
        text += fmt::format(",{}", pressure);
      }
    }
    text += '\n';
  }
  write_file_atomically(path, text);
}

void write_commands_csv(const fs::path& path, const Plan& plan, const ArmDescription& arm) {
  std::string text = "time_s";
  for (const ArmCommand& command : arm.commands) {
    text += "," + command.name;
  }
  text += '\n';
  for (std::size_t k = 1; k < plan.frames.size(); ++k) {
    text += fmt::format("{}", double(k - 1) / plan.frame_rate_hz);
    for (const double value : commands_for(arm, plan.frames[k].setpoint_kpa.cast<double>())) {
      text += fmt::format(",{}", float(value));
    }
    text += '\n';
  }
  write_file_atomically(path, text);
}

}  // namespace limber
