#include "limber/logs/log_import.hpp"

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "backbone_building.hpp"
#include "clock_match.hpp"
#include "column_check.hpp"
#include "command_check.hpp"
#include "level_correlation.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/interrupt.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/data/median_rate.hpp"
#include "limber/data/simple_model.hpp"
#include "log_clock.hpp"
#include "log_resampling.hpp"
#include "log_runs.hpp"
#include "log_table.hpp"
#include "motive_csv.hpp"
#include "motive_plates.hpp"
#include "shared_base.hpp"
#include "space_backbone.hpp"
#include "space_tracks.hpp"

namespace limber {

namespace {

void require_logs(const std::vector<fs::path>& logs) {
  refuse_if(logs.empty(),
            "no logs; expected at least one. Did the pattern that lists them match any?");
}

void require_options(const std::vector<fs::path>& logs, const ImportOptions& options) {
  refuse_if(!options.command_logs.empty() && options.command_logs.size() != logs.size(),
            "{} motion logs and {} logs of commands (--pressures); "
            "expected one for each, in the same order",
            logs.size(), options.command_logs.size());
  if (options.time_offset_s && !std::isfinite(*options.time_offset_s)) {
    throw InputError(
        fmt::format("time offset {}; expected seconds, a finite number", *options.time_offset_s));
  }
}

/// What messages call a run.
std::string name_of(const fs::path& log, const RunReport& report) {
  return log.parent_path().empty() ? report.name : (log.parent_path() / report.name).string();
}

CommandTrack shifted(CommandTrack commands, double offset_s) {
  for (double& time_s : commands.time_s) {
    time_s += offset_s;
  }
  return commands;
}

/// Says in the recording what it was made from, and how.
void describe(const std::string& kind, const std::vector<fs::path>& logs,
              const ImportMapping& mapping, ImportResult& result) {
  const auto names =
      mapped<std::string>(logs, [&](const fs::path& log) { return log.filename().string(); });
  result.recording.source = fmt::format("{} {}", kind, fmt::join(names, ", "));
  std::string clocks;
  for (const RunReport& run : result.report.runs) {
    if (run.clock) {
      clocks += fmt::format("; {}: time offset {:.4f} s {}", run.name, run.clock->offset_s,
                            run.clock->found ? "found" : "given");
    }
  }
  result.recording.settings =
      fmt::format("gaps up to {} s bridged{}", mapping.longest_gap_s, clocks);
}

/// The clocks of both logs, before anything is measured or allocated by them.
template <class Tracks>
void check_clocks(const std::string& log, const std::string& command_log,
                  const ImportMapping& mapping, const ArmDescription& arm, RunOf<Tracks>& run) {
  check_clock(log, run.time, run.points.time_s, arm);
  run.report.rate_hz = median_rate_hz(run.points.time_s);
  run.report.duration_s = run.points.time_s.back() - run.points.time_s.front();
  if (!run.one_clock) {
    if (run.commands.measured) {  // set points may be logged where they change alone
      check_clock(command_log, mapping.commands.time, run.commands.time_s, arm);
    }
    check_span(command_log, mapping.commands.time, run.commands.time_s, log, run.points.time_s);
  }
}

/// Columns of other segments or signs hide the offset, or give a wrong one. At one of the
/// candidates they then fit far better than those given do where they fit best.
void refuse_columns_behind_clocks(const std::string& log, const std::string& command_log,
                                  const ImportMapping& mapping, const ArmDescription& arm,
                                  const BackboneTrack& motion, const CommandTrack& commands,
                                  const ClockMatch& match) {
  const auto fit_at = [&](double offset_s) {
    const LevelTable levels = levels_of(motion, shifted(commands, offset_s), arm);
    return fit_columns(correlate_levels(levels, arm), arm, kDecisiveAlone);
  };
  const double given = fit_at(match.offset_s).given_evidence;
  for (const double offset_s :
       {offset_by_activity(motion, commands, arm), match.opposite_offset_s}) {
    const ColumnFit fit = fit_at(offset_s);
    if (!fit.belongs && fit.best_evidence > given + kDecisiveAlone) {
      refuse_columns(fmt::format("{} and {}, --time-offset-s {:.3f}", log, command_log, offset_s),
                     fit, with_sums_named(mapping, arm), arm);
    }
  }
}

[[noreturn]] void refuse_clocks(const std::string& log, const std::string& command_log,
                                const ArmDescription& arm, const ClockMatch& match) {
  throw InputError(fmt::format(
      "{} and {}: how far apart their clocks are can't be told from the motion for certain. The "
      "best candidate is --time-offset-s {:.3f} (correlation {:.2f}; the next best elsewhere is "
      "{:.2f}). Do they belong together? If they do, give what is to be added to the {} log's "
      "times, or record something that does not repeat itself",
      log, command_log, match.offset_s, match.correlation, match.runner_up, arm.command.name));
}

/// Adds the offset, given or found, to the commands' times.
void bring_clocks_together(const std::string& log, const std::string& command_log,
                           const ImportOptions& options, const ArmDescription& arm,
                           const BackboneTrack& motion, CommandTrack& commands, RunReport& report) {
  ClockReport clock;
  if (options.time_offset_s) {
    clock.offset_s = *options.time_offset_s;
  } else {
    const ClockMatch match = match_clocks(motion, commands, arm);
    if (!arm.is_spatial()) {
      refuse_columns_behind_clocks(log, command_log, options.mapping, arm, motion, commands, match);
    }
    if (!match.is_decisive()) {
      refuse_clocks(log, command_log, arm, match);
    }
    clock = {match.offset_s, true, match.correlation, match.lag_s, match.runner_up};
  }
  commands = shifted(std::move(commands), clock.offset_s);
  report.clock = clock;
}

/// @param levels  gets those of the run, of an arm in the plane
template <class Tracks>
std::vector<Episode> import_run(ReadRun<Tracks>& read, const ImportOptions& options,
                                const ArmDescription& arm, std::vector<LevelTable>& levels) {
  auto& [name, command_log, run, mapping] = read;
  put_in_order(name, run.points, run.report);
  const std::string& commands_from = command_log.empty() ? name : command_log;
  // On one clock the same rows would be noted twice.
  RunReport same_rows;
  put_in_order(commands_from, run.commands, run.one_clock ? same_rows : run.report);
  check_clocks(name, commands_from, options.mapping, arm, run);
  sum_commands(options.mapping, arm, run.commands, run.report);
  check_commands(commands_from, with_sums_named(options.mapping, arm), arm, run.commands,
                 run.report);
  const BackboneTrack motion =
      build_backbone(name, std::move(run.points), mapping, arm, run.report);
  if (!run.one_clock || options.time_offset_s) {
    bring_clocks_together(name, commands_from, options, arm, motion, run.commands, run.report);
  }
  if (!arm.is_spatial()) {
    levels.push_back(levels_of(motion, run.commands, arm));
  }
  std::vector<Episode> episodes =
      resample(name, motion, run.commands, arm, options.mapping.longest_gap_s, run.report);
  for (Episode& episode : episodes) {
    episode.log = run.report.name;
    episode.lifted = run.report.space && run.report.space->lifted;
  }
  return episodes;
}

/// (log, its number, options, arm) to its runs
template <class Tracks>
using RunReader = std::vector<RunOf<Tracks>>(const fs::path&, std::size_t, const ImportOptions&,
                                             const ArmDescription&);

template <class Tracks>
std::vector<ReadRun<Tracks>> read_all(const std::vector<fs::path>& logs,
                                      const ImportOptions& options, const ArmDescription& arm,
                                      RunReader<Tracks>* read_runs) {
  std::vector<ReadRun<Tracks>> runs;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    throw_if_interrupted();
    const std::string command_log =
        options.command_logs.empty() ? std::string() : options.command_logs[i].string();
    for (RunOf<Tracks>& run : read_runs(logs[i], i, options, arm)) {
      std::string name = name_of(logs[i], run.report);
      runs.push_back({std::move(name), command_log, std::move(run), options.mapping});
    }
  }
  return runs;
}

/// Reads every log again for its rate alone, so that one message says what all of them ask for.
template <class Tracks>
[[noreturn]] void refuse_all_slow_logs(const std::vector<fs::path>& logs,
                                       const ImportOptions& options, const ArmDescription& arm,
                                       RunReader<Tracks>* read_runs) {
  std::vector<std::string> names;
  std::vector<double> rates_hz;
  for (ReadRun<Tracks>& read : read_all(logs, options, arm, read_runs)) {
    RunReport unused;
    put_in_order(read.name, read.run.points, unused);
    names.push_back(read.name);
    rates_hz.push_back(median_rate_hz(read.run.points.time_s));
  }
  refuse_slow_logs(names, rates_hz, arm);
}

template <class Tracks>
ImportResult import_logs(const std::vector<fs::path>& logs, const ImportOptions& options,
                         const ArmDescription& arm, const char* kind,
                         RunReader<Tracks>* read_runs) {
  require_options(logs, options);
  std::vector<ReadRun<Tracks>> runs = read_all(logs, options, arm, read_runs);
  ImportResult result{make_recording(arm, "", 0), {}};
  result.report.base = share_base(options.mapping, arm, runs);
  std::vector<std::string> run_names;
  std::vector<LevelTable> levels;
  for (ReadRun<Tracks>& read : runs) {
    throw_if_interrupted();
    run_names.push_back(read.name);
    try {
      for (Episode& episode : import_run(read, options, arm, levels)) {
        result.recording.episodes.push_back(std::move(episode));
      }
    } catch (const SlowLog&) {
      if (logs.size() > 1) {
        refuse_all_slow_logs(logs, options, arm, read_runs);
      }
      throw;
    }
    result.report.runs.push_back(std::move(read.run.report));
  }
  if (!arm.is_spatial()) {
    check_columns(run_names, levels, with_sums_named(options.mapping, arm), arm,
                  result.report.columns);
    if (result.recording.untracked_count() < result.recording.frame_count()) {
      result.report.episode_errors = errors_of_any(arm, result.recording.episodes);
    }
  }
  describe(kind, logs, options.mapping, result);
  return result;
}

/// With default columns as the first log of commands counts them; the others are like it.
ImportOptions as_counted(const fs::path& log, ImportOptions options, const ArmDescription& arm) {
  CommandColumns& commands = options.mapping.commands;
  if (commands.setpoint_optional) {
    const fs::path& first = options.command_logs.empty() ? log : options.command_logs.front();
    commands = as_counted_in(log_columns(first, options.mapping), std::move(commands), arm);
  }
  return options;
}

template <class Tracks>
std::vector<RunOf<Tracks>> read_csv(const fs::path& log, std::size_t number,
                                    const ImportOptions& options, const ArmDescription& arm) {
  const bool inside = options.command_logs.empty();
  std::vector<RunOf<Tracks>> runs;
  if constexpr (std::is_same_v<Tracks, SpaceTracks>) {
    const ImportMapping& mapping = options.mapping;
    runs = read_runs<Tracks>(
        log, mapping, arm, inside,
        [&](WantedColumns& wanted) { want_space_points(log.string(), mapping, wanted); },
        [&](const LogTable& table, const RowGroup& group, RunReport& report) {
          return space_tracks_of(table, group, mapping, report);
        });
  } else {
    runs = read_csv_runs(log, options.mapping, arm, inside);
  }
  if (!inside) {
    refuse_if(runs.size() > 1,
              "{}: {} recordings in one log, and commands in another file; "
              "expected one recording per file",
              log.string(), runs.size());
    runs.front().commands =
        read_command_log(options.command_logs[number], options.mapping, arm, runs.front().report);
  }
  return runs;
}

template <class Tracks>
std::vector<RunOf<Tracks>> read_motive(const fs::path& log, std::size_t number,
                                       const ImportOptions& options, const ArmDescription& arm) {
  std::vector<RunOf<Tracks>> runs(1);
  RunOf<Tracks>& run = runs.front();
  const MotiveTake take = read_motive_csv(log, run.report);
  run.report.name = log.filename().string();
  run.report.rows = std::int64_t(take.time_s.size());
  run.time = {"Time (Seconds)", 1.0, "s"};
  if constexpr (std::is_same_v<Tracks, SpaceTracks>) {
    run.points = space_motive_tracks(log.string(), take, options.mapping, arm, run.report);
  } else {
    run.points = motive_points(log.string(), take, options.mapping, arm, run.report);
  }
  run.one_clock = false;
  run.commands = read_command_log(options.command_logs[number], options.mapping, arm, run.report);
  return runs;
}

}  // namespace

ImportResult import_csv(const std::vector<fs::path>& logs, const ImportOptions& asked,
                        const ArmDescription& arm) {
  require_logs(logs);
  const ImportOptions options = as_counted(logs.front(), asked, arm);
  return arm.is_spatial() ? import_logs(logs, options, arm, "csv", read_csv<SpaceTracks>)
                          : import_logs(logs, options, arm, "csv", read_csv<PointTracks>);
}

ImportResult import_motive(const std::vector<fs::path>& logs, const ImportOptions& asked,
                           const ArmDescription& arm) {
  require_logs(logs);
  if (asked.command_logs.empty()) {
    throw InputError(fmt::format(
        "{}: Motive's files hold no {}s; give the log of them with --pressures, one for each",
        logs.front().string(), arm.command.name));
  }
  const ImportOptions options = as_counted(logs.front(), asked, arm);
  return arm.is_spatial() ? import_logs(logs, options, arm, "motive", read_motive<SpaceTracks>)
                          : import_logs(logs, options, arm, "motive", read_motive<PointTracks>);
}

}  // namespace limber
