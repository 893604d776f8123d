#include "limber/planning/planner.hpp"

#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/planning/certified_planner.hpp"
#include "limber/planning/default_planner.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "limber/planning/pressure_rrt_star.hpp"
#include "planner_name.hpp"

namespace limber {

namespace {

/// Ranges are those of make_default_planner, which names them.
DefaultPlannerSettings take_settings(PlannerName& name) {
  DefaultPlannerSettings settings;
  const auto take = [&](const char* key, auto& value) {
    constexpr double kAny = std::numeric_limits<double>::max();
    value = static_cast<std::remove_reference_t<decltype(value)>>(
        name.take(key, 0.0, kAny, double(value)));
  };
  take("step_size", settings.step_size);
  take("goal_shots", settings.goal_shots);
  take("shot_spread", settings.shot_spread);
  take("goal_bias", settings.goal_bias);
  take("goal_spread", settings.goal_spread);
  take("random_parent", settings.random_parent);
  take("cell_pressure", settings.cell_pressure);
  take("cell_position_m", settings.cell_position_m);
  take("cell_orientation_rad", settings.cell_orientation_rad);
  take("dearest", settings.dearest);
  take("improved_plans", settings.improved_plans);
  if (!name.settings.empty()) {
    throw InputError(fmt::format(
        "planner setting {}: the default planner has step_size, goal_shots, shot_spread, goal_bias, "
        "goal_spread, random_parent, cell_pressure, cell_position_m, cell_orientation_rad, dearest, "
        "improved_plans",
        name.settings.begin()->first));
  }
  return settings;
}

}  // namespace

const char* to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::solved:
      return "solved";
    case PlanStatus::limit:
      return "limit";
    case PlanStatus::no_solution:
      return "no_solution";
    case PlanStatus::invalid_start:
      return "invalid_start";
    case PlanStatus::goal_unreachable:
      return "goal_unreachable";
    case PlanStatus::goal_in_collision:
      return "goal_in_collision";
    case PlanStatus::not_certified:
      return "not_certified";
  }
  return "";
}

const char* to_string(PlanLimit limit) {
  switch (limit) {
    case PlanLimit::time:
      return "time";
    case PlanLimit::iterations:
      return "iterations";
    case PlanLimit::queries:
      return "queries";
    case PlanLimit::memory:
      return "memory";
  }
  return "";
}

std::vector<std::string> planner_names() {
  return {"default", "paper", "paper-steer-all"};
}

std::unique_ptr<Planner> make_planner(const std::string& name, int jobs, const Forest* forest) {
  if (PlannerName parsed = PlannerName::parse(name); parsed.name == "default") {
    DefaultPlannerSettings settings = take_settings(parsed);
    settings.jobs = jobs;
    settings.forest = forest;
    return make_certified_planner(make_default_planner(settings));
  }
  if (forest != nullptr) {
    throw InputError(fmt::format("planner '{}' uses no forest; 'default' does", name));
  }
  if (name == "paper") {
    return make_certified_planner(make_pressure_rrt_star(ParentRule::lazy));
  }
  if (name == "paper-steer-all") {
    return make_certified_planner(make_pressure_rrt_star(ParentRule::steer_all));
  }
  if (name.rfind("ompl:", 0) == 0) {
    return make_certified_planner(make_ompl_planner(name));
  }
  throw InputError(
      fmt::format("planner '{}'; expected one of {}, or ompl:NAME (planning/ompl_planner.hpp)",
                  name, fmt::join(planner_names(), ", ")));
}

int hold_frame_count(const ArmDescription& arm) {
  return arm.frames_in(kHoldS);
}

}  // namespace limber
