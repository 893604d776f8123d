#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/arm/names.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/version.hpp"
#include "limber/world/plan.hpp"
#include "limber/world/straight_motion.hpp"

namespace limber {

namespace {

constexpr const char* kPlanSchema = "limber/plan/2";
constexpr double kCostToleranceKpa = 1e-6;
constexpr double kMax = 1e8;       // of a number in a plan; nothing real comes near, in Pa neither
constexpr double kMaxCost = 1e12;  // a sum over all frames

Json numbers(const Pressures& q) {
  // As the shortest decimal that reads back to the same float, not as a float widened to double.
  return mapped<Json>(q, [&](const float value) { return *number_in(fmt::format("{}", value)); });
}

Json poses(const Backbone& backbone) {
  return mapped<Json>(backbone.rows(),
                      [&](Eigen::Index i) { return numbers(backbone.row(i).transpose()); });
}

std::string lines(const Json& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + list[i].dump();
  }
  return text + "\n ]";
}

/// JSON that a person can read: a line a value, a waypoint and a frame.
std::string one_line_an_entry(const Json& head, const std::string& waypoints_key,
                              const Json& waypoints, const Json& frames) {
  std::string text = "{\n";
  for (const auto& [key, value] : head.items()) {
    text += fmt::format(" \"{}\": {},\n", key, value.dump());
  }
  text += fmt::format(" \"{}\": {},\n", waypoints_key, lines(waypoints));
  return text + fmt::format(" \"frames\": {}\n}}\n", lines(frames));
}

double number_at(const JsonReader& root, const char* key, double low = -kMax) {
  return root.at(key).number(low, kMax);
}

constexpr Eigen::Index kAnySize = -1;

Eigen::VectorXf read_vector(const JsonReader& field, Eigen::Index size, const std::string& what) {
  const std::vector<double> values = field.numbers(std::size_t(size), what.c_str(), -kMax, kMax);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()))
      .cast<float>();
}

Backbone read_backbone(const JsonReader& field, std::size_t point_count) {
  const std::vector<JsonReader> rows = field.elements("a list of poses [x_m, y_m, theta_rad]");
  field.refuse_if(rows.size() != point_count, "{} poses found; expected {}", rows.size(),
                  point_count);
  Backbone backbone(Eigen::Index(rows.size()), kPoseSize);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    backbone.row(Eigen::Index(i)) =
        read_vector(rows[i], kPoseSize, "numbers [x_m, y_m, theta_rad]").transpose();
  }
  return backbone;
}

/// "pressures in kPa", for messages.
std::string numbers_of(const Command& command) {
  return command.name + "s in " + command.unit;
}

/// What the arm is driven by; files of arms that are driven by pressures don't say so, nor did any
/// file of older programs.
Command read_command(const JsonReader& root) {
  Command command;
  if (root.has("command")) {
    command.name = root.at("command").at("name").text();
    command.unit = root.at("command").at("unit").text();
  }
  return command;
}

/// Only plans that were asked to stay within narrower limits than the arm's have any.
std::vector<PressureLimits> read_limits(const JsonReader& root, const Command& command) {
  const std::string key = quantity_key(command, "limits");
  std::vector<PressureLimits> limits;
  if (root.has(key.c_str())) {
    for (const JsonReader& pair : root.at(key.c_str()).elements("a list of [lower, upper]")) {
      const std::vector<double> ends = pair.numbers(2, "numbers [lower, upper]", -kMax, kMax);
      pair.refuse_if(ends[0] > ends[1], "[{}, {}] found; expected [lower, upper]", ends[0],
                     ends[1]);
      limits.emplace_back(ends[0], ends[1]);
    }
  }
  return limits;
}

