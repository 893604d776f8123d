#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/units.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/network/prediction_error.hpp"

namespace limber {

namespace {

constexpr int kMaxTubeRuns = 1'000'000'000;
constexpr double kSameLevel = 1e-9;

[[noreturn]] void refuse_tube(const std::string& where, const std::string& what) {
  throw InputError(fmt::format("{}: tube.{}", where, what));
}

void require_scale(const std::string& where, const std::string& name, double value) {
  if (!std::isfinite(value) || value <= 0.0) {
    refuse_tube(where, fmt::format("{} is {}; expected a finite number, > 0", name, value));
  }
}

void require_share(const std::string& where, const std::string& name, double value) {
  if (!(value > 0.0 && value < 1.0)) {
    refuse_tube(where, fmt::format("{} is {}; expected a share between 0 and 1", name, value));
  }
}

void require_counts(const std::string& where, const std::string& name, int outside, int runs) {
  if (outside < 0 || runs < 0 || outside > runs) {
    refuse_tube(where, fmt::format("{}: {} of {} runs outside; expected 0 to {}", name, outside,
                                   runs, std::max(runs, 0)));
  }
}

Json to_json(const TubeLevel& level) {
  return {{"level", level.level},
          {"factor", level.factor},
          {"runs", level.runs},
          {"outside", level.outside},
          {"confidence", level.confidence},
          {"audit_runs", level.audit_runs},
          {"audit_outside", level.audit_outside}};
}

TubeLevel read_level(const YamlReader& root) {
  root.refuse_unknown_keys(
      {"level", "factor", "runs", "outside", "confidence", "audit_runs", "audit_outside"});
  TubeLevel level;
  level.level = root.at("level").positive("a share of runs");
  level.factor = root.at("factor").positive("a factor");
  level.runs = root.at("runs").integer("a number of runs", 0, kMaxTubeRuns);
  level.outside = root.at("outside").integer("a number of runs", 0, kMaxTubeRuns);
  level.confidence = root.at("confidence").positive("a confidence");
  level.audit_runs = root.at("audit_runs").integer("a number of runs", 0, kMaxTubeRuns);
  level.audit_outside = root.at("audit_outside").integer("a number of runs", 0, kMaxTubeRuns);
  return level;
}

std::string audit_to_text(const TubeLevel& level) {
  return level.audit_runs == 0 ? std::string()
                               : fmt::format("; audit: {:.2f} % of {} runs inside",
                                             100.0 - 100.0 * level.audit_outside / level.audit_runs,
                                             level.audit_runs);
}

void validate_shape(const Tube& tube, const std::string& where) {
  for (std::size_t i = 0; i < tube.plate_scale_m.size(); ++i) {
    require_scale(where, fmt::format("plate_scale_m[{}]", i), tube.plate_scale_m[i]);
  }
  require_scale(where, "end_scale_m", tube.end_scale_m);
  require_scale(where, "end_heading_scale_rad", tube.end_heading_scale_rad);
  const RoomGrowth& growth = tube.growth;
  if (!(growth.start_share > 0.0 && growth.start_share <= 1.0)) {
    refuse_tube(where, fmt::format("start_share is {}; expected more than 0 and at most 1",
                                   growth.start_share));
  }
  if (!(std::isfinite(growth.full_after_m) && growth.full_after_m >= 0.0)) {
    refuse_tube(where, fmt::format("full_after_m is {}; expected a finite number, at least 0",
                                   growth.full_after_m));
  }
}

}  // namespace

const TubeLevel* Tube::find(double level) const {
  const auto found = std::find_if(levels.begin(), levels.end(), [&](const TubeLevel& one) {
    return std::abs(one.level - level) < kSameLevel;
  });
  return found == levels.end() ? nullptr : &*found;
}

const TubeLevel& Tube::default_level() const {
  const TubeLevel* best = &levels.front();
  for (const TubeLevel& one : levels) {
    if (one.level < kDefaultLevel + kSameLevel) {
      best = &one;
    }
  }
  return *best;
}

void validate(const Tube& tube, const std::string& where) {
  for (const auto& [name, is_empty] : {std::pair{"plate_scale_m", tube.plate_scale_m.empty()},
                                       std::pair{"levels", tube.levels.empty()}}) {
    if (is_empty) {
      refuse_tube(where, fmt::format("{} is empty; expected at least one entry", name));
    }
  }
  validate_shape(tube, where);
  double last = 0.0;
  for (std::size_t i = 0; i < tube.levels.size(); ++i) {
    const TubeLevel& level = tube.levels[i];
    const std::string name = fmt::format("levels[{}]", i);
    require_share(where, name + ".level", level.level);
    require_share(where, name + ".confidence", level.confidence);
    require_scale(where, name + ".factor", level.factor);
    require_counts(where, name, level.outside, level.runs);
    require_counts(where, name + ".audit", level.audit_outside, level.audit_runs);
    if (level.level <= last) {
      refuse_tube(where, fmt::format("{}.level is {}, after {}; expected rising levels", name,
                                     level.level, last));
    }
    last = level.level;
  }
}

std::string tube_to_metadata(const Tube& tube) {
  const auto levels =
      mapped<Json>(tube.levels, [&](const TubeLevel& level) { return to_json(level); });
  return Json({{"plate_scale_m", tube.plate_scale_m},
               {"end_scale_m", tube.end_scale_m},
               {"end_heading_scale_rad", tube.end_heading_scale_rad},
               {"start_share", tube.growth.start_share},
               {"full_after_m", tube.growth.full_after_m},
               {"source", tube.source},
               {"levels", levels}})
      .dump();
}

Tube read_tube(const YamlReader& root) {
  root.refuse_unknown_keys({"plate_scale_m", "end_scale_m", "end_heading_scale_rad", "start_share",
                            "full_after_m", "source", "levels"});
  Tube tube;
  tube.plate_scale_m = root.at("plate_scale_m").numbers("lengths in metres");
  tube.end_scale_m = root.at("end_scale_m").positive("a length in metres");
  tube.end_heading_scale_rad = root.at("end_heading_scale_rad").positive("an angle in radians");
  tube.growth.start_share = root.at("start_share").positive("a share");
  tube.growth.full_after_m = root.at("full_after_m").number("a length in metres", 0.0);
  tube.source = root.at("source").text();
  for (const YamlReader& level : root.at("levels").elements()) {
    tube.levels.push_back(read_level(level));
  }
  return tube;
}

Json to_json(const Tube& tube) {
  Json json = Json::parse(tube_to_metadata(tube));
  for (std::size_t i = 0; i < tube.levels.size(); ++i) {
    const double factor = tube.levels[i].factor;
    json["levels"][i]["tip_radius_cm"] = kCmPerM * factor * tube.plate_scale_m.back();
    json["levels"][i]["end_radius_cm"] = kCmPerM * factor * tube.end_scale_m;
    json["levels"][i]["end_heading_rad"] = factor * tube.end_heading_scale_rad;
  }
  return json;
}

std::string to_text(const Tube& tube) {
  std::string text;
  for (const TubeLevel& level : tube.levels) {
    text += fmt::format(
        "{}tube of {:.4g} % of runs: {:.2f} cm at the tip, {:.2f} cm and {:.3f} rad after the "
        "hold; {} of {} runs outside, {} ({:.4g} % sure){}",
        text.empty() ? "" : "\n  ", 100.0 * level.level,
        kCmPerM * level.factor * tube.plate_scale_m.back(),
        kCmPerM * level.factor * tube.end_scale_m, level.factor * tube.end_heading_scale_rad,
        level.outside, level.runs, tube.source, 100.0 * level.confidence, audit_to_text(level));
  }
  return text;
}

std::string names_of_levels(const Tube& tube) {
  std::string names;
  for (const TubeLevel& level : tube.levels) {
    names += fmt::format("{}{:.6g}", names.empty() ? "" : ", ", level.level);
  }
  return names;
}

}  // namespace limber
