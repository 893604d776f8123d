#include "space_import.hpp"

#include <string>

#include <fmt/format.h>

#include "command_check.hpp"
#include "limber/arm/arm_description.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/data/median_rate.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"
#include "log_clock.hpp"
#include "log_resampling.hpp"
#include "log_rows.hpp"
#include "log_runs.hpp"
#include "log_table.hpp"
#include "motive_csv.hpp"
#include "motive_plates.hpp"
#include "space_backbone.hpp"
#include "space_tracks.hpp"

namespace limber {

namespace {

/// Bodies and markers of a take in the file's own axes, nothing projected.
/// @throws InputError naming what is missing, and what is there
SpaceTracks space_motive_tracks(const std::string& log, const MotiveTake& take,
                                const ImportMapping& mapping, const ArmDescription& arm,
                                RunReport& report) {
  const PlateFinder finder(log, take, report);
  const std::vector<PointSource> points =
      mapping.points.empty() ? finder.default_points(arm) : mapping.points;
  const auto rows = static_cast<Eigen::Index>(take.time_s.size());
  SpaceTracks tracks;
  tracks.time_s = take.time_s;
  tracks.poses.resize(rows, kSpacePoseSize * std::ssize(points));
  for (Eigen::Index i = 0; i < std::ssize(points); ++i) {
    const PointSource& point = points[std::size_t(i)];
    if (point.body.empty() && point.marker.empty()) {
      throw InputError(
          fmt::format("{}: the mapping names column '{}' for {}; of a Motive file expected body or "
                      "marker",
                      log, point.x, plate_name(point.plate)));
    }
    const MotiveObject& object =
        point.body.empty() ? finder.marker(point.marker) : finder.body(point.body);
    const bool has_rotation = object.rotation.size() > 0;
    tracks.names.push_back(object.name);
    tracks.plates.push_back(point.plate);
    tracks.has_rotation.push_back(has_rotation);
    const Eigen::Index first = kSpacePoseSize * i;
    tracks.poses.middleCols<3>(first) = object.position_m;
    if (has_rotation) {
      tracks.poses.middleCols<4>(first + 3) = object.rotation;
    } else {
      tracks.poses.middleCols<4>(first + 3).rowwise() = Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
    }
  }
  return tracks;
}

namespace fs = std::filesystem;

using SpaceRun = RunOf<SpaceTracks>;

std::vector<SpaceRun> read_space_runs(const fs::path& path, const ImportMapping& mapping,
                                      const ArmDescription& arm, bool with_commands) {
  return read_runs<SpaceTracks>(
      path, mapping, arm, with_commands,
      [&](WantedColumns& wanted) { want_space_points(path.string(), mapping, wanted); },
      [&](const LogTable& table, const RowGroup& group, RunReport& report) {
        return space_tracks_of(table, group, mapping, report);
      });
}

/// Commands of another file, brought to the motion log's clock.
void add_command_log(const fs::path& log, const ImportOptions& options, const ArmDescription& arm,
                     SpaceRun& run) {
  if (!options.time_offset_s) {
    throw InputError(fmt::format(
        "{}: clocks of two logs are not compared for arms in space. Give what is to be added to "
        "its times: --time-offset-s 0, where both logs have one clock",
        log.string()));
  }
  run.one_clock = false;
  run.commands = read_command_log(log, options.mapping, arm, run.report);
}

std::vector<Episode> import_space_run(const fs::path& log, const std::string& command_log,
                                      const ImportOptions& options, const ArmDescription& arm,
                                      SpaceRun& run) {
  const ImportMapping& mapping = options.mapping;
  const std::string name = name_of(log, run.report);
  const std::string& commands_from = command_log.empty() ? name : command_log;
  keep_rows(run.points, rows_in_order(name, run.points.time_s, run.report));
  RunReport same_rows;  // on one clock the same rows would be noted twice
  put_in_order(commands_from, run.commands, run.one_clock ? same_rows : run.report);
  check_clock(name, run.time, run.points.time_s, arm);
  run.report.rate_hz = median_rate_hz(run.points.time_s);
  run.report.duration_s = run.points.time_s.back() - run.points.time_s.front();
  if (!run.one_clock) {
    check_clock(command_log, mapping.commands.time, run.commands.time_s, arm);
  }
  sum_commands(mapping, arm, run.commands, run.report);
  check_commands(commands_from, with_sums_named(mapping, arm), arm, run.commands, run.report);
  if (options.time_offset_s) {
    run.commands = shifted(std::move(run.commands), *options.time_offset_s);
    run.report.clock = ClockReport{.offset_s = *options.time_offset_s};
  }
  const BackboneTrack motion =
      build_space_backbone(name, std::move(run.points), mapping, arm, run.report);
  std::vector<Episode> episodes =
      resample(name, motion, run.commands, arm, mapping.longest_gap_s, run.report);
  for (Episode& episode : episodes) {
    episode.lifted = run.report.space->lifted;
    episode.log = run.report.name;
  }
  return episodes;
}

/// @param read  (log, number) to its SpaceRuns
template <class Read>
ImportResult import_space_logs(const std::vector<fs::path>& logs, const ImportOptions& options,
                               const ArmDescription& arm, const char* kind, const Read& read) {
  require_options(logs, options);
  ImportResult result{make_recording(arm, "", 0), {}};
  for (std::size_t i = 0; i < logs.size(); ++i) {
    throw_if_interrupted();
    const std::string command_log =
        options.command_logs.empty() ? std::string() : options.command_logs[i].string();
    for (SpaceRun& run : read(logs[i], i)) {
      for (Episode& episode : import_space_run(logs[i], command_log, options, arm, run)) {
        result.recording.episodes.push_back(std::move(episode));
      }
      result.report.runs.push_back(std::move(run.report));
    }
  }
  describe(kind, logs, options.mapping, result);
  return result;
}

}  // namespace

ImportResult import_space_csv(const std::vector<fs::path>& logs, const ImportOptions& options,
                              const ArmDescription& arm) {
  return import_space_logs(logs, options, arm, "csv", [&](const fs::path& log, std::size_t i) {
    const bool inside = options.command_logs.empty();
    std::vector<SpaceRun> runs = read_space_runs(log, options.mapping, arm, inside);
    if (!inside) {
      require_one_recording(log, runs.size());
      add_command_log(options.command_logs[i], options, arm, runs.front());
    }
    return runs;
  });
}

ImportResult import_space_motive(const std::vector<fs::path>& logs, const ImportOptions& options,
                                 const ArmDescription& arm) {
  return import_space_logs(logs, options, arm, "motive", [&](const fs::path& log, std::size_t i) {
    std::vector<SpaceRun> runs(1);
    SpaceRun& run = runs.front();
    const MotiveTake take = read_motive_csv(log, run.report);
    run.report.name = log.filename().string();
    run.report.rows = static_cast<std::int64_t>(take.time_s.size());
    run.time = {"Time (Seconds)", 1.0, "s"};
    run.points = space_motive_tracks(log.string(), take, options.mapping, arm, run.report);
    add_command_log(options.command_logs[i], options, arm, run);
    return runs;
  });
}

}  // namespace limber
