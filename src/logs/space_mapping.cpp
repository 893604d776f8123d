#include "space_mapping.hpp"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Geometry>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/mapped.hpp"
#include "limber/data/log_units.hpp"

namespace limber {

namespace {

/// Where columns of `axes` are missing, none is left out silently.
bool names_all(const YamlReader& node, std::initializer_list<const char*> keys) {
  const auto count =
      std::count_if(keys.begin(), keys.end(), [&](const char* key) { return node.has(key); });
  if (count != 0 && count != std::ssize(keys)) {
    node.refuse(fmt::format("{} of the columns {} found; expected all or none of them", count,
                            fmt::join(keys, ", ")));
  }
  return count != 0;
}

std::vector<std::string> read_rotation(const YamlReader& node, const EulerAngles& euler) {
  const bool quaternion = names_all(node, {"qx", "qy", "qz", "qw"});
  node.refuse_if(quaternion && node.has("euler"),
                 "a quaternion and Euler angles found; expected one of both");
  std::vector<std::string> columns;
  if (quaternion) {
    columns = {named_column(node.at("qx")), named_column(node.at("qy")),
               named_column(node.at("qz")), named_column(node.at("qw"))};
  }
  if (node.has("euler")) {
    columns = mapped<std::string>(node.at("euler").elements(), named_column);
    if (columns.size() != 3) {
      node.at("euler").refuse(
          fmt::format("{} columns found; expected 3, one for each turn of 'backbone.euler.order'",
                      columns.size()));
    }
    if (euler.order.empty()) {
      node.at("euler").refuse(
          "Euler angles without an order and a unit mean nothing; expected 'euler: {order: zyx, "
          "unit: deg}' in 'backbone': turns as written, each about the axis as turned before");
    }
  }
  return columns;
}

EulerAngles read_euler(const YamlReader& node) {
  node.refuse_unknown_keys({"order", "unit"});
  EulerAngles euler;
  const YamlReader order = node.at("order");
  euler.order = order.text();
  const std::string& axes = euler.order;
  const bool valid = axes.size() == 3 && axes.find_first_not_of("xyz") == std::string::npos &&
                     axes[0] != axes[1] && axes[1] != axes[2];
  if (!valid) {
    order.refuse(fmt::format(
        "{} found; expected three axes in the order of the turns, such as zyx, xyz or zxz",
        order.found()));
  }
  euler.factor = factor_to(node.at("unit"), "rad");
  return euler;
}

PointSource read_space_point(const YamlReader& node, const EulerAngles& euler) {
  node.refuse_unknown_keys(
      {"plate", "x", "y", "z", "qx", "qy", "qz", "qw", "euler", "body", "marker"});
  PointSource point;
  const bool columns = names_all(node, {"x", "y", "z"});
  node.refuse_if(
      int(columns) + int(node.has("body")) + int(node.has("marker")) != 1,
      "expected one of: x, y and z (columns of a CSV), body, or marker (objects of a Motive file)");
  if (columns) {
    point.x = named_column(node.at("x"));
    point.y = named_column(node.at("y"));
    point.z = named_column(node.at("z"));
    point.rotation = read_rotation(node, euler);
  } else if (node.has("body")) {
    node.refuse_unknown_keys({"plate", "body"});
    point.body = named_column(node.at("body"));
  } else {
    node.refuse_unknown_keys({"plate", "marker"});
    point.marker = named_column(node.at("marker"));
  }
  return point;
}

bool same_source(const PointSource& a, const PointSource& b) {
  return !a.x.empty()
             ? a.x == b.x && a.y == b.y && a.z == b.z
             : a.body == b.body && a.marker == b.marker && a.right == b.right && a.left == b.left;
}

/// All plates but the base have a rotation, or none.
void require_alike(const std::vector<YamlReader>& elements,
                   const std::vector<PointSource>& points) {
  const PointSource& tip = points.back();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].plate > 0 && points[i].rotation.empty() != tip.rotation.empty()) {
      elements[i].refuse(fmt::format(
          "{} has {} rotation, {} has {}; expected one of every plate but the base, or of none "
          "('headings: tangent' leaves all of them out)",
          plate_name(points[i].plate), points[i].rotation.empty() ? "no" : "a",
          plate_name(tip.plate), tip.rotation.empty() ? "none" : "one"));
    }
  }
}

std::vector<PointSource> read_space_points(const YamlReader& node, const ArmDescription& arm,
                                           const ImportMapping& mapping) {
  const std::vector<YamlReader> elements = node.elements();
  std::vector<PointSource> points = read_sources(elements, [&](const YamlReader& element) {
    return read_space_point(element, mapping.euler);
  });
  node.refuse_if(points.empty(), "no points found; expected at least the arm's end");
  number_plates(node, elements, arm, true, points);
  node.refuse_if(points.back().plate == 0, "plate 0 alone found; expected at least the arm's end");
  if (mapping.headings_measured) {
    require_alike(elements, points);
  }
  return points;
}

void read_space_backbone(const YamlReader& node, const ArmDescription& arm,
                         ImportMapping& mapping) {
  node.refuse_unknown_keys({"unit", "euler", "headings", "points"});
  if (node.has("unit")) {
    mapping.length_unit = node.at("unit").text();
    mapping.length_factor = factor_to(node.at("unit"), "m");
  }
  node.read_if_there("euler", mapping.euler, read_euler);
  node.read_if_there("headings", mapping.headings_measured, read_headings_measured);
  if (node.has("points")) {
    mapping.points = read_space_points(node.at("points"), arm, mapping);
  }
}

