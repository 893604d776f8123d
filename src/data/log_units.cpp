#include "limber/data/log_units.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "limber/common/units.hpp"

namespace limber {

namespace {

struct Unit {
  const char* name;
  char kind;
  double size;  // in the kind's first unit
};

constexpr Unit kUnits[] = {{"m", 'l', 1.0},     {"cm", 'l', 1e-2},  {"mm", 'l', 1e-3},
                           {"in", 'l', 0.0254}, {"rad", 'a', 1.0},  {"deg", 'a', kRadPerDeg},
                           {"s", 't', 1.0},     {"ms", 't', 1e-3},  {"us", 't', 1e-6},
                           {"ns", 't', 1e-9},   {"min", 't', 60.0}, {"kPa", 'p', 1.0},
                           {"Pa", 'p', 1e-3},   {"mbar", 'p', 0.1}, {"hPa", 'p', 0.1},
                           {"bar", 'p', 100.0}, {"MPa", 'p', 1e3},  {"psi", 'p', kKpaPerPsi}};
constexpr double kLogRatioTolerance = 0.34;  // a factor of 1.4 either way

const Unit* find(const std::string& name) {
  const Unit* found = std::ranges::find(kUnits, name, &Unit::name);
  return found == std::end(kUnits) ? nullptr : found;
}

}  // namespace

std::optional<double> unit_factor(const std::string& from, const std::string& to) {
  if (from == to) {
    return 1.0;
  }
  const Unit* a = find(from);
  const Unit* b = find(to);
  if (a == nullptr || b == nullptr || a->kind != b->kind) {
    return std::nullopt;
  }
  return a->size / b->size;
}

std::string unit_suspicion(double ratio, const std::string& unit) {
  const Unit* given = find(unit);
  if (given == nullptr || !(ratio > 0.0)) {
    return {};
  }
  const Unit* best = nullptr;
  double min_mismatch = kLogRatioTolerance;
  for (const Unit& other : kUnits) {
    const double mismatch = std::abs(std::log(ratio * other.size / given->size));
    if (other.kind == given->kind && mismatch < min_mismatch) {
      best = &other;
      min_mismatch = mismatch;
    }
  }
  const bool as_given = best == nullptr || best->size == given->size;
  return as_given ? std::string() : fmt::format("is it in {}?", best->name);
}

}  // namespace limber
