#include "demo_environments.hpp"

#include <fmt/format.h>

#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/lab/witnessed_environment.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kEnvironmentSeed = 64;
constexpr const char* kPaperArm = "three_segment";

}  // namespace

std::vector<EnvironmentCase> own_environments(const ArmDescription& arm) {
  return arm.name == kPaperArm ? environments_in(data_folder() / "environments", arm)
                               : std::vector<EnvironmentCase>{};
}

std::vector<EnvironmentCase> random_environments(const ArmDescription& arm, std::uint64_t seed,
                                                 int count) {
  std::vector<EnvironmentCase> cases;
  for (int k = 1; k <= count; ++k) {
    throw_if_interrupted();
    std::optional<WitnessedEnvironment> sampled =
        witnessed_environment(arm, virtual_witness(arm), seed, std::uint64_t(k));
    if (!sampled) {
      throw InputError(
          fmt::format("arm '{}': its tip comes nowhere in a hundred random motions", arm.name));
    }
    cases.push_back({fmt::format("random_{}", k), std::move(sampled->environment)});
  }
  return cases;
}

std::vector<EnvironmentCase> random_environments(const DemoResults& results, int count) {
  return random_environments(results.arm(), derived_seed(results.settings->seed, kEnvironmentSeed),
                             count);
}

}  // namespace limber
