#include "spread_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/json.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

Json to_json(const MemberFigures& figures) {
  return {{"min", kCmPerM * figures.min_m},
          {"max", kCmPerM * figures.max_m},
          {"mean", kCmPerM * figures.mean_m},
          {"std", kCmPerM * figures.standard_deviation_m}};
}

Json to_json(const SpreadAt& at) {
  return {{"frame", at.frame},
          {"plate", at.plate},
          {"largest_distance_cm", kCmPerM * at.largest_distance_m},
          {"std_cm", kCmPerM * at.standard_deviation_m}};
}

}  // namespace

Json to_json(const PlanSpread& spread) {
  Json json;
  json["members"] = spread.members;
  json["end"] = to_json(spread.end);
  json["end"]["distance_to_goal_cm"] = to_json(spread.goal_distance);
  json["closest_approach"] = nullptr;
  if (spread.closest) {
    json["closest_approach"] = to_json(spread.closest->at);
    json["closest_approach"]["obstacle"] = spread.closest->obstacle;
    json["closest_approach"]["clearance_cm"] = to_json(spread.closest->clearance);
  }
  return json;
}

std::string to_text(const PlanSpread& spread, const std::string& whose, const ArmDescription& arm,
                    const Environment& environment) {
  std::string text = fmt::format(
      "the {} networks of {}, each by itself, put the end {:.2f} "
      "to {:.2f} cm from the goal, {} up to {:.2f} cm apart",
      spread.members, whose, kCmPerM * spread.goal_distance.min_m,
      kCmPerM * spread.goal_distance.max_m, plate_name(spread.end.plate),
      kCmPerM * spread.end.largest_distance_m);
  if (spread.closest) {
    const PlanSpread::Closest& closest = *spread.closest;
    text += fmt::format(
        "; they keep {:.2f} to {:.2f} cm from obstacles. Where the plan comes nearest to one "
        "({}, {}, {}), {} is up to {:.2f} cm apart",
        kCmPerM * closest.clearance.min_m, kCmPerM * closest.clearance.max_m,
        frame_name(closest.at.frame), gap_name(arm, closest.gap),
        obstacle_name(environment, closest.obstacle), plate_name(closest.at.plate),
        kCmPerM * closest.at.largest_distance_m);
  }
  return text;
}

}  // namespace limber
