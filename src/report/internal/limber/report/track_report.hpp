#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "limber/run/executor.hpp"
#include "limber/run/track_errors.hpp"

namespace limber {

/// A tip path that an arm was asked to follow, and what came of it.
struct TrackRun {
  TipPath path;
  ExecutionResult result;
  int start_frame = 0;  ///< of the run, where the path's time is 0
  TrackErrors errors;
  std::uint64_t queries = 0;
};

/// Keys of `execute --track --json` (docs/tracking.md).
nlohmann::ordered_json to_json(const TrackRun& run);
std::string to_text(const TrackRun& run);

/// The path wanted, the tip's own, and the distance between them over time, as an SVG file's text.
std::string track_picture(const TrackRun& run);

}  // namespace limber