std::vector<PlanFrame> read_frames(const JsonReader& field, const Command& command) {
  const std::vector<JsonReader> items = field.elements("a list of frames");
  field.refuse_if(items.empty(), "no frame found; expected at least the start");
  const std::string setpoint = quantity_key(command, "setpoint");
  const std::string followed = followed_key(command);
  const std::size_t segments =
      items.front().at(setpoint.c_str()).elements("a list of " + command.name + "s").size();
  const std::size_t points = items.front().at("backbone").elements("a list of poses").size();
  if (segments == 0 || points < 2) {
    items.front().refuse(fmt::format("{} {}s and {} poses found; expected at least 1 and 2",
                                     segments, command.name, points));
  }
  std::vector<PlanFrame> frames;
  for (const JsonReader& item : items) {
    item.refuse_unknown_keys({setpoint, followed, "backbone"});
    const auto commands = [&](const std::string& key) {
      return read_vector(item.at(key.c_str()), Eigen::Index(segments), numbers_of(command));
    };
    frames.push_back(
        {commands(setpoint), commands(followed), read_backbone(item.at("backbone"), points)});
  }
  return frames;
}

void require_consistent(const JsonReader& root, const Plan& plan) {
  const double cost = path_cost_kpa(plan.frames, &PlanFrame::setpoint_kpa);
  if (std::abs(cost - plan.cost_kpa) > kCostToleranceKpa * std::max(1.0, cost)) {
    root.at(quantity_key(plan.command, "cost").c_str())
        .refuse(fmt::format("{} found; its frames add up to {}", plan.cost_kpa, cost));
  }
  const std::size_t held = std::size_t(plan.hold_frame_count);
  if (held >= plan.frames.size()) {
    root.at("hold_frame_count")
        .refuse(
            fmt::format("{} found; expected less than the {} frames", held, plan.frames.size()));
  }
  for (std::size_t k = plan.frames.size() - held; k < plan.frames.size(); ++k) {
    if (plan.frames[k].setpoint_kpa != plan.frames[k - 1].setpoint_kpa) {
      root.at("frames").refuse(
          fmt::format("{} moves; the last {} frames should hold still", frame_name(k), held));
    }
  }
  if (plan.waypoints_kpa.size() < 1 ||
      plan.waypoints_kpa.front() != plan.frames.front().setpoint_kpa ||
      plan.waypoints_kpa.back() != plan.frames.back().setpoint_kpa) {
    root.at(quantity_key(plan.command, "waypoints").c_str())
        .refuse("expected the first and last frame's set points at its ends");
  }
}

/// Hash of everything in the file but the certificate itself; layout and order do not matter.
std::string seal_of(nlohmann::json root) {
  root.erase("certificate");
  return content_hash(root.dump());
}

double read_clearance(const JsonReader& field) {
  return field.is_null() ? std::numeric_limits<double>::infinity() : field.number(-kMax, kMax);
}

/// @param plates  of its frames
std::optional<PlanTube> read_tube(const JsonReader& root, Eigen::Index plates) {
  if (!root.has("tube")) {
    return std::nullopt;
  }
  const JsonReader field = root.at("tube");
  field.refuse_unknown_keys({"level", "plate_radius_m", "start_share", "full_after_m",
                             "end_radius_m", "end_heading_rad", "goal_inside"});
  PlanTube tube;
  tube.level = field.at("level").number(0.0, 1.0);
  if (tube.level == 0.0 || tube.level == 1.0) {
    field.at("level").refuse_found("expected a share between 0 and 1");
  }
  tube.plate_radius_m =
      field.at("plate_radius_m").numbers(std::size_t(plates), "lengths in metres", 0.0, kMax);
  tube.growth.start_share = field.at("start_share").number(0.0, 1.0);
  if (tube.growth.start_share == 0.0) {
    field.at("start_share").refuse_found("expected more than 0, and at most 1");
  }
  tube.growth.full_after_m = number_at(field, "full_after_m", 0.0);
  tube.end_radius_m = number_at(field, "end_radius_m", 0.0);
  tube.end_heading_rad = number_at(field, "end_heading_rad", 0.0);
  tube.goal_inside = field.at("goal_inside").boolean();
  return tube;
}

