#pragma once

#include <vector>

#include "demo_stages.hpp"

namespace limber {

/// All of limber's own environments, by name; they are drawn up for the paper's arm, so none for
/// another one.
std::vector<EnvironmentCase> own_environments(const ArmDescription& arm);

/// Environments 1 to `count` of that seed about motions of that virtual arm, "random_1" and so on.
/// @throws InputError for an arm that hardly moves.
std::vector<EnvironmentCase> random_environments(const ArmDescription& arm, std::uint64_t seed,
                                                 int count);

/// Those of the run's own arm and seed.
std::vector<EnvironmentCase> random_environments(const DemoResults& results, int count);

}  // namespace limber
