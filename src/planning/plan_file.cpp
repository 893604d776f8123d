#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/version.hpp"
#include "limber/planning/plan.hpp"

namespace limber {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "limber/plan/1";
constexpr double kCostToleranceKpa = 1e-6;
constexpr double kLargest = 1e6;  // of any number in a plan; nothing real comes near

Json numbers(const Pressures& q) {
  // As the shortest decimal that reads back to the same float, not as a float widened to double.
  Json list = Json::array();
  for (const float value : q) {
    list.push_back(std::stod(fmt::format("{}", value)));
  }
  return list;
}

Json poses(const Backbone& backbone) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < backbone.rows(); ++i) {
    rows.push_back(numbers(backbone.row(i).transpose()));
  }
  return rows;
}

std::string lines(const Json& list) {
  std::string text = "[";
  for (std::size_t i = 0; i < list.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + list[i].dump();
  }
  return text + "\n ]";
}

/// JSON that a person can read: a line a value, a waypoint and a frame.
std::string one_line_an_entry(const Json& head, const Json& waypoints, const Json& frames) {
  std::string text = "{\n";
  for (const auto& [key, value] : head.items()) {
    text += fmt::format(" \"{}\": {},\n", key, value.dump());
  }
  text += fmt::format(" \"waypoints_kpa\": {},\n", lines(waypoints));
  return text + fmt::format(" \"frames\": {}\n}}\n", lines(frames));
}

/// A value of the file with the name of its place, for messages.
class Field {
 public:
  Field(const Json& value, std::string file, std::string name)
      : value_(value), file_(std::move(file)), name_(std::move(name)) {}

  [[noreturn]] void refuse(const std::string& message) const {
    throw InputError(fmt::format("{}: {}: {}", file_, name_, message));
  }

  Field at(const char* key) const {
    if (!value_.is_object() || !value_.contains(key)) {
      throw InputError(
          fmt::format("{}: {}{}: missing", file_, name_.empty() ? "" : name_ + ".", key));
    }
    return {value_.at(key), file_, name_.empty() ? key : name_ + "." + key};
  }

  std::vector<Field> elements(const std::string& expected) const {
    if (!value_.is_array()) {
      refuse(fmt::format("{} found; expected {}", value_.type_name(), expected));
    }
    std::vector<Field> result;
    for (std::size_t i = 0; i < value_.size(); ++i) {
      result.emplace_back(value_[i], file_, fmt::format("{}[{}]", name_, i));
    }
    return result;
  }

  std::string text() const {
    if (!value_.is_string()) {
      refuse(fmt::format("{} found; expected a text", value_.dump()));
    }
    return value_.get<std::string>();
  }

  double number(double low = -kLargest, double high = kLargest) const {
    if (!value_.is_number()) {
      refuse(fmt::format("{} found; expected a finite number", shortened()));
    }
    const double value = value_.get<double>();
    if (!(value >= low && value <= high)) {
      refuse(fmt::format("{} found; expected a number from {} to {}", value, low, high));
    }
    return value;
  }

  std::uint64_t count(std::uint64_t most) const {
    if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > most) {
      refuse(fmt::format("{} found; expected a whole number from 0 to {}", shortened(), most));
    }
    return value_.get<std::uint64_t>();
  }

  bool is_null() const { return value_.is_null(); }

  Pressures vector(Eigen::Index size, const char* what) const {
    const std::vector<Field> items = elements(fmt::format("a list of {}", what));
    if (static_cast<Eigen::Index>(items.size()) != size) {
      refuse(fmt::format("{} numbers found; expected {} {}", items.size(), size, what));
    }
    Pressures result(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      result[i] = static_cast<float>(items[static_cast<std::size_t>(i)].number());
    }
    return result;
  }

 private:
  std::string shortened() const {
    const std::string text = value_.dump();
    return text.size() <= 40 ? text : text.substr(0, 40) + "…";
  }

  const Json& value_;
  std::string file_;
  std::string name_;
};

Backbone read_backbone(const Field& field, std::size_t point_count) {
  const std::vector<Field> rows = field.elements("a list of poses [x_m, y_m, theta_rad]");
  if (rows.size() != point_count) {
    field.refuse(fmt::format("{} poses found; expected {}", rows.size(), point_count));
  }
  Backbone backbone(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    backbone.row(static_cast<Eigen::Index>(i)) =
        rows[i].vector(3, "numbers [x_m, y_m, theta_rad]").transpose();
  }
  return backbone;
}

