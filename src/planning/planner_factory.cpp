#include "limber/planning/planner_factory.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "certified/certified_planner.hpp"
#include "limber/common/atomic_file.hpp"
#include "limber/common/content_hash.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/gap_bounds.hpp"
#include "limber/planning/forest.hpp"
#include "limber/planning/ompl_planner.hpp"
#include "paper/pressure_rrt_star.hpp"
#include "search/default_planner.hpp"

namespace limber {

namespace {

/// As published, pressures are the set points; "paper,valves=1" predicts with the valves.
std::unique_ptr<Planner> make_paper_planner(PlannerName parsed, const std::string& name, int jobs) {
  const Valves valves =
      parsed.take_whole("valves", 0, 1, 0) != 0 ? Valves::as_given : Valves::left_out;
  if (!parsed.settings.empty()) {
    throw InputError(
        fmt::format("planner setting {}: unknown; '{}' has the setting valves (0 or 1)",
                    parsed.settings.begin()->first, parsed.name));
  }
  return make_certified_planner(make_pressure_rrt_star(name), jobs, valves);
}

const LearntRegion* recorded_of(const MotionModel& model) {
  return model.has_network() && model.compensation().learnt ? &*model.compensation().learnt
                                                            : nullptr;
}

std::optional<RecordedRegion> region_to_stay_in(const ArmDescription& arm,
                                                const MotionModel& model) {
  refuse_if(recorded_of(model) == nullptr,
            "--stay-recorded: the model does not store what "
            "its recordings held; limber train stores it");
  return std::optional<RecordedRegion>(std::in_place, *recorded_of(model), arm.frame_rate_hz);
}

/// Where the plan asks for something that the model has never seen.
void warn_beyond_recordings(const ArmDescription& arm, const MotionModel& model,
                            PlanResult& result) {
  if (!result.plan || recorded_of(model) == nullptr) {
    return;
  }
  for (const std::string& excursion :
       excursions_beyond(*recorded_of(model), *result.plan, arm.command)) {
    result.warnings.push_back(excursion + "; --stay-recorded avoids this");
  }
}

/// The arm, asked to move no faster than the settings say, or than it was recorded where a plan
/// stays within that: at the arm's own rate it could not begin. A forest was grown with that rate.
ArmDescription slowed(ArmDescription arm, const PlanSettings& settings,
                      const std::optional<RecordedRegion>& region) {
  double& own = arm.pressure_rate_limit_kpa_per_s;
  if (region && !settings.rate_limit_kpa_per_s && settings.forest == nullptr) {
    own = std::min(own, region->rate_limit_kpa_per_s());
  }
  if (settings.rate_limit_kpa_per_s) {
    const double rate = *settings.rate_limit_kpa_per_s;
    refuse_if(
        !(rate > 0.0 && rate <= own),
        "a rate limit of {0} {1}/s (--rate-limit); expected more than 0, and at most the arm's "
        "{2} {1}/s",
        rate, arm.command.unit, own);
    refuse_if(settings.forest != nullptr,
              "a rate limit of its own and a forest, which was grown with the arm's");
    own = rate;
    refuse_if(arm.max_motion_frames() > kMaxMotionFrames,
              "a rate limit of {} {}/s (--rate-limit): from limit to limit takes {:.3g} frames; "
              "expected at most {:.0f}",
              rate, arm.command.unit, arm.max_motion_frames(), kMaxMotionFrames);
  }
  return arm;
}

/// Before the planner's own.
void warn_first(const std::string& warning, PlanResult& result) {
  if (!warning.empty()) {
    result.warnings.insert(result.warnings.begin(), warning);
  }
}

}  // namespace

std::vector<std::string> planner_names() {
  return {"default", "paper"};
}

std::unique_ptr<Planner> make_planner(const std::string& name, int jobs, const Forest* forest) {
  PlannerName parsed = PlannerName::parse(name);
  if (parsed.name == "default") {
    DefaultPlannerSettings settings = default_settings_of(std::move(parsed));
    settings.jobs = jobs;
    settings.forest = forest;
    return make_certified_planner(make_default_planner(settings, name), jobs);
  }
  refuse_if(forest != nullptr, "planner '{}' uses no forest; only 'default' does", name);
  // The second name is of a search that tries all parents; the tree is the same, node by node.
  if (parsed.name == "paper" || parsed.name == "paper-steer-all") {
    return make_paper_planner(std::move(parsed), name, jobs);
  }
  if (name.rfind("ompl:", 0) == 0) {
    return make_certified_planner(make_ompl_planner(name), jobs);
  }
  throw InputError(fmt::format(
      "planner '{}'; expected one of {}, paper-steer-all or ompl:NAME (docs/planning.md, OMPL)",
      name, fmt::join(planner_names(), ", ")));
}

bool is_default_planner(const std::string& name) {
  return PlannerName::parse(name).name == "default";
}

PlanResult plan(const ArmDescription& asked_arm, const MotionModel& model,
                const Environment& environment, const PlannerLimits& limits, std::uint64_t seed,
                const PlanSettings& settings) {
  if (model.has_network()) {
    require_bounded(model.compensation(), "the model");
  }
  const std::optional<RecordedRegion> region =
      settings.stay_recorded ? region_to_stay_in(asked_arm, model) : std::nullopt;
  const ArmDescription arm = slowed(asked_arm, settings, region);
  const ErrorRoom room = error_room(model.forward(), settings.room);
  PlanningProblem problem = problem_with_room(arm, model, environment, room);
  problem.stay_within = region ? &*region : nullptr;
  problem.limits = settings.within;
  problem.on_plan = settings.on_plan;
  PlanResult result = make_planner(settings.planner, settings.jobs, settings.forest)
                          ->plan(problem, limits.or_default(), seed, settings.callback);
  warn_first(room.note, result);
  warn_beyond_recordings(arm, model, result);
  return result;
}

PlanResult plan(const ArmDescription& arm, const CompensationModel& network,
                const Environment& environment, const PlannerLimits& limits, std::uint64_t seed,
                const PlanSettings& settings) {
  const ForwardModel forward(arm, network);
  const MotionModel model(forward, ValveModel(arm, network.valves.value_or(ValveParameters{})));
  PlanResult result = plan(arm, model, environment, limits, seed, settings);
  warn_first(why_valves_are_missing(model), result);
  return result;
}

PlanResult plan(const ArmDescription& arm, const fs::path& model_file,
                const Environment& environment, const PlannerLimits& limits, std::uint64_t seed,
                const PlanSettings& settings) {
  const CompensationModel network = read_model_of_one_arm(model_file, arm);
  require_bounded(network, model_file.string());
  PlanResult result = plan(arm, network, environment, limits, seed, settings);
  if (result.plan) {
    result.plan->model_hash = file_hash(model_file);
  }
  return result;
}

}  // namespace limber
