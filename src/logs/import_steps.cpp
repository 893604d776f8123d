#include "import_steps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/arm/names.hpp"
#include "limber/common/error.hpp"

namespace limber {

void require_logs(const std::vector<std::filesystem::path>& logs) {
  if (logs.empty()) {
    throw InputError("no logs; expected at least one. Did the pattern that lists them match any?");
  }
}

void require_options(const std::vector<std::filesystem::path>& logs, const ImportOptions& options) {
  if (!options.command_logs.empty() && options.command_logs.size() != logs.size()) {
    throw InputError(
        fmt::format("{} motion logs and {} logs of commands (--pressures); "
                    "expected one for each, in the same order",
                    logs.size(), options.command_logs.size()));
  }
  if (options.time_offset_s && !std::isfinite(*options.time_offset_s)) {
    throw InputError(
        fmt::format("time offset {}; expected seconds, a finite number", *options.time_offset_s));
  }
}

void require_one_recording(const std::filesystem::path& log, std::size_t found) {
  if (found > 1) {
    throw InputError(
        fmt::format("{}: {} recordings in one log, and commands in another file; "
                    "expected one recording per file",
                    log.string(), found));
  }
}

std::string name_of(const std::filesystem::path& log, const RunReport& report) {
  return log.parent_path().empty() ? report.name : (log.parent_path() / report.name).string();
}

void note_point(const std::string& log, const std::string& name, int plate, Eigen::Index missing,
                Eigen::Index rows, RunReport& report) {
  report.points.push_back({name, plate, 1.0 - double(missing) / double(rows)});
  if (missing == rows) {
    throw InputError(fmt::format(
        "{}: point '{}' ({}) is never tracked: all of its cells are empty. Leave it out of the "
        "mapping, and its plate is put between its neighbours; or track it",
        log, name, plate_name(plate)));
  }
}

void note_hidden_rows(const std::string& log, double longest_gap_s,
                      const std::vector<bool>& tracked, const std::vector<bool>& bridged,
                      RunReport& report) {
  const auto filled = std::ranges::count(bridged, true);
  const auto lost = std::ranges::count(tracked, false);
  if (filled > 0) {
    report.note(
        fmt::format("rows in which a point was missing for at most {} s and was put between "
                    "its neighbours in time (their frames count as not tracked)",
                    longest_gap_s),
        {}, filled);
  }
  if (lost > 0) {
    report.note("rows left out in which a point was missing for longer", {}, lost);
  }
  if (lost == std::ssize(tracked)) {
    throw InputError(fmt::format(
        "{}: in none of the {} rows are all points tracked, or hidden for less than {} s. Leave "
        "points that are often hidden out of the mapping",
        log, tracked.size(), longest_gap_s));
  }
}

CommandTrack shifted(CommandTrack commands, double offset_s) {
  for (double& time_s : commands.time_s) {
    time_s += offset_s;
  }
  return commands;
}

void describe(const std::string& kind, const std::vector<std::filesystem::path>& logs,
              const ImportMapping& mapping, ImportResult& result) {
  std::vector<std::string> names;
  for (const std::filesystem::path& log : logs) {
    names.push_back(log.filename().string());
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
      fmt::format("gaps up to {} s bridged{}", mapping.longest_gap_s, clocks);
}

}  // namespace limber
