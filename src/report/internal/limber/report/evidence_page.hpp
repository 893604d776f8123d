#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace limber {

/// Page about a tube's calibration. @param evidence  as evidence.json holds it (docs/tube.md)
std::string evidence_page(const nlohmann::ordered_json& evidence);

}  // namespace limber
