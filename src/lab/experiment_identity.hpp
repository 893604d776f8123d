#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/lab/planning_experiment.hpp"

namespace limber {

/// What has to be the same for trials of two runs to be in one table. The number of trials may
/// differ: more can be added.
nlohmann::ordered_json experiment_identity(const ExperimentSettings& settings,
                                           const std::string& model_hash);

/// @throws InputError naming the first key of `file` in which it differs from `wanted`.
void require_same_experiment(const std::filesystem::path& file, const nlohmann::json& wanted);

}  // namespace limber
