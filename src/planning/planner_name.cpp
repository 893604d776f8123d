#include "planner_name.hpp"

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"

namespace limber {

namespace {

struct Renamed {
  const char* before;
  const char* now;
};

constexpr Renamed kRenamed[] = {{"goal_shots", "goal_steering_share"},
                                {"dearest", "max_cost_ratio"}};

/// Today's name of what may be called as before.
std::string todays_name(const std::string& name, std::vector<std::string>& notes) {
  for (const Renamed& one : kRenamed) {
    if (name == one.before) {
      notes.push_back(fmt::format("{} is called {} now", one.before, one.now));
      return one.now;
    }
  }
  return name;
}

}  // namespace

PlannerName PlannerName::parse(const std::string& text) {
  const std::size_t comma = text.find(',');
  PlannerName parsed;
  parsed.name = todays_name(text.substr(0, comma), parsed.notes);
  for (std::size_t at = comma; at != std::string::npos;) {
    const std::size_t next = text.find(',', at + 1);
    const std::string part = text.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError(
          fmt::format("planner setting '{}'; expected NAME,key=value,key=value", part));
    }
    const std::string key = todays_name(part.substr(0, equals), parsed.notes);
    if (!parsed.settings.emplace(key, part.substr(equals + 1)).second) {
      throw InputError(fmt::format("planner setting {}: given twice", key));
    }
    at = next;
  }
  return parsed;
}

double PlannerName::take(const std::string& key, double low, double high, double fallback) {
  const auto setting = settings.extract(key);
  if (setting.empty()) {
    return fallback;
  }
  const std::string& value = setting.mapped();
  const std::optional<double> number = number_in(value);
  if (!number || !(*number >= low && *number <= high)) {
    throw InputError(fmt::format("planner setting {} = '{}'; expected a number from {} to {}", key,
                                 value, low, high));
  }
  return *number;
}

}  // namespace limber
