#include "planner_name.hpp"

#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"

namespace limber {

PlannerName PlannerName::parse(const std::string& text) {
  const std::size_t comma = text.find(',');
  PlannerName parsed;
  parsed.name = text.substr(0, comma);
  for (std::size_t at = comma; at != std::string::npos;) {
    const std::size_t next = text.find(',', at + 1);
    const std::string part = text.substr(at + 1, next == std::string::npos ? next : next - at - 1);
    const std::size_t equals = part.find('=');
    refuse_if(equals == std::string::npos || equals == 0,
              "planner setting '{}'; expected NAME,key=value,key=value", part);
    const std::string key = part.substr(0, equals);
    refuse_if(!parsed.settings.emplace(key, part.substr(equals + 1)).second,
              "planner setting {}: given twice", key);
    at = next;
  }
  return parsed;
}

double PlannerName::take(const std::string& key, double low, double high, double fallback) {
  const auto setting = settings.extract(key);
  if (setting.empty()) {
    return fallback;
  }
  return setting_number(key, setting.mapped(), low, high);
}

int PlannerName::take_whole(const std::string& key, int low, int high, int fallback) {
  return whole(key, take(key, low, high, fallback));
}

double setting_number(const std::string& key, const std::string& value, double low, double high) {
  const std::optional<double> number = number_in(value);
  refuse_if(!number || !(*number >= low && *number <= high),
            "planner setting {} = '{}'; expected a number from {} to {}", key, value, low, high);
  return *number;
}

}  // namespace limber