std::vector<PlanFrame> read_frames(const Field& field) {
  const std::vector<Field> items = field.elements("a list of frames");
  if (items.empty()) {
    field.refuse("no frame found; expected at least the start");
  }
  const std::size_t segments =
      items.front().at("setpoint_kpa").elements("a list of pressures").size();
  const std::size_t points = items.front().at("backbone").elements("a list of poses").size();
  if (segments == 0 || points < 2) {
    items.front().refuse(fmt::format("{} pressures and {} poses found; expected at least 1 and 2",
                                     segments, points));
  }
  std::vector<PlanFrame> frames;
  for (const Field& item : items) {
    frames.push_back(
        {item.at("setpoint_kpa").vector(static_cast<Eigen::Index>(segments), "pressures in kPa"),
         read_backbone(item.at("backbone"), points)});
  }
  return frames;
}

void require_consistent(const Field& root, const Plan& plan) {
  const double cost = path_cost_kpa(plan.frames);
  if (std::abs(cost - plan.cost_kpa) > kCostToleranceKpa * std::max(1.0, cost)) {
    root.at("cost_kpa")
        .refuse(fmt::format("{} found; its frames add up to {}", plan.cost_kpa, cost));
  }
  const std::size_t held = static_cast<std::size_t>(plan.hold_frame_count);
  if (held >= plan.frames.size()) {
    root.at("hold_frame_count")
        .refuse(
            fmt::format("{} found; expected less than the {} frames", held, plan.frames.size()));
  }
  for (std::size_t k = plan.frames.size() - held; k < plan.frames.size(); ++k) {
    if (plan.frames[k].setpoint_kpa != plan.frames[k - 1].setpoint_kpa) {
      root.at("frames").refuse(
          fmt::format("frame {} moves; the last {} frames should hold still", k, held));
    }
  }
  if (plan.waypoints_kpa.size() < 1 ||
      plan.waypoints_kpa.front() != plan.frames.front().setpoint_kpa ||
      plan.waypoints_kpa.back() != plan.frames.back().setpoint_kpa) {
    root.at("waypoints_kpa").refuse("expected the first and last frame's set points at its ends");
  }
}

/// Hash of everything in the file but the certificate itself; layout and order do not matter.
std::string seal_of(const Json& root) {
  nlohmann::json sorted = root;
  sorted.erase("certificate");
  return content_hash(sorted.dump());
}

/// NaN and infinities have no JSON; null says "no obstacles".
Json clearance_to_json(double clearance_m) {
  return std::isfinite(clearance_m) ? Json(clearance_m) : Json(nullptr);
}

double read_clearance(const Field& field) {
  return field.is_null() ? std::numeric_limits<double>::infinity() : field.number();
}

std::optional<CertifiedFigures> read_certificate(const Field& root, const Json& json) {
  if (!json.contains("certificate")) {
    return std::nullopt;
  }
  const Field field = root.at("certificate");
  CertifiedFigures figures;
  figures.clearance_m = read_clearance(field.at("clearance_m"));
  figures.largest_deviation_m = field.at("largest_deviation_m").number(0.0);
  figures.seal_is_intact = field.at("seal").text() == seal_of(json);
  return figures;
}

Plan read_fields(const Field& root) {
  Plan plan;
  plan.program_version = root.at("program_version").text();
  plan.arm_name = root.at("arm").at("name").text();
  plan.arm_hash = root.at("arm").at("hash").text();
  plan.model = root.at("model").at("kind").text();
  plan.model_hash = root.at("model").at("hash").text();
  if (plan.model != "no_load" && plan.model != "network") {
    root.at("model").at("kind").refuse(
        fmt::format("'{}' found; expected no_load or network", plan.model));
  }
  plan.environment_name = root.at("environment").at("name").text();
  plan.environment_hash = root.at("environment").at("hash").text();
  plan.planner = root.at("planner").text();
  plan.seed = root.at("seed").count(std::numeric_limits<std::uint64_t>::max());
  plan.margin_m = root.at("margin_m").number(0.0);
  plan.frame_rate_hz = root.at("frame_rate_hz").number(1.0, 1000.0);
  plan.cost_kpa = root.at("cost_kpa").number(0.0);
  plan.clearance_m = read_clearance(root.at("clearance_m"));
  plan.goal_distance_m = root.at("goal_distance_m").number(0.0);
  plan.goal_orientation_rad = root.at("goal_orientation_rad").number(0.0);
  plan.hold_frame_count = static_cast<int>(root.at("hold_frame_count").count(1000000));
  plan.frames = read_frames(root.at("frames"));
  const Eigen::Index segments = plan.frames.front().setpoint_kpa.size();
  for (const Field& point : root.at("waypoints_kpa").elements("a list of configurations")) {
    plan.waypoints_kpa.push_back(point.vector(segments, "pressures in kPa"));
  }
  return plan;
}

