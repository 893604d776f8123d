#include "limber/planning/planner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "default_settings.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/certified_planner.hpp"
#include "limber/planning/default_planner.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "limber/planning/pressure_rrt_star.hpp"

namespace limber {

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
    DefaultPlannerSettings settings = default_settings_of(std::move(parsed));
    settings.jobs = jobs;
    settings.forest = forest;
    return make_certified_planner(make_default_planner(settings, name));
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

bool is_default_planner(const std::string& name) {
  return PlannerName::parse(name).name == "default";
}

int hold_frame_count(const ArmDescription& arm) {
  return arm.frames_in(kHoldS);
}

}  // namespace limber
