#pragma once

#include <nlohmann/json_fwd.hpp>

#include "limber/lab/improve.hpp"

namespace limber {

/// improve.json: everything that decides a run's results but the number of rounds.
nlohmann::ordered_json to_json(const ImproveSettings& settings, const ImproveArm& on);

/// @throws InputError naming what differs between the run in `file` and the one that is asked for.
void require_same_run(const std::filesystem::path& file, const nlohmann::ordered_json& wanted);

}  // namespace limber