Json parse_file(const std::filesystem::path& path) {
  try {
    return Json::parse(read_file(path));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: not valid JSON: {}", path.string(), error.what()));
  }
}

Plan read_root(const Field& fields, const Json& root) {
  const std::string schema = fields.at("schema").text();
  if (schema != kSchema) {
    fields.at("schema").refuse(fmt::format("'{}' found; this program reads '{}'", schema, kSchema));
  }
  Plan plan = read_fields(fields);
  plan.certified = read_certificate(fields, root);
  return plan;
}

}  // namespace

void write_plan(const std::filesystem::path& path, const Plan& plan) {
  Json root;
  root["schema"] = kSchema;
  root["program_version"] = plan.program_version.empty() ? version() : plan.program_version;
  root["arm"] = {{"name", plan.arm_name}, {"hash", plan.arm_hash}};
  root["model"] = {{"kind", plan.model}, {"hash", plan.model_hash}};
  root["environment"] = {{"name", plan.environment_name}, {"hash", plan.environment_hash}};
  root["planner"] = plan.planner;
  root["seed"] = plan.seed;
  root["margin_m"] = plan.margin_m;
  root["frame_rate_hz"] = plan.frame_rate_hz;
  root["cost_kpa"] = plan.cost_kpa;
  root["clearance_m"] = clearance_to_json(plan.clearance_m);
  root["goal_distance_m"] = plan.goal_distance_m;
  root["goal_orientation_rad"] = plan.goal_orientation_rad;
  root["hold_frame_count"] = plan.hold_frame_count;
  Json waypoints = Json::array();
  for (const Pressures& q : plan.waypoints_kpa) {
    waypoints.push_back(numbers(q));
  }
  Json frames = Json::array();
  for (const PlanFrame& frame : plan.frames) {
    frames.push_back(
        {{"setpoint_kpa", numbers(frame.setpoint_kpa)}, {"backbone", poses(frame.backbone)}});
  }
  if (plan.certified) {
    Json sealed = root;
    sealed["waypoints_kpa"] = waypoints;
    sealed["frames"] = frames;
    root["certificate"] = {{"clearance_m", clearance_to_json(plan.certified->clearance_m)},
                           {"largest_deviation_m", plan.certified->largest_deviation_m},
                           {"seal", seal_of(sealed)}};
  }
  write_file_atomically(path, one_line_an_entry(root, waypoints, frames));
}

Plan read_plan(const std::filesystem::path& path) {
  const Json root = parse_file(path);
  const Field fields(root, path.string(), "");
  Plan plan = read_root(fields, root);
  require_consistent(fields, plan);
  if (plan.certified && !plan.certified->seal_is_intact) {
    fields.at("certificate")
        .refuse(
            "the plan was changed since it was certified; 'limber verify' says whether it "
            "still holds: plan again, or remove the key 'certificate' to use it all the same");
  }
  return plan;
}

Plan read_plan_unjudged(const std::filesystem::path& path) {
  const Json root = parse_file(path);
  return read_root(Field(root, path.string(), ""), root);
}

void write_backbones_csv(const std::filesystem::path& path, const Plan& plan) {
  std::string text = "time_s";
  const Eigen::Index m = plan.frames.empty() ? 0 : plan.frames.front().backbone.rows();
  for (Eigen::Index p = 0; p < m; ++p) {
    text += fmt::format(",x_{0}_m,y_{0}_m,theta_{0}_rad", p);
  }
  text += '\n';
  for (std::size_t k = 0; k < plan.frames.size(); ++k) {
    text += fmt::format("{}", static_cast<double>(k) / plan.frame_rate_hz);
    for (const auto& pose : plan.frames[k].backbone.rowwise()) {
      text += fmt::format(",{},{},{}", pose[0], pose[1], pose[2]);
    }
    text += '\n';
  }
  write_file_atomically(path, text);
}

}  // namespace limber
