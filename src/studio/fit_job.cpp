#include <fmt/format.h>

#include "jobs.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/json.hpp"
#include "limber/common/json_number.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/units.hpp"
#include "limber/lab/unseen_arm.hpp"
#include "limber/network/arm_family.hpp"

namespace limber {

namespace {

constexpr double kMinuteS = 60.0;
constexpr std::uint64_t kSeed = 1;

/// "three_segment_fitted", or with the first number that is free.
fs::path free_file(const ProjectFolder& project, const std::string& arm) {
  fs::path file = project.to_save("models", arm + "_fitted", ".safetensors");
  for (int number = 2; fs::exists(file); ++number) {
    file = project.to_save("models", fmt::format("{}_fitted_{}", arm, number), ".safetensors");
  }
  return file;
}

}  // namespace

void run_fit_job(const FitJob& job, const ProjectFolder& project, const StudioScene& scene,
                 const std::atomic<bool>& stop, EventQueue& events) {
  refuse_if(!scene.network() || !is_family(*scene.network()),
            "'{}': no family of arms, so there is nothing to fit", job.scene.model);
  refuse_if(
      !scene.has_virtual_arm(),
      "this arm takes no pressures, so it has no virtual twin: record a minute of it, and ask "
      "'limber adapt' on the command line");
  const auto note = [&](const char* step) {
    events.push("fitting", Json{{"request", job.request}, {"step", step}}.dump());
  };
  (void)free_file(project, scene.arm().name);  // refused now, not after the work
  note("The virtual arm moves for a minute …");
  const Episode minute = identifying_run(scene.arm(), kMinuteS, kSeed, 0);
  note("The family is fitted to it …");
  AdaptationSettings settings;
  settings.weights = AdaptWeights::never;
  settings.jobs = kJobThreads;
  const Adaptation done = adapt(scene.arm(), *scene.network(), {minute}, settings);
  if (stop) {
    return;
  }
  const fs::path file = free_file(project, scene.arm().name);
  write_model(file, done.model);
  events.push("fitted", Json{{"request", job.request},
                             {"model", project.name_of(file)},
                             {"error_cm", json_number(kCmPerM * done.fitted_error_m)}}
                            .dump());
}

}  // namespace limber
