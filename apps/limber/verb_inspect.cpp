#include <cmath>
#include <optional>

#include <fmt/ranges.h>

#include "inspect_arm.hpp"
#include "limber/arm/arm_identity.hpp"
#include "limber/arm/names.hpp"
#include "limber/arm/no_load_model.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/arm/valve_parameters.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/yaml_reader.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/planning/forest.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

Finding inspect_recording(const std::string& file, const std::optional<ArmDescription>& arm) {
  const Recording recording = read_recording(file);
  const RecordingInspection inspection = inspect(recording, arm ? &*arm : nullptr, file);
  return {to_json(recording, inspection), to_text(recording, inspection)};
}

Finding inspect_environment(const YamlReader& root, const std::optional<ArmDescription>& arm) {
  const Environment environment = arm ? read_environment(root, *arm) : read_environment(root);
  Finding finding;
  finding.json = {{"kind", "environment"},
                  {"name", environment.name},
                  {"hash", environment_hash(environment)},
                  {"start", environment.start ? "given" : "rest"},
                  {"obstacles", Json::array()}};
  for (const Obstacle& obstacle : environment.obstacles) {
    finding.json["obstacles"].push_back(obstacle_kind(obstacle));
  }
  const PoseGoal& goal = environment.goal;
  finding.json["goal"] = {
      {"x_m", goal.x_m}, {"y_m", goal.y_m}, {"position_tolerance_m", goal.position_tolerance_m}};
  finding.text = fmt::format(
      "environment '{}', hash {}\n  {} obstacles{}; "
      "start {}\n  goal ({:.3f}, {:.3f}) m within {} m",
      environment.name, environment_hash(environment), environment.obstacles.size(),
      environment.obstacles.empty()
          ? ""
          : fmt::format(": {}",
                        fmt::join(finding.json["obstacles"].get<std::vector<std::string>>(), ", ")),
      environment.start ? "given" : "at rest", goal.x_m, goal.y_m, goal.position_tolerance_m);
  if (goal.theta_rad) {
    finding.json["goal"]["theta_rad"] = *goal.theta_rad;
    finding.json["goal"]["orientation_tolerance_rad"] = goal.orientation_tolerance_rad;
    finding.text +=
        fmt::format(", {:.3f} rad within {} rad", *goal.theta_rad, goal.orientation_tolerance_rad);
  }
  return finding;
}

Finding inspect_valves(const YamlReader& root, const std::optional<ArmDescription>& arm,
                       const std::string& file) {
  const IdentifiedValves valves = read_valves(root);
  if (arm) {
    const std::string fault = why_unusable(valves.parameters, *arm);
    if (!fault.empty()) {
      throw InputError(file + ": " + fault);
    }
  }
  Finding finding;
  finding.json = {{"kind", "valves"}, {"hash", valves.parameters.hash()}};
  finding.json.update(to_json(valves));
  finding.text = fmt::format(
      "{}\n  from {}, hash {}",
      arm ? to_text(valves, arm->command.unit, arm->dimension) : to_text(valves),
      valves.findings.source.empty() ? "a source that is not stored" : valves.findings.source,
      valves.parameters.hash());
  for (const std::string& warning : valves.findings.warnings) {
    finding.text += "\n  warning: " + warning;
  }
  return finding;
}

Finding inspect_yaml(const std::string& file, const std::string& content,
                     const std::optional<ArmDescription>& arm) {
  refuse_if(
      content.find("schema") == std::string::npos,
      "{}: not a limber file; expected a recording (HDF5), a model or forest (safetensors), "
      "a plan (JSON), or an arm, an environment or valves (YAML with a line 'schema: limber/…')",
      file);
  const YamlReader root = YamlReader::from_file(file);
  const YamlReader schema = root.at("schema");
  if (schema.text() == "limber/arm/1") {
    const std::string why =
        arm ? why_another_arm(identity_of(read_arm(root)), *arm, file) : std::string();
    if (!why.empty()) {
      throw InputError(fmt::format("{}: not the arm of --arm, '{}': {}", file, arm->name, why));
    }
    return inspect_arm(root);
  }
  if (schema.text() == "limber/environment/1") {
    return inspect_environment(root, arm);
  }
  if (schema.text() == "limber/valves/1") {
    return inspect_valves(root, arm, file);
  }
  schema.refuse(
      fmt::format("{} found; this program reads 'limber/arm/1', "
                  "'limber/environment/1' and 'limber/valves/1' as YAML",
                  schema.found()));
}

