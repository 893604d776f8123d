#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/logs/import_mapping.hpp"
#include "limber/logs/import_report.hpp"

namespace limber {

/// Columns of a text log as numbers.
struct LogTable {
  std::string file;
  std::vector<std::vector<double>> columns;  ///< as asked for; NaN if a cell is empty
  std::vector<std::size_t> lines;            ///< of each row, for messages
  std::vector<std::string> labels;           ///< of each row; empty if none was asked for

  std::size_t row_count() const { return lines.size(); }
};

/// Columns of a log by name; "-name" is the column "name" with its sign turned,
/// and "" is the number of the row, from 0.
struct WantedColumns {
  std::vector<std::string> names;
  std::string label;                  ///< a column of texts; empty for none
  std::vector<std::string> optional;  ///< all or none of them; NaN columns where they are missing
};

/// Reads the wanted columns: `names`, then `optional`. A row with a missing cell or a text where a
/// number belongs is left out and noted; more than one row in a hundred is refused.
/// @throws InputError naming file, line and column.
LogTable read_log_table(const fs::path& path, const ImportMapping& mapping,
                        const WantedColumns& wanted, RunReport& report);

/// More than one row in a hundred, and more than three.
bool are_too_many(std::size_t bad_rows, std::size_t rows);

/// Names of the columns of a log. @throws InputError as above.
std::vector<std::string> log_columns(const fs::path& path, const ImportMapping& mapping);

}  // namespace limber
