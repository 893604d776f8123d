#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "limber/arm/backbone.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// What one log says of where the base is. An arm whose points have no headings leaves its base
/// along `base.theta_rad` − share · `turn_rad`, where the share is the arm's own (`base_of`).
struct BaseSighting {
  Pose base;                   ///< median position; mean heading, or direction to the next point
  double turn_rad = 0.0;       ///< mean turn at that point; 0 where headings were measured
  double arc_share = 0.0;      ///< of an arc, which bends evenly
  double rows = 0.0;           ///< of these moments about the means:
  double turn_squares = 0.0;   ///< Σ turn²
  double turn_products = 0.0;  ///< Σ turn · direction
};

/// By one log alone.
Pose base_of(const BaseSighting& sighting);

/// The base of an arm that stays bolted down from log to log: medians over those that agree, which
/// get it. Where most do not, each keeps its own.
struct SharedBase {
  struct OfLog {
    Pose base;
    bool is_shared = false;
  };
  std::optional<LogsBase> report;  ///< none: nothing is shared
  std::vector<OfLog> bases;        ///< of each log
};
SharedBase share_base(const std::vector<BaseSighting>& sightings);

nlohmann::ordered_json to_json(const LogsBase& shared);
/// A line. @param runs  all logs
std::string to_text(const LogsBase& shared, std::ptrdiff_t runs);

}  // namespace limber
