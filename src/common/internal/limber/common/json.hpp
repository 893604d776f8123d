#pragma once

#include <nlohmann/json_fwd.hpp>

namespace limber {

/// What limber writes: its keys stay in the order in which they were set.
using Json = nlohmann::ordered_json;

}  // namespace limber