/// What the model's arm is driven by; files of before it was kept are of pressures.
Command command_of(const CompensationModel& model) {
  return model.arm_description.empty()
             ? Command{}
             : read_arm_keys(model.arm_description, "the model's arm").command;
}

/// How large the model's error is, and what its recordings held.
void add_what_is_known(const CompensationModel& model, Finding& finding) {
  const auto add = [&](const char* key, const auto& known, const char* where_it_is_not) {
    if (known) {
      finding.json[key] = to_json(*known);
    }
    finding.text += known ? "\n  " + to_text(*known) : where_it_is_not;
  };
  add("prediction_error", model.prediction_error, "\n  error on unseen motions: not measured");
  add("tube", model.tube, "");
  if (model.learnt) {
    const Command command = command_of(model);
    finding.json["learnt"] = to_json(*model.learnt, command);
    finding.text += "\n  trained on";
    for (const std::string& line : learnt_region_lines(*model.learnt, command)) {
      finding.text += "\n    " + line;
    }
  } else {
    finding.text += "\n  what it was trained on is not stored";
  }
  add("bounds", model.bounds, "\n  no bounds: plan refuses it, and says how to add them");
}

void add_family(const CompensationModel& model, Finding& finding) {
  finding.json["family"] = nullptr;
  if (!model.family) {
    return;
  }
  finding.json["family"] = {{"size", model.family->size()}, {"arms", model.family->arms.cols()}};
  finding.text += fmt::format("\n  a family of {} arms, which {} numbers tell apart",
                              model.family->arms.cols(), model.family->size());
  if (const auto& member = model.member_of_family) {
    finding.json["family"]["hash"] = member->family_hash;
    finding.json["family"]["e"] = std::vector<float>(member->e.begin(), member->e.end());
    finding.text += fmt::format("; this is the arm ({:.2f})", fmt::join(member->e, ", "));
  }
}

Finding inspect_model(const std::string& file, const std::optional<ArmDescription>& arm) {
  const CompensationModel model = read_model(file);
  if (arm) {
    require_model_of(model, *arm, file);
  }
  const char* layout = model.layout == BackboneLayout::gap_poses ? "gap_poses" : "base_poses";
  Finding finding;
  finding.json = {{"kind", "model"},
                  {"arm", model.arm_name},
                  {"arm_hash", model.arm_hash},
                  {"preset", model.preset},
                  {"layout", layout},
                  {"reads_velocity", model.reads_velocity},
                  {"shape", model.shape()},
                  {"members", model.member_count()},
                  {"segments", model.segment_count},
                  {"points", model.point_count},
                  {"training", model.training},
                  {"learnt_from", commands_are(model.learnt_from_setpoints)},
                  {"valves", nullptr},
                  {"prediction_error", nullptr},
                  {"tube", nullptr},
                  {"learnt", nullptr},
                  {"bounds", nullptr}};
  finding.text = fmt::format("model of arm '{}' ({}), preset {}\n  {}, {}", model.arm_name,
                             model.arm_hash, model.preset, model.shape(), layout);
  if (model.reads_velocity) {
    finding.text += ", reads velocities";
  }
  if (model.member_count() > 1) {
    finding.text += fmt::format(", an ensemble of {} networks", model.member_count());
  }
  for (const auto& [key, value] : model.training) {
    finding.text += fmt::format("\n  {}: {}", key, value);
  }
  add_family(model, finding);
  if (model.learnt_from_setpoints) {
    finding.text += "\n  learnt from set points only: no valve model belongs before it";
  }
  const IdentifiedValves valves = model.identified_valves();
  if (model.valves || !valves.findings.reason.empty()) {
    finding.json["valves"] = to_json(valves);
  }
  finding.text += "\n  " + to_text(valves, command_of(model).unit, model.dimension);
  add_what_is_known(model, finding);
  return finding;
}

Finding inspect_forest(const std::string& file, const std::optional<ArmDescription>& arm) {
  const Forest forest = read_forest(file);
  const std::string why =
      arm ? why_another_arm({"", forest.key.arm_hash, forest.arm_description}, *arm, file) : "";
  if (!why.empty()) {
    throw InputError(fmt::format("{}: grown for arm {}; --arm is '{}' ({}): {}", file,
                                 forest.key.arm_hash, arm->name, arm->hash(), why));
  }
  const std::string model =
      forest.key.model_hash.empty() ? "the no-load model" : "model " + forest.key.model_hash;
  return {{{"kind", "forest"},
           {"arm_hash", forest.key.arm_hash},
           {"model_hash", forest.key.model_hash},
           {"valves_hash", forest.key.valves_hash},
           {"start_hash", forest.key.start_hash},
           {"segments", forest.setpoints_kpa.rows()},
           {"nodes", forest.size()}},
          fmt::format("forest of {} motions from start {}\n  arm {}, {}", forest.size(),
                      forest.key.start_hash, forest.key.arm_hash, model)};
}

