#include "limber/planning/planner_factory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "certified/certified_planner.hpp"
#include "limber/common/error.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "paper/pressure_rrt_star.hpp"
#include "search/default_planner.hpp"
#include "search/default_settings.hpp"

namespace limber {

namespace {

/// As published, pressures are the set points; "paper,valves=1" predicts with the valves.
std::unique_ptr<Planner> make_paper_planner(PlannerName parsed, const std::string& name) {
  const Valves valves = parsed.take("valves", 0, 1, 0) != 0 ? Valves::as_given : Valves::left_out;
  if (!parsed.settings.empty()) {
    throw InputError(
        fmt::format("planner setting {}: unknown; '{}' has the setting valves (0 or 1)",
                    parsed.settings.begin()->first, parsed.name));
  }
  return make_certified_planner(make_pressure_rrt_star({}, name), valves);
}

}  // namespace

std::vector<std::string> planner_names() {
  return {"default", "paper"};
}

std::unique_ptr<Planner> make_planner(const std::string& name, int jobs, const Forest* forest) {
  if (PlannerName parsed = PlannerName::parse(name); parsed.name == "default") {
    DefaultPlannerSettings settings = default_settings_of(std::move(parsed));
    settings.jobs = jobs;
    settings.forest = forest;
    return make_certified_planner(make_default_planner(settings, name));
  }
  if (forest != nullptr) {
    throw InputError(fmt::format("planner '{}' uses no forest; only 'default' does", name));
  }
  if (PlannerName parsed = PlannerName::parse(name); parsed.name == "paper") {
    return make_paper_planner(std::move(parsed), name);
  }
  if (name.rfind("ompl:", 0) == 0) {
    return make_certified_planner(make_ompl_planner(name));
  }
  throw InputError(
      fmt::format("planner '{}'; expected one of {}, or ompl:NAME (docs/planning.md, OMPL)", name,
                  fmt::join(planner_names(), ", ")));
}

bool is_default_planner(const std::string& name) {
  return PlannerName::parse(name).name == "default";
}

}  // namespace limber
