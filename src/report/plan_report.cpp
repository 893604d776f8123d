#include "limber/report/plan_report.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/units.hpp"

namespace limber {

namespace {

Json to_json(const std::optional<Plan>& partial, const PoseGoal& goal) {
  if (!partial) {
    return nullptr;
  }
  Json json;
  json["distance_to_goal_cm"] = partial->goal_distance_m * kCmPerM;
  json["orientation_to_goal_rad"] = goal.theta_rad ? Json(partial->goal_orientation_rad) : nullptr;
  json[quantity_key(partial->command, "cost")] = partial->cost_kpa;
  json["frames"] = partial->frame_count();
  return json;
}

Json to_json(const PlanTube& tube) {
  return {{"level", tube.level},
          {"tip_radius_cm", tube.plate_radius_m.back() * kCmPerM},
          {"end_radius_cm", tube.end_radius_m * kCmPerM},
          {"end_heading_rad", tube.end_heading_rad},
          {"goal_inside", tube.goal_inside}};
}

std::string tube_note(const std::optional<PlanTube>& tube) {
  return tube ? fmt::format(
                    "\nkeeps the tube of {:.4g} % of runs free, "
                    "{:.2f} cm wide at the tip; the goal {} its end",
                    100.0 * tube->level, tube->plate_radius_m.back() * kCmPerM,
                    tube->goal_inside ? "holds" : "is too small for")
              : "";
}

/// Of a plan; without obstacles it is infinite.
std::string clearance_text(double clearance_m, int digits) {
  return std::isfinite(clearance_m)
             ? fmt::format("clearance {:.{}f} cm", clearance_m * kCmPerM, digits)
             : "no obstacles";
}

}  // namespace

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
    const std::size_t count = certificate.failures.size();
    return text + fmt::format("not certified: {} {} as above; {} frames in all", count,
                              count == 1 ? "failure" : "failures", certificate.frames);
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

Json to_json(const PlanResult& result, const Command& command, const PoseGoal& goal,
             const std::string& planner, const std::string& model, std::uint64_t seed) {
  Json json;
  json["status"] = to_string(result.status);
  json["reason"] = result.reason;
  json["warnings"] = result.warnings;
  json["limit"] = result.limit ? Json(to_string(*result.limit)) : Json(nullptr);
  json["best_partial"] = to_json(result.best_partial, goal);
  json["planner"] = planner;
  json["model"] = model;
  json["seed"] = seed;
  const Plan* plan = result.plan ? &*result.plan : nullptr;
  const std::string cost = quantity_key(command, "cost");
  json[cost] = plan ? Json(plan->cost_kpa) : nullptr;
  if (command.is_pressure_kpa()) {
    json["cost_psi"] = plan ? Json(plan->cost_kpa / kKpaPerPsi) : nullptr;
  }
  const FirstSolution* first = result.first_solution ? &*result.first_solution : nullptr;
  json["first_solution"] = nullptr;
  if (first) {
    json["first_solution"] = {
        {"time_s", first->time_s}, {cost, first->cost_kpa}, {"queries", first->queries}};
  }
  json["first_candidate_s"] = first ? Json(first->candidate_s) : nullptr;
  json["first_certificate_s"] = first ? Json(first->certificate_s) : nullptr;
  json["time_s"] = result.statistics.time_s;
  json["iterations"] = result.statistics.iterations;
  json["queries"] = result.statistics.queries;
  json["nodes"] = result.statistics.nodes;
  json["rewires_tried"] = result.statistics.rewires_tried;
  json["rewires_accepted"] = result.statistics.rewires_accepted;
  json["distance_to_goal_cm"] = plan ? Json(plan->goal_distance_m * kCmPerM) : nullptr;
  json["orientation_to_goal_rad"] =
      plan && goal.theta_rad ? Json(plan->goal_orientation_rad) : nullptr;
  json["clearance_cm"] = plan ? json_number(plan->clearance_m * kCmPerM) : nullptr;
  json["tube"] = plan && plan->tube ? to_json(*plan->tube) : Json(nullptr);
  json["frames"] = plan ? Json(plan->frame_count()) : nullptr;
  for (std::size_t i = 0; plan && i < plan->limits.size(); ++i) {
    json[quantity_key(command, "limits")].push_back(to_json(plan->limits[i]));
  }
  json["largest_clearance_cm"] =
      result.max_clearance_m ? json_number(*result.max_clearance_m * kCmPerM) : nullptr;
  json["certificate"] = nullptr;
  if (result.certificate) {
    json["certificate"] = {
        {"certified", result.certificate->certified()},
        {"clearance_cm", json_number(result.certificate->clearance_m * kCmPerM)},
        {"largest_deviation_m", json_number(result.certificate->max_deviation_m)}};
  }
  json["events"] = Json::array();
  for (const PlannerProgress& event : result.events) {
    json["events"].push_back({{"time_s", event.time_s},
                              {"queries", event.queries},
                              {"nodes", event.nodes},
                              {"best_" + cost, *event.best_cost_kpa}});
  }
  json["duration_s"] = plan ? Json(plan->duration_s()) : nullptr;
  return json;
}

std::string to_text(const PlanResult& result, const Command& command) {
  if (!result.plan) {
    return fmt::format("no plan: {}: {}", to_string(result.status), result.reason);
  }
  const Plan& plan = *result.plan;
  std::string certified;
  if (plan.certified) {
    certified = fmt::format("\ncertified: plates within {:.2g} mm of an independent simulation, {}",
                            plan.certified->max_deviation_m * 1e3,
                            clearance_text(plan.certified->clearance_m, 3));
  }
  const std::string psi =
      command.is_pressure_kpa() ? fmt::format(" ({:.1f} psi)", plan.cost_kpa / kKpaPerPsi) : "";
  return fmt::format(
             "plan: {} frames, {:.1f} s, cost {:.1f} {}{}; ends {:.2f} cm from the goal, {}, "
             "as the {} model predicts; seed {}\n"
             "first certified plan after {:.4f} s, {:.4f} s of them for its certificate ({:.1f} "
             "{}); {} nodes, {} rewires of {} tried, {} model queries in {:.2f} s ({:.0f} per "
             "second); {}",
             plan.frame_count(), plan.duration_s(), plan.cost_kpa, command.unit, psi,
             plan.goal_distance_m * kCmPerM, clearance_text(plan.clearance_m, 2), plan.model,
             plan.seed, result.first_solution->time_s, result.first_solution->certificate_s,
             result.first_solution->cost_kpa, command.unit, result.statistics.nodes,
             result.statistics.rewires_accepted, result.statistics.rewires_tried,
             result.statistics.queries, result.statistics.time_s,
             double(result.statistics.queries) / result.statistics.time_s, result.reason) +
         certified + tube_note(plan.tube);
}

}  // namespace limber
