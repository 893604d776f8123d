#include "limber/lab/plan_schedule.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "kernels/job_arena.hpp"
#include "limber/arm/pressure_limits.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/lab/planning_experiment.hpp"
#include "limber/lab/witnessed_environment.hpp"
#include "limber/run/plan_trial.hpp"
#include "limber/run/safety_settings.hpp"

namespace limber {

namespace {

constexpr int kMaxInVain = 100;  // environments in a row without a plan
constexpr int kMaxPlans = 100'000;
// Of environments of one episode; no episode needs as many.
constexpr std::uint64_t kNumbersOfAnEpisode = std::uint64_t(kMaxInVain) * kMaxPlans;

void require_usable(const PlanScheduleSettings& settings) {
  for (const auto& [flag, found] :
       {std::pair{"--count", settings.count}, std::pair{"--episodes", settings.episodes}}) {
    refuse_if(found < 1 || found > kMaxPlans, "{} {}: expected 1 to {}", flag, found, kMaxPlans);
  }
}

/// The plan's waypoints as one motion, its hold included.
Motion motion_of(const Plan& plan) {
  Motion motion{plan.waypoints_kpa.back(), plan.hold_frame_count / plan.frame_rate_hz};
  motion.via_kpa.assign(plan.waypoints_kpa.begin() + 1, plan.waypoints_kpa.end() - 1);
  return motion;
}

/// One episode, plan after plan.
class EpisodePlanner {
 public:
  EpisodePlanner(const ArmDescription& arm, const MotionModel& model,
                 const PlanScheduleSettings& settings, std::uint64_t episode)
      : arm_(arm),
        within_(with_scaled_limits(arm, settings.limit_scale)),
        model_(model),
        settings_(settings),
        number_(episode * kNumbersOfAnEpisode) {
    trial_.limits.queries = settings.queries;
    trial_.within = limits_of(within_);
  }

  EpisodeSchedule schedule(Progress& progress) {
    EpisodeSchedule episode{Pressures::Zero(arm_.channel_count()), {}, Approach::straight};
    std::optional<ArmStart> start;
    for (int k = 0; k < settings_.count; ++k) {
      const Plan plan = next_plan(start);
      episode.motions.push_back(motion_of(plan));
      start = ArmStart{plan.waypoints_kpa.back(), plan.frames.back().backbone};
      progress.advance();
    }
    return episode;
  }

 private:
  Plan next_plan(const std::optional<ArmStart>& start) {
    std::optional<PlanStatus> last;
    for (int k = 0; k < kMaxInVain; ++k) {
      throw_if_interrupted();
      RandomEnvironmentSettings sampling;
      sampling.start = start;
      std::optional<RandomEnvironment> sampled =
          random_environment(within_, model_, settings_.seed, number_++, sampling);
      if (!sampled) {
        continue;
      }
      const EnvironmentCase item{std::to_string(number_), std::move(sampled->environment)};
      PlanTrial trial = plan_trial(arm_, model_, item, trial_, settings_.seed + number_);
      if (trial.solved()) {
        return std::move(*trial.planning.plan);
      }
      last = trial.planning.status;
    }
    refuse_if(!last,
              "--schedule plans: within {} of its limits the arm's tip comes nowhere that "
              "asks for a plan; expected a larger --limit-scale, or --schedule random",
              settings_.limit_scale);
    throw InputError(fmt::format(
        "--schedule plans: {} environments in a row have no plan (the last: {}). The "
        "model's error leaves no room beside obstacles; --max-queries asks for a longer "
        "search, --schedule random for no model",
        kMaxInVain, to_string(*last)));
  }

  const ArmDescription& arm_;
  const ArmDescription within_;  ///< with the limits that plans keep to
  const MotionModel& model_;
  const PlanScheduleSettings& settings_;
  std::uint64_t number_;  // of the next environment
  PlanTrialSettings trial_;
};

}  // namespace

std::vector<EpisodeSchedule> plan_schedule(const ArmDescription& arm, const MotionModel& model,
                                           const PlanScheduleSettings& settings) {
  require_usable(settings);
  std::vector<EpisodeSchedule> episodes(std::size_t(settings.episodes));
  Progress progress("planning", "plans",
                    std::uint64_t(settings.episodes) * std::uint64_t(settings.count),
                    settings.progress);
  JobArena arena(settings.jobs);
  arena.for_each(episodes.size(), [&](std::size_t i) {
    episodes[i] = EpisodePlanner(arm, model, settings, i).schedule(progress);
  });
  progress.finish();
  return episodes;
}

std::string describe(const PlanScheduleSettings& settings, const std::string& model_hash) {
  std::string text = fmt::format("plans, {} episodes of {}, {} queries each, model {}",
                                 settings.episodes, settings.count, settings.queries, model_hash);
  if (settings.limit_scale != 1.0) {
    text += fmt::format(", limits times {}", settings.limit_scale);
  }
  return text;
}

}  // namespace limber
