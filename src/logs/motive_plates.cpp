#include "motive_plates.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/error.hpp"

namespace limber {

namespace {

/// Measured or solved, by what is asked for.
bool is_body(const MotiveObject& object) {
  return object.type == "Rigid Body" || object.type == "Bone";
}
bool is_measured_marker(const MotiveObject& object) {
  return object.type.ends_with("Marker") && !is_body(object) &&
         object.type != "Rigid Body Marker" && object.type != "Bone Marker";
}
bool is_solved_marker(const MotiveObject& object) {
  return object.type == "Rigid Body Marker" || object.type == "Bone Marker";
}

/// "Plate 9" before "Plate 10".
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const bool digits = std::isdigit(static_cast<unsigned char>(a[i])) != 0 &&
                        std::isdigit(static_cast<unsigned char>(b[j])) != 0;
    if (!digits) {
      if (a[i] != b[j]) {
        return a[i] < b[j];
      }
      ++i;
      ++j;
      continue;
    }
    const auto number = [](const std::string& text, std::size_t& index) {
      double value = 0.0;
      while (index < text.size() && std::isdigit(static_cast<unsigned char>(text[index])) != 0) {
        value = 10.0 * value + (text[index++] - '0');
      }
      return value;
    };
    const double x = number(a, i);
    const double y = number(b, j);
    if (x != y) {
      return x < y;
    }
  }
  return a.size() - i < b.size() - j;
}

}  // namespace

template <class Kind>
const MotiveObject* PlateFinder::find(const std::string& name, Kind is_kind) const {
  const MotiveObject* found = nullptr;
  for (const MotiveObject& object : take_.objects) {
    if (!is_kind(object)) {
      continue;
    }
    if (object.name == name) {
      return &object;
    }
    // "Asset:Marker1" may be called "Marker1" where that is unambiguous.
    const std::size_t colon = object.name.rfind(':');
    if (colon != std::string::npos && object.name.substr(colon + 1) == name) {
      if (found != nullptr) {
        throw InputError(fmt::format("{}: '{}' could be '{}' or '{}'; give the whole name", log_,
                                     name, found->name, object.name));
      }
      found = &object;
    }
  }
  return found;
}

template <class Kind>
void PlateFinder::refuse_missing(const char* what, const std::string& name, Kind is_kind) const {
  std::vector<std::string> names;
  for (const MotiveObject& object : take_.objects) {
    if (is_kind(object)) {
      names.push_back(object.name);
    }
  }
  throw InputError(
      fmt::format("{}: there is no {} '{}'; the file has: {}", log_, what, name,
                  names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, ", "))));
}

std::vector<PointSource> PlateFinder::default_points(const ArmDescription& arm) const {
  for (const bool bodies : {true, false}) {
    std::vector<std::string> names;
    for (const MotiveObject& object : take_.objects) {
      if (bodies ? is_body(object) : is_measured_marker(object)) {
        names.push_back(object.name);
      }
    }
    if (names.empty()) {
      continue;
    }
    if (std::ssize(names) != arm.point_count()) {
      throw InputError(fmt::format(
          "{}: {} {} found ({}); arm '{}' has {} plates. Say in a mapping (--mapping) which is "
          "which: 'backbone: {{points: [{{plate: 0, {}: NAME}}, …]}}'",
          log_, names.size(), bodies ? "rigid bodies" : "markers", fmt::join(names, ", "), arm.name,
          arm.point_count(), bodies ? "body" : "marker"));
    }
    std::sort(names.begin(), names.end(), natural_less);
    std::vector<PointSource> points(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      points[i].plate = static_cast<int>(i);
      (bodies ? points[i].body : points[i].marker) = names[i];
    }
    report_.note("no mapping of plates: taken in the order of their names",
                 fmt::format("base '{}', end '{}'", names.front(), names.back()),
                 std::ssize(names));
    return points;
  }
  throw InputError(fmt::format("{}: no rigid bodies and no measured markers in it", log_));
}

const MotiveObject& PlateFinder::body(const std::string& name) const {
  const MotiveObject* found = find(name, is_body);
  if (found == nullptr) {
    refuse_missing("rigid body", name, is_body);
  }
  return *found;
}

const MotiveObject& PlateFinder::marker(const std::string& name) const {
  if (const MotiveObject* found = find(name, is_measured_marker)) {
    return *found;
  }
  const MotiveObject* solved = find(name, is_solved_marker);
  if (solved == nullptr) {
    refuse_missing("marker", name, [](const MotiveObject& o) { return !is_body(o); });
  }
  report_.note(
      "markers whose measured positions are not in the file: solved ones used, which go "
      "on while a marker is hidden",
      fmt::format("'{}'", name));
  return *solved;
}

}  // namespace limber
