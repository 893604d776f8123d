#include "limber/lab/unseen_arm.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "limber/common/data_folder.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/data/episode_slice.hpp"
#include "limber/run/collection.hpp"
#include "limber/sim/virtual_arm.hpp"

namespace limber {

std::optional<CompensationModel> own_family(const ArmDescription& arm) {
  const fs::path file = data_folder() / "families" / (arm.name + ".safetensors");
  if (std::error_code error; !fs::exists(file, error)) {
    return std::nullopt;
  }
  CompensationModel family = read_model(file);
  return family.arm_hash == arm.hash() ? std::optional(std::move(family)) : std::nullopt;
}

Episode first_seconds(const ArmDescription& arm, const Episode& run, double seconds) {
  const int frames = int(std::lround(seconds / arm.frame_period_s()));
  return slice(run, 0, std::min(frames, run.frame_count()));
}

Episode identifying_run(const ArmDescription& arm, double seconds, std::uint64_t seed,
                        std::uint64_t stream) {
  VirtualArmOptions options;
  options.seed = seed;
  options.stream = stream;
  VirtualArm driver(arm, options);
  const EpisodeSchedule schedule =
      make_schedule(arm, identifying_schedule(arm.dimension), seed + stream).front();
  return first_seconds(arm, record_episode(arm, driver, schedule, {}), seconds);
}

UnseenArm unseen_arm(const ArmDescription& arm, const CompensationModel& family,
                     const UnseenArms& of, std::uint64_t seed, std::uint64_t number,
                     bool measures_errors) {
  UnseenArm result{with_related_physics(arm, of.variation, seed, number), {}};
  AdaptationSettings settings;
  settings.weights = AdaptWeights::never;
  settings.measures_errors = measures_errors;
  settings.jobs = 1;
  result.adaptation =
      adapt(arm, family, {identifying_run(result.arm, of.seconds, seed, number)}, settings);
  return result;
}

}  // namespace limber
