#pragma once
// For those who check plans.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/certificate/certificate.hpp"

namespace limber {

/// The object of `limber verify --json`.
nlohmann::ordered_json to_json(const Certificate& certificate, const Command& command,
                               const Environment& environment);
/// The same in a few lines for people.
std::string to_text(const Certificate& certificate, const ArmDescription& arm,
                    const Environment& environment);

}  // namespace limber
