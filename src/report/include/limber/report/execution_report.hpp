#pragma once
// For those who show results.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/run/executor.hpp"

namespace limber {

/// The object of `limber execute --json`; lengths in cm, unknown values null.
nlohmann::ordered_json to_json(const ExecutionResult& result, const Environment& environment);

/// The same in a few lines for people.
std::string to_text(const ExecutionResult& result, const Environment& environment);

}  // namespace limber
