#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/json.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/world/environment.hpp"
#include "project_folder.hpp"
#include "scene_json.hpp"

namespace limber {

namespace {

/// The first of `names` that the plan was made for.
/// @param require_it  throws InputError where a file is not the one
/// @param what        it is, in messages
template <class RequireIt>
std::string find_made_for(const ProjectFolder& project, ProjectItem kind,
                          const std::vector<std::string>& names, const OpenJob& job,
                          const std::string& what, const RequireIt& require_it) {
  for (const std::string& name : names) {
    throw_if_interrupted();  // a folder may have many, and large ones
    try {
      require_it(project.find(kind, name));
      return name;
    } catch (const InputError&) {  // another one, a broken one, or none
    }
  }
  throw InputError(
      fmt::format("{}: made for {}, which is not in the project folder, or has changed since: copy "
                  "its file into the folder",
                  job.plan, what));
}

/// The project's, after the one that is tried first.
std::vector<std::string> names_after(const std::string& first, const ProjectFolder& project,
                                     ProjectItem kind) {
  std::vector<std::string> names = project.names(kind);
  names.insert(names.begin(), first);
  return names;
}

SceneNames scene_of_plan(const Plan& plan, const OpenJob& job, const ProjectFolder& project) {
  SceneNames names;
  names.arm = find_made_for(
      project, ProjectItem::arm, names_after(job.scene.arm, project, ProjectItem::arm), job,
      fmt::format("arm '{}' (hash {})", plan.arm_name, plan.arm_hash),
      [&](const fs::path& file) { require_plan_of(plan, load_arm(file), job.plan); });
  if (plan.model == "network") {
    names.model = find_made_for(
        project, ProjectItem::model, names_after(job.scene.model, project, ProjectItem::model), job,
        fmt::format("a network (hash {})", plan.model_hash), [&](const fs::path& file) {
          refuse_if(file_hash(file) != plan.model_hash, "another network");
        });
  }
  return names;
}

/// None, the scene's, or those of a network of the project: `limber experiment` makes plans of the
/// no-load model with them too.
ValveParameters valves_of_plan(const Plan& plan, const StudioScene& scene, const OpenJob& job,
                               const ProjectFolder& project) {
  if (plan.valves_hash.empty()) {
    return {};  // also before a network that has some, as limber verify --no-valves
  }
  ValveParameters valves = scene.motion().valves().parameters();
  if (valves.hash() != plan.valves_hash) {
    find_made_for(project, ProjectItem::model,
                  names_after(job.scene.model, project, ProjectItem::model), job,
                  fmt::format("a network with valves (hash {})", plan.valves_hash),
                  [&](const fs::path& file) {
                    valves = read_model(file).valves.value_or(ValveParameters{});
                    refuse_if(valves.hash() != plan.valves_hash, "other valves");
                  });
  }
  return valves;
}

Certificate certificate_of(const Plan& plan, const StudioScene& scene,
                           const ValveParameters& valves, const Environment& environment) {
  const CompensationModel* network = scene.network();
  std::optional<CompensationModel> followed;  // of a plan that a closed loop has made
  if (network != nullptr && plan.arm_of_family.size() > 0) {
    network = &followed.emplace(model_of_followed_arm(*network, plan.arm_of_family));
  }
  return certify(plan, scene.arm(), network, valves, environment);
}

/// As limber verify does: what was certified once may have been so by another limber.
void certify_again(const Plan& plan, const StudioScene& scene, const ValveParameters& valves,
                   const Environment& environment, const std::string& name) {
  Certificate certificate;
  try {
    certificate = certificate_of(plan, scene, valves, environment);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
  if (!certificate.certified()) {
    throw InputError(fmt::format("{}: its certificate fails: {}. Plan again", name,
                                 certificate.failures.front().message));
  }
}

/// Where it keeps less room than plans that the studio makes; else empty.
Json warnings_of(const Plan& plan, const StudioScene& scene) {
  const double asked_m = error_room(scene.motion().forward()).margin_m;
  double kept_m = plan.margin_m;
  if (plan.tube) {
    for (const double radius_m : plan.tube->plate_radius_m) {
      kept_m = std::max(kept_m, radius_m);
    }
  }
  Json warnings = Json::array();
  if (kept_m < asked_m) {
    warnings.push_back(
        fmt::format("it keeps {:.2f} cm from obstacles; the model's error asks for {:.2f} cm",
                    kCmPerM * kept_m, kCmPerM * asked_m));
  }
  return warnings;
}

}  // namespace

void run_open_job(const OpenJob& job, const ProjectFolder& project,
                  const std::function<const StudioScene&(const SceneNames&)>& scene_of,
                  EventQueue& events, const std::function<void(FoundPlan)>& found) {
  Plan plan = read_plan(project.find(ProjectItem::plan, job.plan));
  refuse_if(!plan.certified, "{}: the plan has no certificate", job.plan);
  const SceneNames names = scene_of_plan(plan, job, project);
  const StudioScene& scene = scene_of(names);
  scene.require_one_arm();
  scene.require_model(plan.model_hash);
  // A run writes each plan's environment beside it.
  std::vector<std::string> environments = project.names(ProjectItem::environment);
  environments.push_back(fs::path(job.plan).replace_extension(".yaml").generic_string());
  std::optional<Environment> environment;
  const std::string environment_name = find_made_for(
      project, ProjectItem::environment, environments, job,
      fmt::format("environment '{}' (hash {})", plan.environment_name, plan.environment_hash),
      [&](const fs::path& file) {
        environment = load_environment(file, scene.arm());
        require_plan_in(plan, *environment, job.plan);
      });
  certify_again(plan, scene, valves_of_plan(plan, scene, job, project), *environment, job.plan);
  Json json = {{"request", job.request},
               {"arm", names.arm},
               {"model", names.model},
               {"environment", environment_name}};
  json["plan"] = plan_to_json(plan);
  json["plan"]["request"] = job.request;
  json["plan"]["warnings"] = warnings_of(plan, scene);
  found({job.request, names, *std::move(environment), std::move(plan)});
  events.push("opened", json.dump());
}

}  // namespace limber
