#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/run/jacobian_controller.hpp"

namespace limber {

namespace {

// The best of 36 on a seed of their own: 0.83 cm, over an arm as it was and five disturbances
// (docs/experiments.md, Controllers).
constexpr JacobianGains kDefaultGains{0.496, 0.762, 0.00192};

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
};

void read_gain(const std::string& text, JacobianGains& gains) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const std::string name = text.substr(0, equals);
  const auto field = std::ranges::find(kGainFields, name, &GainField::name);
  if (field == kGainFields.end()) {
    std::vector<std::string_view> names;
    std::ranges::transform(kGainFields, std::back_inserter(names), &GainField::name);
    throw InputError(
        fmt::format("controller: '{}': no such gain; expected {}", text, fmt::join(names, ", ")));
  }
  const std::optional<double> value =
      number_in(std::string_view(text).substr(std::min(equals + 1, text.size())));
  if (!value || !(*value >= field->min && *value <= field->max)) {
    throw InputError(fmt::format("controller: {}: expected {}=NUMBER, from {} to {}", text, name,
                                 field->min, field->max));
  }
  gains.*(field->member) = *value;
}

}  // namespace

std::optional<JacobianGains> parse_jacobian(const std::string& text) {
  const std::size_t comma = std::min(text.find(','), text.size());
  if (text.substr(0, comma) != "jacobian") {
    return std::nullopt;
  }
  JacobianGains gains = kDefaultGains;
  for (std::size_t begin = comma; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin + 1), text.size());
    read_gain(text.substr(begin + 1, end - begin - 1), gains);
    begin = end;
  }
  return gains;
}

}  // namespace limber
