#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "default_planner.hpp"
#include "limber/common/error.hpp"
#include "limber/common/jobs.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

namespace {

using Settings = DefaultPlannerSettings;

struct Range {
  const char* name;
  std::variant<double Settings::*, int Settings::*> member;
  double low;
  double high;
};

const std::array kRanges{Range{"step_size", &Settings::step_size, 1e-3, 10.0},
                         Range{"goal_steering_share", &Settings::goal_steering_share, 0.0, 1.0},
                         Range{"shot_spread", &Settings::shot_spread, 0.0, 10.0},
                         Range{"goal_bias", &Settings::goal_bias, 0.0, 1.0},
                         Range{"goal_spread", &Settings::goal_spread, 0.0, 10.0},
                         Range{"goal_configurations", &Settings::goal_configurations, 1, 1e6},
                         Range{"random_parent", &Settings::random_parent, 0.0, 1.0},
                         Range{"cell_pressure", &Settings::cell_pressure, 1e-4, 2.0},
                         Range{"cell_position_m", &Settings::cell_position_m, 1e-5, 10.0},
                         Range{"cell_orientation_rad", &Settings::cell_orientation_rad, 1e-4, 10.0},
                         Range{"max_cost_ratio", &Settings::max_cost_ratio, 1.0, 1e6},
                         Range{"improved_plans", &Settings::improved_plans, 0, 64},
                         Range{"improvement_queries", &Settings::improvement_queries, 0.0, 1e18},
                         Range{"improvement_queries_without_room",
                               &Settings::improvement_queries_without_room, 0.0, 1e18},
                         Range{"restart_queries", &Settings::restart_queries, 1.0, 1e18},
                         Range{"hold_position_m", &Settings::hold_position_m, 0.0, 10.0},
                         Range{"hold_orientation_rad", &Settings::hold_orientation_rad, 0.0, 10.0}};

double value_of(const Settings& settings, const Range& range) {
  return std::visit([&](auto member) { return double(settings.*member); }, range.member);
}

void set(Settings& settings, const Range& range, double value) {
  if (const auto* real = std::get_if<double Settings::*>(&range.member)) {
    settings.** real = value;
    return;
  }
  settings.*std::get<int Settings::*>(range.member) = whole(range.name, value);
}

}  // namespace

void require_valid(const DefaultPlannerSettings& settings) {
  for (const Range& range : kRanges) {
    require_between(range.name, value_of(settings, range), range.low, range.high);
  }
  require_between("goal_bias + goal_steering_share",
                  settings.goal_bias + settings.goal_steering_share, 0.0, 1.0);
  require_between("jobs", settings.jobs, 0, kMaxJobs);
}

DefaultPlannerSettings default_settings_of(PlannerName name) {
  DefaultPlannerSettings settings;
  for (const Range& range : kRanges) {
    set(settings, range, name.take(range.name, range.low, range.high, value_of(settings, range)));
  }
  if (!name.settings.empty()) {
    std::array<const char*, kRanges.size()> known{};
    std::ranges::transform(kRanges, known.begin(), &Range::name);
    throw InputError(fmt::format("planner setting {}: the default planner has {}",
                                 name.settings.begin()->first, fmt::join(known, ", ")));
  }
  return settings;
}

}  // namespace limber
