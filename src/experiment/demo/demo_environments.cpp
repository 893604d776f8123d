#include "demo_environments.hpp"

#include <fmt/format.h>

#include "limber/common/data_folder.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/trial/proven_environment.hpp"

namespace limber {

namespace {

constexpr std::uint64_t kEnvironmentSeed = 64;
constexpr const char* kPaperArm = "three_segment";

}  // namespace

std::vector<EnvironmentCase> own_environments(const ArmDescription& arm) {
  return arm.name == kPaperArm ? environments_in(data_folder() / "environments", arm)
                               : std::vector<EnvironmentCase>{};
}

std::vector<EnvironmentCase> random_environments(const DemoResults& results, int count) {
  std::vector<EnvironmentCase> cases;
  for (int k = 1; k <= count; ++k) {
    throw_if_interrupted();
    std::optional<Environment> sampled = sample_proven_environment(
        results.arm(), results.motion_model(*results.network),
        derived_seed(results.settings->seed, kEnvironmentSeed), std::uint64_t(k));
    if (!sampled) {
      throw InputError(fmt::format(
          "arm '{}': no random environment was found in which it has to go around an obstacle",
          results.arm().name));
    }
    cases.push_back({fmt::format("random_{}", k), std::move(*sampled)});
  }
  return cases;
}

}  // namespace limber
