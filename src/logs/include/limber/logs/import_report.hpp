#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "limber/arm/backbone.hpp"
#include "limber/data/recording_inspection.hpp"

namespace limber {

/// Something that an import dropped, changed or found odd: how often, and where first.
struct ImportNote {
  std::string what;
  std::int64_t count = 0;
  std::string first;
};

/// How well one point was tracked.
struct PointReport {
  std::string name;
  int plate = 0;
  double tracked_share = 1.0;  ///< fraction of the log's rows
};

/// How a clock was brought to the motion log's.
struct ClockReport {
  double offset_s = 0.0;  ///< added to the pressure log's times
  bool found = false;     ///< by correlation; otherwise given
  double correlation = 0.0;
  double lag_s = 0.0;      ///< of the arm behind its commands, fitted along (clock_match.hpp)
  double runner_up = 0.0;  ///< best correlation farther than a second from there
};

/// One log, or one recording within a log.
struct RunReport {
  std::string name;
  std::int64_t rows = 0;
  double rate_hz = 0.0;
  double duration_s = 0.0;
  std::vector<PointReport> points;
  Pose base;                    ///< pose of frame B in the log's plane; zero: left as it was
  double base_scatter_m = 0.0;  ///< 95th percentile of the base's distance from where it is put
  double length_ratio = 1.0;    ///< length measured along the points over the arm file's
  std::optional<ClockReport> clock;  ///< none if pressures come on the motion log's clock
  std::vector<ImportNote> notes;
  std::int64_t episodes = 0;
  std::int64_t frames = 0;
  std::int64_t frames_not_tracked = 0;

  /// Counts a note; notes of the same `what` are joined.
  void note(const std::string& what, const std::string& first = {}, std::int64_t count = 1);
};

/// Whether a segment's column is its own, by all logs together.
struct SegmentCheck {
  double correlation = 0.0;     ///< of levels: what its column says with what it turned by
  bool follows_weakly = false;  ///< it moved often, and hardly as its column says
  std::string undecidable;      ///< why these logs can't tell; empty: they can
};

/// One for each segment, base first.
struct ColumnReport {
  std::vector<SegmentCheck> segments;
};

/// Everything that an import did to its logs.
struct ImportReport {
  std::vector<RunReport> runs;
  ColumnReport columns;
  /// The simple model's error in every episode, in the recording's order; none where nothing was
  /// tracked.
  std::optional<EpisodeErrors> episode_errors;

  std::int64_t episodes() const;
  std::int64_t frames() const;
  std::int64_t frames_not_tracked() const;
};

nlohmann::ordered_json to_json(const ImportReport& report);
std::string to_text(const ImportReport& report);

}  // namespace limber
