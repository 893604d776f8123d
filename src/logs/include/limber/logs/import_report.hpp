#pragma once
// For those who read or write recordings.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
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

/// What was wrong with a body's rotation, of an arm in space.
struct SpaceFlips {
  std::string point;
  int plate = 0;
  std::int64_t hidden_rows = 0;  ///< single rows, not tracked now
  std::int64_t turned_rows = 0;  ///< rows of jumps that last, turned back to what most rows show
  std::int64_t kinds = 0;        ///< of such jumps
  std::int64_t jumps = 0;        ///< of 6 to 30 degrees that last: left as they are
  double first_s = 0.0;          ///< on the log's clock
  double largest_rad = 0.0;
};

/// What an arm in space measures from one point to the next.
struct SpaceGapReport {
  int from = 0;  ///< plates
  int to = 0;
  double arm_m = 0.0;        ///< the arm file's length at rest
  double length_m = 0.0;     ///< along the arc, in the median row
  double shortest_m = 0.0;   ///< 5 % of the rows are shorter,
  double longest_m = 0.0;    ///< 5 % longer
  double off_arc_rad = 0.0;  ///< of a measured rotation off the arc's, in the median row
};

/// How far one plate gets.
struct SpacePlateReport {
  int plate = 0;
  double strays_m = 0.0;  ///< 95 % of its distances from its median place
};

/// One log of an arm in space.
struct SpaceRunReport {
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();   ///< of frame B in the log's
  Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX();  ///< along the straight arm
  Eigen::Vector3d y_axis = Eigen::Vector3d::UnitY();
  bool y_chosen = false;      ///< any perpendicular: the mapping names none
  bool base_tracked = false;  ///< otherwise its place is the mapping's
  double base_scatter_m = 0.0;
  bool lifted = false;  ///< rotations are made from positions
  std::vector<SpaceGapReport> gaps;
  std::vector<SpacePlateReport> plates;
  std::vector<SpaceFlips> flips;
  std::int64_t repeated_rows = 0;
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
  std::optional<SpaceRunReport> space;  ///< in place of base and length_ratio
  std::optional<ClockReport> clock;     ///< none if pressures come on the motion log's clock
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

/// The base that logs share: the arm stood there in all of them.
struct LogsBase {
  std::string alignment;      ///< what a mapping of later logs says of it
  int logs = 0;               ///< that get it; the others' bases are elsewhere
  double most_off_m = 0.0;    ///< of what one of them says alone
  double most_off_rad = 0.0;  ///< the same of where the arm points
};

/// Everything that an import did to its logs.
struct ImportReport {
  std::vector<RunReport> runs;
  std::optional<LogsBase> base;       ///< none: each log has its own
  std::vector<SegmentCheck> columns;  ///< one for each segment, base first
  /// The simple model's error in every episode, in the recording's order; none where nothing was
  /// tracked.
  std::optional<EpisodeErrors> episode_errors;

  /// Of one number over all runs.
  std::int64_t sum(std::int64_t RunReport::*number) const;
};

nlohmann::ordered_json to_json(const ImportReport& report);
std::string to_text(const ImportReport& report);

}  // namespace limber
