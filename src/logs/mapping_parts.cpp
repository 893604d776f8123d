#include "mapping_parts.hpp"

#include <fmt/format.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

double factor_to(const YamlReader& node, const std::string& to) {
  const std::string from = node.text();
  const std::optional<double> factor = unit_factor(from, to);
  if (!factor) {
    node.refuse(fmt::format(
        "{} found; expected a unit that limber can turn into {}: lengths in m, cm, mm, in; angles "
        "in rad, deg; times in s, ms, us, ns, min; pressures in kPa, Pa, hPa, mbar, bar, MPa, psi",
        node.found(), to));
  }
  return *factor;
}

bool read_headings_measured(const YamlReader& node) {
  if (node.text() != "measured" && node.text() != "tangent") {
    node.refuse(fmt::format("{} found; expected measured or tangent", node.found()));
  }
  return node.text() == "measured";
}

void number_plates(const YamlReader& node, const std::vector<YamlReader>& elements,
                   const ArmDescription& arm, bool untracked_base,
                   std::vector<PointSource>& points) {
  const int last = arm.point_count() - 1;
  const int count = static_cast<int>(points.size());
  const bool all_but_base = untracked_base && count == last;
  const bool all = count == arm.point_count() || all_but_base;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (elements[i].has("plate")) {
      points[i].plate = elements[i].at("plate").integer("a plate of the arm, 0 the base", 0, last);
    } else if (all) {
      points[i].plate = static_cast<int>(i) + int(all_but_base);
    } else {
      node.refuse(
          fmt::format("{} points found; arm '{}' has {} plates: say which plate each point "
                      "is, as in {{plate: 0, …}}, 0 the base, {} the end",
                      points.size(), arm.name, arm.point_count(), last));
    }
    if (i > 0 && points[i].plate <= points[i - 1].plate) {
      elements[i].refuse(fmt::format("{} after {}; expected rising plates, base first",
                                     plate_name(points[i].plate), plate_name(points[i - 1].plate)));
    }
  }
  if (points.back().plate != last) {
    node.refuse(
        fmt::format("the last point is {}; expected {}, the arm's end: what lies beyond the last "
                    "point can't be interpolated. Describe an arm that ends where it is tracked",
                    plate_name(points.back().plate), plate_name(last)));
  }
}

}  // namespace limber
