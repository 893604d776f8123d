#include "demo_environments.hpp"

#include <algorithm>
#include <filesystem>

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
  std::vector<EnvironmentCase> cases;
  if (arm.name != kPaperArm) {
    return cases;
  }
  for (const auto& entry : std::filesystem::directory_iterator(data_folder() / "environments")) {
    if (entry.path().extension() == ".yaml") {
      cases.push_back({entry.path().stem().string(), load_environment(entry.path(), arm)});
    }
  }
  std::sort(cases.begin(), cases.end(),
            [](const EnvironmentCase& a, const EnvironmentCase& b) { return a.id < b.id; });
  return cases;
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
