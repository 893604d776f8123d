#include "limber/logs/log_import.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "backbone_building.hpp"
#include "clock_match.hpp"
#include "command_check.hpp"
#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"
#include "limber/data/median_rate.hpp"
#include "log_clock.hpp"
#include "log_resampling.hpp"
#include "log_runs.hpp"
#include "log_table.hpp"
#include "motive_csv.hpp"
#include "motive_points.hpp"

namespace limber {

namespace {

constexpr double kMinCorrelation = 0.3;  // below, the logs do not belong together
constexpr double kAmbiguous = 0.9;       // a runner-up this good could as well be the answer
constexpr double kWeakSegment = 0.2;

namespace fs = std::filesystem;

/// The clocks of both logs, before anything is measured or allocated by them.
void check_clocks(const std::string& log, const std::string& command_log,
                  const ImportMapping& mapping, const ArmDescription& arm, LogRun& run) {
  check_clock(log, run.time, run.points.time_s, arm);
  run.report.rate_hz = median_rate_hz(run.points.time_s);
  run.report.duration_s = run.points.time_s.back() - run.points.time_s.front();
  if (!run.one_clock) {
    check_clock(command_log, mapping.commands.time, run.commands.time_s, arm);
    check_span(command_log, mapping.commands.time, run.commands.time_s, log, run.points.time_s);
  }
}

[[noreturn]] void refuse_turned_signs(const std::string& log, const ArmDescription& arm,
                                      double correlation) {
  throw InputError(fmt::format(
      "{}: the arm bends to the opposite side of what its {}s say (correlation {:.2f}): positive "
      "bends {}. Put a '-' before the columns' names in the mapping, or swap right and left",
      log, arm.command.name, correlation,
      arm.no_load == NoLoadKind::curvature ? "to the side of curvature_per_unit's sign, left for +"
                                           : "right, towards -y"));
}

/// Adds the offset, given or found, to the commands' times.
void bring_clocks_together(const std::string& log, const std::string& command_log,
                           const ImportOptions& options, const ArmDescription& arm,
                           const BackboneTrack& motion, LogRun& run) {
  ClockReport clock;
  if (options.time_offset_s) {
    clock.offset_s = *options.time_offset_s;
  } else {
    const ClockMatch match = match_clocks(motion, run.commands, arm);
    if (-match.opposite > std::max(match.correlation, kMinCorrelation)) {
      refuse_turned_signs(log, arm, match.opposite);
    }
    if (match.correlation < kMinCorrelation || match.runner_up > kAmbiguous * match.correlation) {
      throw InputError(fmt::format(
          "{} and {}: how far apart their clocks are can't be told from the motion: the best "
          "correlation is {:.2f}, the next best {:.2f}. Do they belong together, and are the "
          "columns in the segments' order? Give the offset with --time-offset-s (the time to be "
          "added to the {} log's times), or record something that does not repeat itself",
          log, command_log, match.correlation, match.runner_up, arm.command.name));
    }
    clock = {match.offset_s, true, match.correlation, match.lag_s, match.runner_up};
  }
  for (double& time_s : run.commands.time_s) {
    time_s += clock.offset_s;
  }
  run.report.clock = clock;
}

void check_signs(const std::string& log, const ArmDescription& arm, const BackboneTrack& motion,
                 const CommandTrack& commands, RunReport& report) {
  const std::vector<double> correlations = segment_correlations(motion, commands, arm, 0.0);
  for (std::size_t i = 0; i < correlations.size(); ++i) {
    if (correlations[i] < -kMinCorrelation) {
      refuse_turned_signs(fmt::format("{}: {}", log, segment_name(i)), arm, correlations[i]);
    }
    if (correlations[i] < kWeakSegment) {
      report.note("a segment that hardly follows its command: is it the right column?",
                  fmt::format("{}: correlation {:.2f}", segment_name(i), correlations[i]));
    }
  }
}

std::vector<Episode> import_run(const fs::path& log, const std::string& command_log,
                                const ImportOptions& options, const ArmDescription& arm,
                                LogRun& run) {
  const std::string name =
      log.parent_path().empty() ? run.report.name : (log.parent_path() / run.report.name).string();
  put_in_order(name, run.points, run.report);
  const std::string& commands_from = command_log.empty() ? name : command_log;
  // On one clock the same rows would be noted twice.
  RunReport same_rows;
  put_in_order(commands_from, run.commands, run.one_clock ? same_rows : run.report);
  check_clocks(name, commands_from, options.mapping, arm, run);
  check_commands(commands_from, options.mapping, arm, run.commands, run.report);
  const BackboneTrack motion =
      build_backbone(name, std::move(run.points), options.mapping, arm, run.report);
  if (!run.one_clock || options.time_offset_s) {
    bring_clocks_together(name, commands_from, options, arm, motion, run);
  }
  check_signs(name, arm, motion, run.commands, run.report);
  return resample(name, motion, run.commands, arm, options.mapping.longest_gap_s, run.report);
}

void require_log_pairs(const std::vector<fs::path>& logs, const ImportOptions& options) {
  if (!options.command_logs.empty() && options.command_logs.size() != logs.size()) {
    throw InputError(fmt::format(
        "{} motion logs and {} logs of commands (--pressures); expected one for each, in the same "
        "order",
        logs.size(), options.command_logs.size()));
  }
}

template <class ReadRuns>
ImportResult import_logs(const std::vector<fs::path>& logs, const ImportOptions& options,
                         const ArmDescription& arm, const char* kind, const ReadRuns& read_runs) {
  require_log_pairs(logs, options);
  if (options.time_offset_s && !std::isfinite(*options.time_offset_s)) {
    throw InputError(
        fmt::format("time offset {}; expected seconds, a finite number", *options.time_offset_s));
  }
  ImportResult result{make_recording(arm, "", 0), {}};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const std::string command_log =
        options.command_logs.empty() ? std::string() : options.command_logs[i].string();
    names.push_back(logs[i].filename().string());
    for (LogRun& run : read_runs(logs[i], i)) {
      for (Episode& episode : import_run(logs[i], command_log, options, arm, run)) {
        result.recording.episodes.push_back(std::move(episode));
      }
      result.report.runs.push_back(std::move(run.report));
    }
  }
  result.recording.source = fmt::format("{} {}", kind, fmt::join(names, ", "));
  std::string clocks;
  for (const RunReport& run : result.report.runs) {
    if (run.clock) {
      clocks += fmt::format("; {}: time offset {:.4f} s {}", run.name, run.clock->offset_s,
                            run.clock->found ? "found" : "given");
    }
  }
  result.recording.settings =
      fmt::format("gaps up to {} s bridged{}", options.mapping.longest_gap_s, clocks);
  return result;
}

fs::path first_of(const std::vector<fs::path>& logs) {
  return logs.empty() ? fs::path() : logs.front();
}

/// With default columns as the first log of commands counts them; the others are like it.
ImportOptions as_counted(const fs::path& log, ImportOptions options, const ArmDescription& arm) {
  CommandColumns& commands = options.mapping.commands;
  if (commands.setpoint_optional && !log.empty()) {
    const fs::path& first = options.command_logs.empty() ? log : options.command_logs.front();
    commands = as_counted_in(log_columns(first, options.mapping), std::move(commands), arm);
  }
  return options;
}

}  // namespace

