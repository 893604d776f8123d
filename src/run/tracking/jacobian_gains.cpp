#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/run/jacobian_controller.hpp"

namespace limber {

namespace {

// The best of 36 each that tools/tune_baselines.py tried on seed 7001: 0.83 and 0.99 cm, over an
// arm as it was and five disturbances.
constexpr JacobianGains kNoLoadGains{0.496, 0.762, 0.00192, 0.0};
constexpr JacobianGains kOnlineGains{0.491, 2.22, 0.00526, 0.061};

struct GainField {
  const char* name;
  double JacobianGains::*member;
  double min;
  double max;
};

constexpr std::array kGainFields = {
    GainField{"proportional", &JacobianGains::proportional, 0.0, 10.0},
    GainField{"integral", &JacobianGains::integral_per_s, 0.0, 100.0},
    GainField{"damping", &JacobianGains::damping_m_per_kpa, 1e-6, 1.0},
    GainField{"update", &JacobianGains::update, 1e-6, 1.0},
};

void read_gain(const std::string& text, bool is_online, JacobianGains& gains) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string name = text.substr(0, equals);
  std::string names;
  for (const GainField& field : kGainFields) {
    if (field.member == &JacobianGains::update && !is_online) {
      continue;
    }
    names += (names.empty() ? "" : ", ") + std::string(field.name);
    if (name != field.name) {
      continue;
    }
    const std::optional<double> value =
        number_in(std::string_view(text).substr(std::min(equals + 1, text.size())));
    if (!value || !(*value >= field.min && *value <= field.max)) {
      throw InputError(fmt::format("controller: {}: expected {}=NUMBER, from {} to {}", text, name,
                                   field.min, field.max));
    }
    gains.*(field.member) = *value;
    return;
  }
  throw InputError(fmt::format("controller: '{}': no such gain; expected {}", text, names));
}

}  // namespace

std::optional<JacobianGains> parse_jacobian(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::string name = text.substr(0, comma);
  const bool is_online = name == "online_jacobian";
  if (name != "jacobian" && !is_online) {
    return std::nullopt;
  }
  JacobianGains gains = is_online ? kOnlineGains : kNoLoadGains;
  for (std::size_t begin = comma; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin + 1), text.size());
    read_gain(text.substr(begin + 1, end - begin - 1), is_online, gains);
    begin = end;
  }
  return gains;
}

}  // namespace limber
