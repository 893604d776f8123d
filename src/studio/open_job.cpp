#include "experiment_folder.hpp"
#include "jobs.hpp"
#include "limber/common/json.hpp"
#include "scene_json.hpp"

namespace limber {

void run_open_job(const OpenJob& job, const ProjectFolder& project, EventQueue& events,
                  const std::function<void(FoundPlan)>& found) {
  ExperimentFolder::Run run = ExperimentFolder(project, job.folder).run(job.run);
  const ArmDescription arm = load_arm(project.find(ProjectItem::arm, run.scene.arm));
  Environment environment =
      load_environment(project.find(ProjectItem::environment, run.environment), arm);
  Json json = {{"request", job.request},
               {"arm", run.scene.arm},
               {"model", run.scene.model},
               {"environment", run.environment}};
  json["plan"] = plan_to_json(run.plan);
  json["plan"]["request"] = job.request;
  found({run.scene, std::move(environment), std::move(run.plan)});
  events.push("opened", json.dump());
}

}  // namespace limber
