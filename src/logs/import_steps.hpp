#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/logs/log_import.hpp"
#include "log_rows.hpp"

// What imports of arms in the plane and in space do in the same way.
namespace limber {

/// @throws InputError where there is none
void require_logs(const std::vector<std::filesystem::path>& logs);

/// @throws InputError where logs of commands are not as many as motion logs, or the offset is no
/// number
void require_options(const std::vector<std::filesystem::path>& logs, const ImportOptions& options);

/// Of a log whose commands are in a file of their own. @throws InputError where it holds several
void require_one_recording(const std::filesystem::path& log, std::size_t found);

/// What messages call a run.
std::string name_of(const std::filesystem::path& log, const RunReport& report);

/// Has rows of one point that are hidden for at most `longest_gap_s` bridged, and marks these and
/// the lost ones.
/// @param is_tracked  of a row; `bridge`: (row before, row behind) puts rows between these two
/// @return rows in which it was missing
template <class IsTracked, class Bridge>
Eigen::Index bridge_hidden_rows(const std::vector<double>& time_s, double longest_gap_s,
                                const IsTracked& is_tracked, const Bridge& bridge,
                                std::vector<bool>& tracked, std::vector<bool>& bridged) {
  const auto rows = static_cast<Eigen::Index>(time_s.size());
  Eigen::Index missing = 0;
  Eigen::Index before = -1;
  for (Eigen::Index t = 0; t <= rows; ++t) {
    if (t < rows && !is_tracked(t)) {
      ++missing;
      continue;
    }
    const bool is_short = before >= 0 && t < rows &&
                          time_s[std::size_t(t)] - time_s[std::size_t(before)] <= longest_gap_s;
    if (is_short) {
      bridge(before, t);
    }
    for (Eigen::Index gap = before + 1; gap < t; ++gap) {
      (is_short ? bridged : tracked)[std::size_t(gap)] = is_short;
    }
    before = t;
  }
  return missing;
}

/// Adds how often a point was tracked. @param missing  of `rows`
/// @throws InputError where it never was
void note_point(const std::string& log, const std::string& name, int plate, Eigen::Index missing,
                Eigen::Index rows, RunReport& report);

/// Says how many rows were bridged, and how many are lost. @throws InputError where all are
void note_hidden_rows(const std::string& log, double longest_gap_s,
                      const std::vector<bool>& tracked, const std::vector<bool>& bridged,
                      RunReport& report);

CommandTrack shifted(CommandTrack commands, double offset_s);

/// Says in the recording what it was made from, and how.
void describe(const std::string& kind, const std::vector<std::filesystem::path>& logs,
              const ImportMapping& mapping, ImportResult& result);

}  // namespace limber