Finding inspect_plan(const std::string& file, const std::optional<ArmDescription>& arm) {
  const Plan plan = read_plan(file);
  if (arm) {
    require_plan_of(plan, *arm, file);
  }
  Finding finding;
  finding.json = {{"kind", "plan"},
                  {"arm", plan.arm_name},
                  {"arm_hash", plan.arm_hash},
                  {"model", plan.model},
                  {"model_hash", plan.model_hash},
                  {"environment", plan.environment_name},
                  {"environment_hash", plan.environment_hash},
                  {"planner", plan.planner},
                  {"seed", plan.seed},
                  {"frames", plan.frame_count()},
                  {"waypoints", plan.waypoints_kpa.size()},
                  {"duration_s", plan.duration_s()},
                  {quantity_key(plan.command, "cost"), plan.cost_kpa},
                  {"distance_to_goal_cm", 100.0 * plan.goal_distance_m}};
  std::string within;
  for (const PressureLimits& limits : plan.limits) {
    finding.json[quantity_key(plan.command, "limits")].push_back(to_json(limits));
    within += (within.empty() ? "\n  planned within " : ", ") + to_string(limits);
  }
  std::string clearance = "no obstacles";
  finding.json["clearance_cm"] = nullptr;
  if (std::isfinite(plan.clearance_m)) {
    finding.json["clearance_cm"] = 100.0 * plan.clearance_m;
    clearance = fmt::format("clearance {:.1f} cm", 100.0 * plan.clearance_m);
  }
  finding.text = fmt::format(
      "plan for arm '{}' in '{}' by {} with the {} model, seed {}\n  {} frames ({:.1f} s), {} "
      "waypoints, {:.1f} {}; predicted: {:.1f} cm from the goal, {}{}",
      plan.arm_name, plan.environment_name, plan.planner, plan.model, plan.seed, plan.frame_count(),
      plan.duration_s(), plan.waypoints_kpa.size(), plan.cost_kpa, plan.command.unit,
      100.0 * plan.goal_distance_m, clearance,
      within.empty() ? "" : fmt::format("{} {}", within, plan.command.unit));
  finding.json["tube"] = nullptr;
  if (plan.tube) {
    finding.json["tube"] = {{"level", plan.tube->level},
                            {"plate_radius_m", plan.tube->plate_radius_m},
                            {"goal_inside", plan.tube->goal_inside}};
    finding.text += fmt::format("\n  keeps the tube of {:.4g} % of runs free, {:.2f} cm at the tip",
                                100.0 * plan.tube->level, 100.0 * plan.tube->plate_radius_m.back());
  }
  return finding;
}

Finding inspect_file(const std::string& file, const std::optional<ArmDescription>& arm) {
  switch (kind_of(file)) {
    case FileKind::recording:
      return inspect_recording(file, arm);
    case FileKind::model:
      return inspect_model(file, arm);
    case FileKind::forest:
      return inspect_forest(file, arm);
    case FileKind::plan:
      return inspect_plan(file, arm);
    default:
      return inspect_yaml(file, read_file(file), arm);
  }
}

class InspectVerb final : public Verb {
 public:
  InspectVerb()
      : Verb("inspect", "What a file holds, and what is wrong with it",
             "limber inspect three_segment") {}

  void add_flags(CLI::App& app) override {
    app.add_option("file", file_,
                   "Recording, model, forest, plan, arm, environment or valves; or the name of one "
                   "of limber's own")
        ->required();
    app.add_option("--arm", arm_, "Arm that the file has to fit; its limits are used");
  }

  int run(const CommonFlags& flags) override {
    const std::optional<ArmDescription> arm =
        arm_.empty() ? std::nullopt : std::optional(load_any_arm(arm_));
    file_ = find_any_file(file_);
    Finding finding = inspect_file(file_, arm);
    Json json = {{"file", file_}};
    json.update(finding.json);
    print_result(flags, json, file_ + ": " + finding.text);
    return kExitDone;
  }

 private:
  std::string file_;
  std::string arm_;
};

}  // namespace

std::unique_ptr<Verb> make_inspect_verb() {
  return std::make_unique<InspectVerb>();
}

}  // namespace limber