Json to_json(const PlanTube& tube) {
  return {{"level", tube.level},
          {"plate_radius_m", tube.plate_radius_m},
          {"start_share", tube.growth.start_share},
          {"full_after_m", tube.growth.full_after_m},
          {"end_radius_m", tube.end_radius_m},
          {"end_heading_rad", tube.end_heading_rad},
          {"goal_inside", tube.goal_inside}};
}

std::optional<CertifiedFigures> read_certificate(const JsonReader& root) {
  if (!root.has("certificate")) {
    return std::nullopt;
  }
  const JsonReader field = root.at("certificate");
  field.refuse_unknown_keys({"clearance_m", "largest_deviation_m", "seal"});
  CertifiedFigures figures;
  figures.clearance_m = read_clearance(field.at("clearance_m"));
  figures.max_deviation_m = number_at(field, "largest_deviation_m", 0.0);
  figures.seal_is_intact = field.at("seal").text() == seal_of(root.value());
  return figures;
}

void refuse_unknown_keys(const JsonReader& root) {
  const Command command = read_command(root);
  root.refuse_unknown_keys({"schema",
                            "program_version",
                            "arm",
                            "command",
                            "model",
                            "valves",
                            "environment",
                            "planner",
                            "seed",
                            "margin_m",
                            "tube",
                            "frame_rate_hz",
                            quantity_key(command, "limits"),
                            quantity_key(command, "cost"),
                            "clearance_m",
                            "goal_distance_m",
                            "goal_orientation_rad",
                            "hold_frame_count",
                            quantity_key(command, "waypoints"),
                            "frames",
                            "certificate"});
}

Plan read_fields(const JsonReader& root) {
  refuse_unknown_keys(root);
  Plan plan;
  plan.program_version = root.at("program_version").text();
  plan.arm_name = root.at("arm").at("name").text();
  plan.arm_hash = root.at("arm").at("hash").text();
  if (root.at("arm").has("description")) {
    plan.arm_description = root.at("arm").at("description").text();
  }
  plan.command = read_command(root);
  plan.model = root.at("model").at("kind").text();
  plan.model_hash = root.at("model").at("hash").text();
  if (root.at("model").has("e")) {
    plan.arm_of_family = read_vector(root.at("model").at("e"), kAnySize, "numbers");
  }
  if (plan.model != "no_load" && plan.model != "network") {
    root.at("model").at("kind").refuse_found("expected no_load or network");
  }
  plan.valves_hash = root.at("valves").at("hash").text();
  plan.environment_name = root.at("environment").at("name").text();
  plan.environment_hash = root.at("environment").at("hash").text();
  plan.planner = root.at("planner").text();
  plan.seed = root.at("seed").count(std::numeric_limits<std::uint64_t>::max());
  plan.margin_m = number_at(root, "margin_m", 0.0);
  plan.frame_rate_hz = root.at("frame_rate_hz").number(1.0, 1000.0);
  plan.cost_kpa = root.at(quantity_key(plan.command, "cost").c_str()).number(0.0, kMaxCost);
  plan.clearance_m = read_clearance(root.at("clearance_m"));
  plan.goal_distance_m = number_at(root, "goal_distance_m", 0.0);
  plan.goal_orientation_rad = number_at(root, "goal_orientation_rad", 0.0);
  plan.limits = read_limits(root, plan.command);
  plan.hold_frame_count = int(root.at("hold_frame_count").count(1000000));
  plan.frames = read_frames(root.at("frames"), plan.command);
  plan.tube = read_tube(root, plan.frames.front().backbone.rows());
  const Eigen::Index segments = plan.frames.front().setpoint_kpa.size();
  const std::string waypoints = quantity_key(plan.command, "waypoints");
  for (const JsonReader& point : root.at(waypoints.c_str()).elements("a list of configurations")) {
    plan.waypoints_kpa.push_back(read_vector(point, segments, numbers_of(plan.command)));
  }
  return plan;
}

Plan read_root(const JsonReader& root) {
  root.require_schema(kPlanSchema);
  Plan plan = read_fields(root);
  plan.certified = read_certificate(root);
  return plan;
}

}  // namespace

