#pragma once

#include <nlohmann/json.hpp>

#include "limber/common/json.hpp"
#include "limber/network/compensation_model.hpp"

namespace limber {

/// How many numbers e tell arms of the model's family apart, those of the model's own arm, and what
/// e tells of physics (docs/studio_api.md).
Json family_to_json(const CompensationModel& model);

}  // namespace limber
