#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/run/track_run.hpp"

namespace limber {

/// Keys of `execute --track --json` (docs/tracking.md).
nlohmann::ordered_json to_json(const TrackRun& run);
std::string to_text(const TrackRun& run);

/// The path wanted, the tip's own, and the distance between them over time, as an SVG file's text.
std::string track_picture(const TrackRun& run);

}  // namespace limber