void write_plan(const fs::path& path, const Plan& plan) {
  Json root;
  root["schema"] = kPlanSchema;
  root["program_version"] = plan.program_version.empty() ? version() : plan.program_version;
  root["arm"] = {{"name", plan.arm_name}, {"hash", plan.arm_hash}};
  if (!plan.arm_description.empty()) {
    root["arm"]["description"] = plan.arm_description;
  }
  if (!plan.command.is_pressure_kpa()) {
    root["command"] = {{"name", plan.command.name}, {"unit", plan.command.unit}};
  }
  root["model"] = {{"kind", plan.model}, {"hash", plan.model_hash}};
  if (plan.arm_of_family.size() > 0) {
    root["model"]["e"] = numbers(plan.arm_of_family);
  }
  root["valves"] = {{"hash", plan.valves_hash}};
  root["environment"] = {{"name", plan.environment_name}, {"hash", plan.environment_hash}};
  root["planner"] = plan.planner;
  root["seed"] = plan.seed;
  root["margin_m"] = plan.margin_m;
  if (plan.tube) {
    root["tube"] = to_json(*plan.tube);
  }
  root["frame_rate_hz"] = plan.frame_rate_hz;
  for (const PressureLimits& limits : plan.limits) {
    root[quantity_key(plan.command, "limits")].push_back({limits.lower_kpa, limits.upper_kpa});
  }
  root[quantity_key(plan.command, "cost")] = plan.cost_kpa;
  root["clearance_m"] = json_number(plan.clearance_m);
  root["goal_distance_m"] = plan.goal_distance_m;
  root["goal_orientation_rad"] = plan.goal_orientation_rad;
  root["hold_frame_count"] = plan.hold_frame_count;
  const Json waypoints =
      mapped<Json>(plan.waypoints_kpa, [&](const Pressures& q) { return numbers(q); });
  const Json frames = mapped<Json>(plan.frames, [&](const PlanFrame& frame) {
    return Json{{quantity_key(plan.command, "setpoint"), numbers(frame.setpoint_kpa)},
                {followed_key(plan.command), numbers(frame.pressure_kpa)},
                {"backbone", poses(frame.backbone)}};
  });
  const std::string waypoints_key = quantity_key(plan.command, "waypoints");
  if (plan.certified) {
    Json sealed = root;
    sealed[waypoints_key] = waypoints;
    sealed["frames"] = frames;
    root["certificate"] = {{"clearance_m", json_number(plan.certified->clearance_m)},
                           {"largest_deviation_m", plan.certified->max_deviation_m},
                           {"seal", plan.certified->seal_is_intact ? seal_of(sealed) : "broken"}};
  }
  write_file_atomically(path, one_line_an_entry(root, waypoints_key, waypoints, frames));
}

Plan read_plan(const fs::path& path) {
  const nlohmann::json root = read_json_object(path);
  const JsonReader fields(root, path.string());
  Plan plan = read_root(fields);
  require_consistent(fields, plan);
  if (plan.certified && !plan.certified->seal_is_intact) {
    fields.at("certificate")
        .refuse(
            "the plan was changed since it was certified; 'limber verify' says whether it "
            "still holds: plan again, or remove the key 'certificate' to use it anyway");
  }
  return plan;
}

Plan read_plan_unchecked(const fs::path& path) {
  const nlohmann::json root = read_json_object(path);
  return read_root(JsonReader(root, path.string()));
}

void write_backbones_csv(const fs::path& path, const Plan& plan) {
  std::string text = "time_s";
  const Eigen::Index m = plan.frames.empty() ? 0 : plan.frames.front().backbone.rows();
  for (Eigen::Index p = 0; p < m; ++p) {
    text += fmt::format(",x_{0}_m,y_{0}_m,theta_{0}_rad", p);
  }
  text += '\n';
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    text += fmt::format("{}", double(k) / plan.frame_rate_hz);
    for (const auto& pose : plan.frames[k].backbone.rowwise()) {
      text += fmt::format(",{},{},{}", pose[0], pose[1], pose[2]);
    }
    text += '\n';
  }
  write_file_atomically(path, text);
}

}  // namespace limber