Eigen::Vector3d read_three(const YamlReader& node, const char* meaning) {
  const std::vector<double> numbers = node.numbers(meaning);
  node.refuse_if(numbers.size() != 3, "{} numbers found; expected 3, x, y and z in the log's frame",
                 numbers.size());
  return {numbers[0], numbers[1], numbers[2]};
}

Eigen::Vector3d read_axis(const YamlReader& node) {
  const Eigen::Vector3d axis = read_three(node, "a part of a direction");
  node.refuse_if(!(axis.norm() > 0.0), "[0, 0, 0] found; expected a direction in the log's frame");
  return axis.normalized();
}

Eigen::Vector2d read_rest(const YamlReader& node) {
  const std::vector<double> times = node.numbers("a time in s");
  node.refuse_if(times.size() != 2 || times[1] <= times[0],
                 "expected [from, to] in s, rising: when the arm hung straight");
  return {times[0], times[1]};
}

SpaceAlignment read_space_alignment(const YamlReader& node) {
  constexpr const char* kAllowed =
      "expected base, none, {rest_s: [from, to]} or {x_axis: [x, y, z]}, with position_m where "
      "the base is not tracked, and y_axis if you like";
  SpaceAlignment alignment;
  if (!node.is_mapping()) {
    if (node.text() != "base" && node.text() != "none") {
      node.refuse(fmt::format("{} found; {}", node.found(), kAllowed));
    }
    alignment.kind =
        node.text() == "base" ? SpaceAlignment::Kind::base : SpaceAlignment::Kind::none;
    return alignment;
  }
  node.refuse_unknown_keys({"position_m", "x_axis", "y_axis", "rest_s"});
  alignment.kind = SpaceAlignment::Kind::given;
  if (node.has("position_m")) {
    alignment.position_m = read_three(node.at("position_m"), "a place in metres");
  }
  node.read_if_there("x_axis", alignment.x_axis, read_axis);
  node.read_if_there("y_axis", alignment.y_axis, read_axis);
  node.read_if_there("rest_s", alignment.rest_s, read_rest);
  node.refuse_if(!alignment.x_axis && !alignment.rest_s, "neither x_axis nor rest_s found; {}",
                 kAllowed);
  if (alignment.x_axis && alignment.y_axis &&
      alignment.x_axis->cross(*alignment.y_axis).norm() < kParallelAxes) {
    node.at("y_axis").refuse("lies along x_axis; expected a direction to the left of it");
  }
  return alignment;
}

/// What the base can't tell has to be said.
void require_base(const YamlReader& root, const ImportMapping& mapping) {
  const SpaceAlignment& alignment = mapping.space_alignment;
  if (mapping.points.empty() || alignment.kind == SpaceAlignment::Kind::none) {
    return;
  }
  const PointSource& first = mapping.points.front();
  const bool tracked = first.plate == 0;
  if (alignment.kind == SpaceAlignment::Kind::given) {
    if (!tracked && !alignment.position_m) {
      root.at("alignment")
          .refuse(
              "no point is plate 0, the base; expected where it is, in metres of the log's "
              "frame: 'position_m: [x, y, z]'");
    }
    return;
  }
  if (!tracked || (first.rotation.empty() && first.body.empty())) {
    root.at("backbone")
        .refuse(fmt::format(
            "{}; expected where the arm points: 'alignment: {{{}x_axis: [x, y, z]}}', the "
            "direction of the straight arm in the log's frame (y_axis, to its left, is any "
            "perpendicular unless given), or 'rest_s: [from, to]' in place of x_axis, a time in "
            "which it hung straight; or 'alignment: none' where the log is in the arm's frame",
            tracked ? "plate 0, the base, has no rotation" : "no point is plate 0, the base",
            tracked ? "" : "position_m: [x, y, z], "));
  }
}

}  // namespace

std::vector<PointSource> read_sources(
    const std::vector<YamlReader>& elements,
    const std::function<PointSource(const YamlReader&)>& read_point) {
  std::vector<PointSource> points;
  for (const YamlReader& element : elements) {
    points.push_back(read_point(element));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (same_source(points.back(), points[i])) {
        element.refuse(fmt::format("the same source as {} before it", point_name(Eigen::Index(i))));
      }
    }
  }
  return points;
}

std::string named_column(const YamlReader& node) {
  const std::string name = node.text();
  node.refuse_if(name.empty(), "an empty name found; expected a column or an object by its name");
  return name;
}

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
  const int count = int(points.size());
  const bool all_but_base = untracked_base && count == last;
  const bool all = count == arm.point_count() || all_but_base;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (elements[i].has("plate")) {
      points[i].plate = elements[i].at("plate").integer("a plate of the arm, 0 the base", 0, last);
    } else if (all) {
      points[i].plate = int(i) + int(all_but_base);
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

void read_space_mapping(const YamlReader& root, const ArmDescription& arm, ImportMapping& mapping) {
  if (root.has("backbone")) {
    read_space_backbone(root.at("backbone"), arm, mapping);
  }
  root.read_if_there("alignment", mapping.space_alignment, read_space_alignment);
  require_base(root, mapping);
}

}  // namespace limber