ImportResult import_csv(const std::vector<fs::path>& logs, const ImportOptions& asked,
                        const ArmDescription& arm) {
  const ImportOptions options = as_counted(first_of(logs), asked, arm);
  return import_logs(logs, options, arm, "csv", [&](const fs::path& log, std::size_t i) {
    const bool inside = options.command_logs.empty();
    std::vector<LogRun> runs = read_csv_runs(log, options.mapping, arm, inside);
    if (!inside && runs.size() > 1) {
      throw InputError(
          fmt::format("{}: {} recordings in one log, and commands in another file; "
                      "expected one recording per file",
                      log.string(), runs.size()));
    }
    if (!inside) {
      runs.front().commands =
          read_command_log(options.command_logs[i], options.mapping, arm, runs.front().report);
    }
    return runs;
  });
}

ImportResult import_motive(const std::vector<fs::path>& logs, const ImportOptions& asked,
                           const ArmDescription& arm) {
  if (asked.command_logs.empty()) {
    throw InputError(fmt::format(
        "{}: Motive's files hold no {}s; give the log of them with --pressures, one for each",
        logs.front().string(), arm.command.name));
  }
  const ImportOptions options = as_counted(first_of(logs), asked, arm);
  return import_logs(logs, options, arm, "motive", [&](const fs::path& log, std::size_t i) {
    std::vector<LogRun> runs(1);
    LogRun& run = runs.front();
    const MotiveTake take = read_motive_csv(log, run.report);
    run.report.name = log.filename().string();
    run.report.rows = static_cast<std::int64_t>(take.time_s.size());
    run.time = {"Time (Seconds)", 1.0, "s"};
    run.points = motive_points(log.string(), take, options.mapping, arm, run.report);
    run.one_clock = false;
    run.commands = read_command_log(options.command_logs[i], options.mapping, arm, run.report);
    return runs;
  });
}

}  // namespace limber
