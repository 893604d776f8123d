#include "import_steps.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

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
