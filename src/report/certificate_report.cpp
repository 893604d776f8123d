#include "limber/report/plan_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"

namespace limber {

using Json = nlohmann::ordered_json;

Json to_json(const Certificate& certificate, const Command& command,
             const Environment& environment) {
  Json json;
  json["status"] = certificate.certified() ? "certified" : "refused";
  json["failures"] = Json::array();
  for (const CertificateFailure& failure : certificate.failures) {
    json["failures"].push_back({{"check", failure.check},
                                {"frame", failure.frame >= 0 ? Json(failure.frame) : Json(nullptr)},
                                {"message", failure.message}});
  }
  json["frames"] = certificate.frames;
  json["clearance_cm"] = json_number(certificate.clearance_m * kCmPerM);
  json["clearance_frame"] =
      certificate.clearance_frame >= 0 ? Json(certificate.clearance_frame) : Json(nullptr);
  json["largest_deviation_m"] = json_number(certificate.max_deviation_m);
  json["largest_step_deviation_m"] = json_number(certificate.max_step_deviation_m);
  json["largest_heading_deviation_rad"] = json_number(certificate.max_heading_deviation_rad);
  json[command.is_pressure_kpa() ? "largest_pressure_deviation_kpa" : "largest_command_deviation"] =
      json_number(certificate.max_pressure_deviation_kpa);
  json[quantity_key(command, "cost")] = certificate.cost_kpa;
  json[quantity_key(command, "largest_step")] = certificate.max_step_kpa;
  json["distance_to_goal_cm"] = json_number(certificate.goal_distance_m * kCmPerM);
  json["orientation_to_goal_rad"] =
      environment.goal.theta_rad ? json_number(certificate.goal_orientation_rad) : Json(nullptr);
  return json;
}

std::string to_text(const Certificate& certificate, const ArmDescription& arm,
                    const Environment& environment) {
  std::string text;
  for (const CertificateFailure& failure : certificate.failures) {
    text += failure.frame >= 0 ? fmt::format("refused: {}: {}: {}\n", failure.check,
                                             frame_name(failure.frame), failure.message)
                               : fmt::format("refused: {}: {}\n", failure.check, failure.message);
  }
  if (!certificate.certified()) {
    return text + fmt::format("not certified: {} of {} frames' checks failed as above",
                              certificate.failures.size(), certificate.frames);
  }
  const std::string where =
      certificate.clearance_obstacle < 0
          ? "no obstacles"
          : fmt::format("clearance {:.3f} cm ({}, {}, {})", certificate.clearance_m * kCmPerM,
                        frame_name(certificate.clearance_frame),
                        segment_name(arm.segment_of_gap(certificate.clearance_gap)),
                        obstacle_name(environment, certificate.clearance_obstacle));
  const std::string heading = environment.goal.theta_rad
                                  ? fmt::format(" and {:.3f} rad", certificate.goal_orientation_rad)
                                  : "";
  return fmt::format(
      "certified: {} frames; {}; plates within {:.2g} mm of an independent simulation; ends {:.3f} "
      "cm{} from the goal; cost {:.2f} {unit}, at most {:.3g} {unit} per frame",
      certificate.frames, where, certificate.max_deviation_m * 1e3,
      certificate.goal_distance_m * kCmPerM, heading, certificate.cost_kpa,
      certificate.max_step_kpa, fmt::arg("unit", arm.command.unit));
}

}  // namespace limber
